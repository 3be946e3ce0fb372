/* igl_swept N SIGN ISOLEVEL SOLID MOTION POINTS OUT [NX NY NZ H]: libigl's swept_volume_signed_distance
 * at N evenly spread poses. SPDX-License-Identifier: CC0-1.0
 *
 * SIGN is pseudonormal, winding or fast; ISOLEVEL `inf` or a number. A number asks for the points of a grid, NX by NY
 * by NZ with edges of H, x running first: libigl fills what is far from the isolevel along it. SOLID is OFF of
 * triangles, the motion rigid. Writes x, y, z, sdf, and the seconds of the call on standard error.
 *
 *   c++ -std=c++17 -O2 -DNDEBUG -isystem IGL_INCLUDE -isystem /usr/include/eigen3 igl_swept.cpp scene.o motion.o -lyajl -lm
 */
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <vector>
extern "C" {
#include "scene.h"
}
#include <igl/swept_volume_signed_distance.h>

using Pose = Eigen::Transform<double, 3, Eigen::Affine>;

static int refuse(const char *what) {
    std::fprintf(stderr, "igl_swept: %s\n", what);
    return 2;
}

static std::vector<Pose> poses_of(const scene &s, int count) {
    std::vector<Pose> out;
    inverse *all = scene_sample(&s, count - 1);
    for (int k = 0; k < count; k++) {
        Pose back = Pose::Identity();
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 4; j++)
                back(i, j) = all[k][i][j];
        out.push_back(back.inverse());
    }
    std::free(all);
    return out;
}

static bool sign_of(igl::SignedDistanceType &out, const char *name) {
    const char *names[] = {"pseudonormal", "winding", "fast"};
    const igl::SignedDistanceType types[] = {igl::SIGNED_DISTANCE_TYPE_PSEUDONORMAL,
                                             igl::SIGNED_DISTANCE_TYPE_WINDING_NUMBER,
                                             igl::SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER};
    for (int k = 0; k < 3; k++)
        if (std::strcmp(name, names[k]) == 0)
            return out = types[k], true;
    return false;
}

int main(int argc, char **argv) {
    igl::SignedDistanceType sign;
    if ((argc != 8 && argc != 12) || std::atoi(argv[1]) < 2 || !sign_of(sign, argv[2]))
        return refuse("expected N SIGN ISOLEVEL SOLID MOTION POINTS OUT [NX NY NZ H], N at least 2");
    double isolevel = std::strtod(argv[3], nullptr);
    scene s;
    points in;
    scene_read(&s, argv[4], argv[5]);
    if (s.dimension != 3 || (std::isfinite(isolevel) && argc != 12))
        return refuse("expected a solid in space, and a grid where the isolevel is finite");
    Eigen::MatrixXd vertices(s.vertices, 3);
    Eigen::MatrixXi faces(s.facets, 3);
    for (int k = 0; k < s.vertices; k++)
        vertices.row(k) << s.vertex[k][0], s.vertex[k][1], s.vertex[k][2];
    for (int k = 0; k < s.facets; k++) {
        if (s.facet[k].count != 3)
            return refuse("expected triangles: graze convert SOLID -o FILE.off");
        faces.row(k) << s.facet[k].vertex[0], s.facet[k].vertex[1], s.facet[k].vertex[2];
    }
    std::vector<double> at;
    points_open(&in, argv[6], 3);
    for (double p[3]; points_next(&in, p);)
        at.insert(at.end(), p, p + 3);
    Eigen::Index n = Eigen::Index(at.size() / 3);
    Eigen::MatrixXd grid =
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(at.data(), n, 3);
    Eigen::RowVector3i sides(int(n), 1, 1);
    double edge = 0;
    if (argc == 12) {
        sides << std::atoi(argv[8]), std::atoi(argv[9]), std::atoi(argv[10]);
        edge = std::strtod(argv[11], nullptr);
        if (Eigen::Index(sides(0)) * sides(1) * sides(2) != n)
            return refuse("the grid has another number of points than the file");
    }
    std::vector<Pose> poses = poses_of(s, std::atoi(argv[1]));
    Eigen::VectorXd found;
    std::clock_t start = std::clock();
    igl::swept_volume_signed_distance(vertices, faces, poses, sign, grid, sides, edge, isolevel, found);
    std::fprintf(stderr, "seconds=%.6f\n", double(std::clock() - start) / CLOCKS_PER_SEC);
    FILE *out = open_for_writing(argv[7]);
    std::fputs("x,y,z,sdf\n", out);
    points_open(&in, argv[6], 3);
    for (double p[3]; points_next(&in, p);) {
        points_echo(&in, out);
        std::fprintf(out, "%.17g\n", found(n - Eigen::Index(at.size() / 3)));
        at.resize(at.size() - 3);
    }
    return std::fclose(out) == 0 ? 0 : 1;
}
