/* Point positions in a solid swept along straight legs, by CGAL's Minkowski sum.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Standard input: the shells of a solid (shells.h) and `end`; the number of legs, each with its two
 * end points, the positions the origin is carried between; the number of points, and the points.
 * Standard output: one line a point, two words. First, the position in the open sweep: `in` if it
 * is in the sum of the interior of the solid with a leg, `on` if only in the sum of the closed
 * solid, `out` if in neither. Second, the position in the closed sweep as a point set: interior,
 * boundary, exterior. An argument is a file that gets the boundary of the closed sweep, in
 * triangles with exact coordinates, as OFF.
 */
#include "legs.h"
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <fstream>
#include <iostream>

namespace {

enum class Place { outside, boundary, inside };

/* Where a point lies relative to the closure of a set. */
Place place(const Nef &set, const Point &point, bool *member) {
    Nef::Object_handle where = set.locate(point);
    Nef::Vertex_const_handle vertex;
    Nef::Halfedge_const_handle edge;
    Nef::Halffacet_const_handle facet;
    Nef::Volume_const_handle volume;
    if (CGAL::assign(vertex, where)) {
        *member = vertex->mark();
    } else if (CGAL::assign(edge, where)) {
        *member = edge->mark();
    } else if (CGAL::assign(facet, where)) {
        *member = facet->mark();
    } else if (CGAL::assign(volume, where)) {
        *member = volume->mark();
        return *member ? Place::inside : Place::outside;
    } else {
        throw std::runtime_error("locate gave nothing");
    }
    return Place::boundary;
}

void write_boundary(const Nef &set, const char *path) {
    CGAL::Surface_mesh<Point> mesh;
    std::ofstream out(path);
    CGAL::convert_nef_polyhedron_to_polygon_mesh(set, mesh, true);
    out << "OFF\n" << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n";
    for (auto vertex : mesh.vertices()) {
        const Point &p = mesh.point(vertex);
        out << CGAL::exact(p.x()) << ' ' << CGAL::exact(p.y()) << ' ' << CGAL::exact(p.z()) << '\n';
    }
    for (auto face : mesh.faces()) {
        out << '3';
        for (auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
            out << ' ' << static_cast<unsigned>(vertex);
        }
        out << '\n';
    }
    if (!out.flush()) {
        throw std::runtime_error(std::string("cannot write ") + path);
    }
}

void run(std::istream &in, std::ostream &out, const char *boundary) {
    Nef solid = read_solid(in), closed(Nef::EMPTY);
    std::vector<Nef> open;
    for (size_t k = next_count(in); k > 0; k--) {
        Point from = next_point(in), to = next_point(in);
        Nef leg = segment(from, to);
        closed = closed + sum(solid, leg);
        open.push_back(sum(solid.interior(), leg));
    }
    closed = closed.regularization();
    if (boundary) {
        write_boundary(closed, boundary);
    }
    for (size_t k = next_count(in); k > 0; k--) {
        Point point = next_point(in);
        bool member = false, entered = false;
        for (const Nef &part : open) {
            bool in_part = false;
            place(part, point, &in_part);
            entered = entered || in_part;
        }
        Place topological = place(closed, point, &member);
        out << (entered  ? "in"
                : member ? "on"
                         : "out")
            << ' '
            << (topological == Place::inside     ? "interior"
                : topological == Place::boundary ? "boundary"
                                                 : "exterior")
            << '\n';
    }
}

} // namespace

int main(int count, char **word) {
    try {
        run(std::cin, std::cout, count > 1 ? word[1] : nullptr);
    } catch (const std::exception &error) {
        std::cerr << "minkowski: " << error.what() << "\n";
        return 1;
    }
    return std::cout.flush() ? 0 : 1;
}
