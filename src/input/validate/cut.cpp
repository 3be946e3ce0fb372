/* One planar facet, convex or not, with collinear corners, holes, slits and pinched vertices, cut
 * into triangles by an exact constrained Delaunay triangulation of its projection.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The sides may meet in common ends only. The inside is where a path from afar has crossed an odd
 * number of sides; a side run through both ways (a slit) separates nothing and must have inside on
 * its two hands. Every other side must have the inside on the same hand, left or right for the
 * whole facet, which is then the facet's orientation. No vertex is added, so every side is a side
 * of one triangle, a slit of two.
 */
#include "input/validate/steps.hpp"

#include <map>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include "input/validate/boxes.hpp"
#include "input/validate/cgal.hpp"

namespace {

typedef CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel> Vertex_base;
typedef CGAL::Triangulation_face_base_with_info_2<int, Kernel> Info_base;
typedef CGAL::Constrained_triangulation_face_base_2<Kernel, Info_base> Face_base;
typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base> Structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                                   CGAL::No_constraint_intersection_tag>
    Triangulation;
typedef Triangulation::Face_handle Face;

constexpr int UNSEEN = -1;

/* A side that has a length. */
struct side {
    std::size_t from, to; /* the input's numbers */
    std::uint32_t a, b;   /* positions */
};

/* A side, by positions a < b: how often it is run through, and how much more often from a to b than
 * back; `from` and `to` are its ends in the last run. */
struct use {
    int times = 0, balance = 0;
    std::size_t from = 0, to = 0;
};
typedef std::map<std::pair<std::uint32_t, std::uint32_t>, use> uses;

struct facet_sides {
    std::vector<side> list;
    std::map<std::uint32_t, std::size_t> number; /* position -> first vertex there */
    uses used;
};

facet_sides sides_of(const points &at, const soup &s, std::size_t facet) {
    facet_sides all;
    for (std::size_t c = s.facet_start[facet]; c < s.facet_start[facet + 1]; c++) {
        const std::size_t first = s.cycle_start[c], count = s.cycle_start[c + 1] - first;
        for (std::size_t k = 0; k < count; k++) {
            side e = {s.index[first + k], s.index[first + (k + 1) % count], 0, 0};
            e.a = at.position(static_cast<std::uint32_t>(e.from));
            e.b = at.position(static_cast<std::uint32_t>(e.to));
            if (e.a == e.b)
                continue;
            all.list.push_back(e);
            all.number.emplace(e.a, e.from);
            use &u = all.used[std::minmax(e.a, e.b)];
            u.times++;
            u.balance += e.a < e.b ? 1 : -1;
            u.from = e.from;
            u.to = e.to;
        }
    }
    return all;
}

void check_pair(graze_context *context, const points &at, std::size_t facet, int drop,
                const side &e, const side &f) {
    std::uint32_t touching = 0;
    switch (segments_lie(touching, at, drop, e.a, e.b, f.a, f.b)) {
    case segments::cross:
        refuse(context, "facet %zu is not a simple polygon: its sides %zu-%zu and %zu-%zu cross",
               facet, e.from, e.to, f.from, f.to);
    case segments::touch:
        refuse(context,
               "facet %zu is not a simple polygon: its sides %zu-%zu and %zu-%zu touch at vertex "
               "%u, inside one of them",
               facet, e.from, e.to, f.from, f.to, touching);
    case segments::overlap:
        refuse(context,
               "facet %zu is not a simple polygon: its sides %zu-%zu and %zu-%zu lie on one "
               "another",
               facet, e.from, e.to, f.from, f.to);
    default:
        break;
    }
}

void check_simple(graze_context *context, const points &at, std::size_t facet, int drop,
                  const std::vector<side> &list) {
    constexpr std::size_t FEW = 24;
    if (list.size() <= FEW) {
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t j = i + 1; j < list.size(); j++)
                check_pair(context, at, facet, drop, list[i], list[j]);
        return;
    }
    box_list boxes(list.size());
    for (std::size_t i = 0; i < list.size(); i++) {
        const std::uint32_t ends[2] = {list[i].a, list[i].b};
        boxes.add(at, static_cast<std::uint32_t>(i), ends, 2);
    }
    interruption cancel(context);
    boxes.each_pair([&](std::uint32_t i, std::uint32_t j) {
        cancel.poll();
        check_pair(context, at, facet, drop, list[i], list[j]);
    });
}

Exact exact(const mpq_class &value) {
    return Exact(value.get_mpq_t());
}

void insert_sides(Triangulation &plane, const points &at, int drop, const facet_sides &sides) {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> corners;
    for (const auto &[position, number] : sides.number)
        corners.emplace_back(
            Kernel::Point_2(Kernel::FT(exact(at.coordinate(position, (drop + 1) % 3))),
                            Kernel::FT(exact(at.coordinate(position, (drop + 2) % 3)))),
            position);
    plane.insert(corners.begin(), corners.end());
    std::map<std::uint32_t, Triangulation::Vertex_handle> vertex;
    for (auto v = plane.finite_vertices_begin(); v != plane.finite_vertices_end(); ++v)
        vertex.emplace(v->info(), v);
    for (const auto &[ends, use] : sides.used)
        plane.insert_constraint(vertex.at(ends.first), vertex.at(ends.second));
}

/* The use of side k of a face: null if it is no side of the facet. */
const use *use_of(const Triangulation &plane, const facet_sides &sides, Face face, int k) {
    const auto u = face->vertex(plane.ccw(k)), v = face->vertex(plane.cw(k));
    if (plane.is_infinite(u) || plane.is_infinite(v))
        return nullptr;
    const auto found = sides.used.find(std::minmax(u->info(), v->info()));
    return found == sides.used.end() ? nullptr : &found->second;
}

/* Mark every face with 1 if it is inside, 0 if outside. */
void mark_inside(Triangulation &plane, const facet_sides &sides) {
    for (auto face = plane.all_faces_begin(); face != plane.all_faces_end(); ++face)
        face->info() = UNSEEN;
    std::vector<Face> open = {plane.infinite_face()};
    open.front()->info() = 0;
    while (!open.empty()) {
        const Face face = open.back();
        open.pop_back();
        for (int k = 0; k < 3; k++) {
            const Face next = face->neighbor(k);
            if (next->info() != UNSEEN)
                continue;
            const use *u = use_of(plane, sides, face, k);
            next->info() = face->info() ^ (u != nullptr && u->times % 2 != 0);
            open.push_back(next);
        }
    }
}

/* +1 if the facet runs counter-clockwise in the projection, -1 if clockwise. A facet without inside
 * has even sides only, with outside on both hands, and is refused. */
int orientation(graze_context *context, std::size_t facet, const Triangulation &plane,
                const facet_sides &sides) {
    int sense = 0;
    for (auto face = plane.all_faces_begin(); face != plane.all_faces_end(); ++face)
        for (int k = 0; k < 3; k++) {
            const use *u = use_of(plane, sides, face, k);
            if (u == nullptr)
                continue;
            if (u->balance == 0 && face->info() == 1)
                continue;
            if (u->times % 2 == 0)
                refuse(context,
                       "facet %zu: side %zu-%zu is run through %d times and does not bound its "
                       "inside; leave it out",
                       facet, u->from, u->to, u->times);
            if (face->info() == 0)
                continue;
            const bool ascends =
                face->vertex(plane.ccw(k))->info() < face->vertex(plane.cw(k))->info();
            const int here = (u->balance > 0) == ascends ? 1 : -1;
            if (sense != 0 && here != sense)
                refuse(context,
                       "facet %zu: its inside is left of some sides and right of side %zu-%zu; "
                       "expected a hole inside the outer cycle that runs the other way",
                       facet, u->from, u->to);
            sense = here;
        }
    return sense;
}

} // namespace

void cut_planar_facet(graze_context *context, std::vector<piece> &out, const points &at,
                      const soup &s, std::size_t facet, const piece &spanning) {
    const facet_sides sides = sides_of(at, s, facet);
    check_simple(context, at, facet, spanning.drop, sides.list);
    Triangulation plane;
    insert_sides(plane, at, spanning.drop, sides);
    mark_inside(plane, sides);
    const int sense = orientation(context, facet, plane, sides);
    for (auto face = plane.finite_faces_begin(); face != plane.finite_faces_end(); ++face) {
        if (face->info() != 1)
            continue;
        piece p = {};
        p.cell.facet = static_cast<std::uint32_t>(facet);
        p.drop = spanning.drop;
        p.facing = static_cast<std::int8_t>(sense);
        p.planar = true;
        for (int k = 0; k < 3; k++) {
            /* Clockwise facets take the corners 0, 2, 1; side k of the piece is opposite to the
             * face's corner `opposite`.
             */
            const int corner = sense > 0 ? k : (3 - k) % 3;
            const int opposite = sense > 0 ? (k + 2) % 3 : (4 - k) % 3;
            p.at[k] = face->vertex(corner)->info();
            p.cell.vertex[k] = static_cast<std::uint32_t>(sides.number.at(p.at[k]));
            if (use_of(plane, sides, face, opposite) == nullptr)
                p.cell.diagonal |= static_cast<std::uint8_t>(1U << k);
        }
        out.push_back(p);
    }
}
