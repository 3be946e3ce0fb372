/* The peers Graze is measured against, by CGAL with inexact constructions (EPICK): hits of segments
 * with a mesh, static points, the union of sampled positions, reading and checking a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Usage: peers MESH.off. Answers one line `key=value ...` when the mesh is loaded, then one a line
 * of standard input. Files hold raw doubles; FROM and N count segments or points.
 *   count SEGMENTS FROM N          all intersections of segments (6 doubles each)
 *   counts SEGMENTS FROM N OUT     the same, the numbers written to OUT as 64-bit integers
 *   static POINTS FROM N           Side_of_triangle_mesh
 *   union POINTS FROM N MATRICES   inside in any of the sampled positions (12 doubles each): no
 *                                  sample is left out once one has said yes
 *   closest POINTS FROM N MATRICES the least distance to the sampled positions' boundaries
 *   checks                         closed, triangles, no self-intersection, bounds a volume
 * Times are CPU seconds of the process.
 */
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include "peer.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Side = CGAL::Side_of_triangle_mesh<Mesh, Kernel>;
namespace PMP = CGAL::Polygon_mesh_processing;

void static_points(const Side &side, std::istream &command) {
    std::string path;
    size_t from = 0, n = 0, inside = 0;
    command >> path >> from >> n;
    std::vector<double> data = read_doubles(path, 3, from, n);
    double start = seconds();
    for (size_t k = 0; k < n; k++)
        inside +=
            side(Point(data[3 * k], data[3 * k + 1], data[3 * k + 2])) != CGAL::ON_UNBOUNDED_SIDE;
    std::printf("seconds=%.9f inside=%zu\n", seconds() - start, inside);
}

Point moved(const double *m, const double *p) {
    return Point(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
                 m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
                 m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11]);
}

void sampled_union(const Side &side, std::istream &command) {
    std::string path, sampled;
    size_t from = 0, n = 0, inside = 0;
    command >> path >> from >> n >> sampled;
    std::vector<double> data = read_doubles(path, 3, from, n);
    std::vector<double> matrices = read_doubles(sampled, 12, 0, 0);
    double start = seconds();
    for (size_t k = 0; k < n; k++) {
        size_t in = 0;
        for (size_t m = 0; m < matrices.size(); m += 12)
            in += side(moved(&matrices[m], &data[3 * k])) == CGAL::ON_BOUNDED_SIDE;
        inside += in > 0;
    }
    std::printf("seconds=%.9f inside=%zu\n", seconds() - start, inside);
}

void closest_sample(const Tree &tree, std::istream &command) {
    std::string path, sampled;
    size_t from = 0, n = 0;
    command >> path >> from >> n >> sampled;
    std::vector<double> data = read_doubles(path, 3, from, n);
    std::vector<double> matrices = read_doubles(sampled, 12, 0, 0);
    double start = seconds(), sum = 0;
    for (size_t k = 0; k < n; k++) {
        double least = std::numeric_limits<double>::infinity();
        for (size_t m = 0; m < matrices.size(); m += 12)
            least = std::min(least, tree.squared_distance(moved(&matrices[m], &data[3 * k])));
        sum += std::sqrt(least);
    }
    std::printf("seconds=%.9f mean=%.17g\n", seconds() - start, sum / double(n));
}

void checks(const Mesh &mesh) {
    double start = seconds();
    bool good = CGAL::is_closed(mesh) && CGAL::is_triangle_mesh(mesh);
    good = good && !PMP::does_self_intersect<CGAL::Sequential_tag>(mesh);
    double crossing = seconds() - start;
    good = good && PMP::does_bound_a_volume(mesh);
    std::printf("seconds=%.9f self_intersection=%.9f good=%d\n", seconds() - start, crossing, good);
}

void serve(const char *path) {
    Mesh mesh;
    double start = seconds();
    if (!CGAL::IO::read_OFF(std::string(path), mesh))
        throw std::runtime_error(std::string(path) + ": cannot be read");
    double read = seconds() - start;
    Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
    tree.build();
    tree.accelerate_distance_queries();
    double built = seconds() - start;
    Side side(tree);
    std::printf("faces=%zu read=%.9f tree=%.9f\n", size_t(mesh.number_of_faces()), read,
                built - read);
    std::fflush(stdout);
    for (std::string line; std::getline(std::cin, line); std::fflush(stdout)) {
        std::istringstream command(line);
        std::string verb;
        command >> verb;
        if (verb == "count" || verb == "counts")
            count_hits(command, verb == "counts", [&tree](const double *x) {
                return tree.number_of_intersected_primitives(
                    Kernel::Segment_3(Point(x[0], x[1], x[2]), Point(x[3], x[4], x[5])));
            });
        else if (verb == "static")
            static_points(side, command);
        else if (verb == "union")
            sampled_union(side, command);
        else if (verb == "closest")
            closest_sample(tree, command);
        else if (verb == "checks")
            checks(mesh);
        else
            throw std::runtime_error("unknown command: " + line);
    }
}

} // namespace

int main(int count, char **arguments) {
    return peer_main(count, arguments, serve);
}
