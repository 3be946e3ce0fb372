/* Distances by CGAL: to a Minkowski sum, exactly; to sampled positions, in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Standard input begins with a solid as shells (agree/shells.h) and `end`. Then
 *   sum      number of legs, each with two end points; number of points, and the points: the solid
 *            is swept along the legs. One line a point: where it is in the closed sweep (interior,
 *            boundary, exterior) and the exact square of its distance to the sweep's boundary.
 *   poses    number of poses, each the 12 numbers of M(t)^-1 of a rigid M, row by row; number of
 *            points, and the points. One line a point: the least over the poses of the signed
 *            distance to the solid, negative inside.
 */
#include "../agree/legs.h"
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>

namespace {

using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Piece = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using ExactTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Piece>>;

const char *place(const Nef &set, const Point &point) {
    Nef::Volume_const_handle volume;
    if (!CGAL::assign(volume, set.locate(point)))
        return "boundary";
    return volume->mark() ? "interior" : "exterior";
}

Triangles boundary_of(const Nef &set) {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    CGAL::convert_nef_polyhedron_to_polygon_soup(set, points, polygons, true);
    Triangles out;
    for (const auto &p : polygons)
        out.emplace_back(points[p[0]], points[p[1]], points[p[2]]);
    return out;
}

void answer_sum(std::istream &in, const Nef &solid) {
    Nef closed(Nef::EMPTY);
    for (size_t k = next_count(in); k > 0; k--) {
        Point from = next_point(in), to = next_point(in);
        closed = closed + sum(solid, segment(from, to));
    }
    closed = closed.regularization();
    Triangles triangles = boundary_of(closed);
    ExactTree tree(triangles.begin(), triangles.end());
    for (size_t k = next_count(in); k > 0; k--) {
        Point point = next_point(in);
        std::cout << place(closed, point) << ' ' << CGAL::exact(tree.squared_distance(point))
                  << '\n';
    }
}

using Fast = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Fast::Point_3>;
using Face = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using FastTree = CGAL::AABB_tree<CGAL::AABB_traits<Fast, Face>>;

double next_double(std::istream &in) {
    return std::stod(next_token(in));
}

Mesh mesh_of(const Nef &solid) {
    CGAL::Surface_mesh<Point> exact;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(solid, exact, true);
    Mesh out;
    for (auto v : exact.vertices()) {
        const Point &p = exact.point(v);
        out.add_vertex(
            Fast::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
    }
    for (auto f : exact.faces()) {
        std::vector<Mesh::Vertex_index> corners;
        for (auto v : CGAL::vertices_around_face(exact.halfedge(f), exact))
            corners.emplace_back(v.idx());
        out.add_face(corners);
    }
    return out;
}

void answer_poses(std::istream &in, const Nef &solid) {
    Mesh mesh = mesh_of(solid);
    FastTree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
    tree.accelerate_distance_queries();
    CGAL::Side_of_triangle_mesh<Mesh, Fast> side(mesh);
    std::vector<double> pose(12 * next_count(in));
    for (double &x : pose)
        x = next_double(in);
    for (size_t k = next_count(in); k > 0; k--) {
        double x = next_double(in), y = next_double(in), z = next_double(in);
        double least = std::numeric_limits<double>::infinity();
        for (const double *m = pose.data(); m < pose.data() + pose.size(); m += 12) {
            Fast::Point_3 at(m[0] * x + m[1] * y + m[2] * z + m[3],
                             m[4] * x + m[5] * y + m[6] * z + m[7],
                             m[8] * x + m[9] * y + m[10] * z + m[11]);
            double d = std::sqrt(tree.squared_distance(at));
            least = std::min(least, side(at) == CGAL::ON_BOUNDED_SIDE ? -d : d);
        }
        std::printf("%.17g\n", least);
    }
}

} // namespace

int main() {
    try {
        Nef solid = read_solid(std::cin);
        std::string verb = next_token(std::cin);
        if (verb == "sum")
            answer_sum(std::cin, solid);
        else if (verb == "poses")
            answer_poses(std::cin, solid);
        else
            throw std::runtime_error("unknown command: " + verb);
    } catch (const std::exception &error) {
        std::cerr << "oracle: " << error.what() << "\n";
        return 1;
    }
    return std::cout.flush() ? 0 : 1;
}
