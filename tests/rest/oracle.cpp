/* Points in a solid that does not move, by CGAL, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Standard input has a solid as shells (agree/shells.h), `end`, the number of points, and the
 * points. One line a point: where the locator of the Nef polyhedron finds it (interior, boundary,
 * exterior), and the exact square of its distance to the boundary.
 */
#include "../agree/shells.h"
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <iostream>

namespace {

using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Piece = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Piece>>;

const char *place(const Nef &solid, const Point &point) {
    Nef::Volume_const_handle volume;
    if (!CGAL::assign(volume, solid.locate(point)))
        return "boundary";
    return volume->mark() ? "interior" : "exterior";
}

Triangles boundary_of(const Nef &solid) {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    CGAL::convert_nef_polyhedron_to_polygon_soup(solid, points, polygons, true);
    Triangles out;
    for (const auto &p : polygons)
        out.emplace_back(points[p[0]], points[p[1]], points[p[2]]);
    return out;
}

} // namespace

int main() {
    try {
        Nef solid = read_solid(std::cin);
        Triangles triangles = boundary_of(solid);
        Tree tree(triangles.begin(), triangles.end());
        for (size_t k = next_count(std::cin); k > 0; k--) {
            Point point = next_point(std::cin);
            std::cout << place(solid, point) << ' ' << CGAL::exact(tree.squared_distance(point))
                      << '\n';
        }
    } catch (const std::exception &error) {
        std::cerr << "oracle: " << error.what() << "\n";
        return 1;
    }
    return std::cout.flush() ? 0 : 1;
}
