/* openvdb POSES N SOLID OUT: the union of a solid's level sets at all poses, by OpenVDB, as a mesh.
 * SPDX-License-Identifier: CC0-1.0
 *
 * POSES is a table of poses (scene.h), SOLID an OFF of triangles, N the number of voxels along the
 * diagonal of the solid's box. Each pose of the solid is made a level set by meshToLevelSet,
 * csgUnion joins it with those before, volumeToMesh makes triangles of the whole, OUT is OFF.
 * Voxels are counted from the middle of the solid's box at the first pose, as OpenVDB's floats are.
 *
 *   c++ -std=c++17 -O2 -DNDEBUG openvdb.cpp scene.o motion.o -lopenvdb -ltbb -lyajl -lm
 */
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>
extern "C" {
#include "scene.h"
}
#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>

using openvdb::Vec3d;
using openvdb::Vec3I;
using openvdb::Vec3s;
using openvdb::Vec4I;

[[noreturn]] static void refuse(const char *what) {
    std::fprintf(stderr, "openvdb: %s\n", what);
    std::exit(2);
}

static Vec3d moved(const pose &m, const double v[3]) {
    Vec3d out;
    for (int i = 0; i < 3; i++)
        out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2] + m[i][3];
    return out;
}

static std::vector<Vec3I> triangles_of(const scene &s) {
    std::vector<Vec3I> out;
    for (int k = 0; k < s.facets; k++) {
        const int *v = s.facet[k].vertex;
        if (s.facet[k].count != 3)
            refuse("expected triangles: graze convert SOLID -o FILE.off");
        out.emplace_back(v[0], v[1], v[2]);
    }
    return out;
}

struct box {
    Vec3d low{INFINITY}, high{-INFINITY};
    void take(const Vec3d &p) {
        low = openvdb::math::minComponent(low, p);
        high = openvdb::math::maxComponent(high, p);
    }
};

/* A band of two voxels on either side is enough for the mesh: three, the default, give the same. */
static openvdb::FloatGrid::Ptr sweep(const scene &s, const pose *poses, int count, double voxel,
                                     const Vec3d &middle) {
    auto grid = openvdb::math::Transform::createLinearTransform(voxel);
    std::vector<Vec3I> triangles = triangles_of(s);
    std::vector<Vec3s> points(size_t(s.vertices));
    openvdb::FloatGrid::Ptr all;
    for (int k = 0; k < count; k++) {
        for (int v = 0; v < s.vertices; v++)
            points[size_t(v)] = Vec3s(moved(poses[k], s.vertex[v]) - middle);
        auto one =
            openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*grid, points, triangles, 2.0F);
        if (all)
            openvdb::tools::csgUnion(*all, *one);
        else
            all = one;
    }
    return all;
}

/* OpenVDB's polygons turn their inner side to the eye that sees them counterclockwise. */
static bool write(const openvdb::FloatGrid &grid, const Vec3d &middle, const char *path) {
    std::vector<Vec3s> points;
    std::vector<Vec3I> triangles;
    std::vector<Vec4I> quads;
    openvdb::tools::volumeToMesh(grid, points, triangles, quads, 0.0, 0.0);
    for (const Vec4I &q : quads) {
        triangles.emplace_back(q[0], q[1], q[2]);
        triangles.emplace_back(q[0], q[2], q[3]);
    }
    FILE *out = open_for_writing(path);
    std::fprintf(out, "OFF\n%zu %zu 0\n", points.size(), triangles.size());
    for (const Vec3s &p : points)
        std::fprintf(out, "%.17g %.17g %.17g\n", p[0] + middle[0], p[1] + middle[1],
                     p[2] + middle[2]);
    for (const Vec3I &t : triangles)
        std::fprintf(out, "3 %u %u %u\n", t[2], t[1], t[0]);
    return std::fclose(out) == 0;
}

int main(int argc, char **argv) {
    int n = argc == 5 ? std::atoi(argv[2]) : 0;
    if (n < 1)
        refuse("expected POSES N SOLID OUT, N at least 1");
    scene s;
    scene_read_solid(&s, argv[3]);
    int count;
    pose *poses = scene_read_poses(argv[1], &count);
    box rest, first;
    for (int v = 0; v < s.vertices && count > 0; v++) {
        rest.take(Vec3d(s.vertex[v]));
        first.take(moved(poses[0], s.vertex[v]));
    }
    if (s.vertices == 0 || count == 0)
        refuse("expected vertices and poses");
    Vec3d middle = (first.low + first.high) / 2;
    try {
        openvdb::initialize();
        auto all = sweep(s, poses, count, (rest.high - rest.low).length() / n, middle);
        return write(*all, middle, argv[4]) ? 0 : 1;
    } catch (const std::exception &error) {
        refuse(error.what());
    }
}
