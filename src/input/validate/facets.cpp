/* Facets of a polygon soup in E^3, checked one by one: enough positions, an area, a plane; then cut
 * into triangles, or fanned where GRAZE_SOLID_TRIANGULATE allows it. Consecutive corners at one
 * position make a run, and its last one is taken. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/validate/steps.hpp"

#include <algorithm>
#include "input/validate/failure.hpp"

namespace {

typedef std::vector<std::size_t> cycle;

std::uint32_t position(const points &at, std::size_t v) {
    return at.position(static_cast<std::uint32_t>(v));
}

/* The corners of all cycles; of successive corners at one position the last. */
cycle vertices_of(const points &at, const soup &s, std::size_t facet) {
    cycle all;
    for (std::size_t c = s.facet_start[facet]; c < s.facet_start[facet + 1]; c++)
        for (std::size_t k = s.cycle_start[c]; k < s.cycle_start[c + 1]; k++) {
            const std::size_t next = k + 1 < s.cycle_start[c + 1] ? k + 1 : s.cycle_start[c];
            if (position(at, s.index[k]) != position(at, s.index[next]))
                all.push_back(s.index[k]);
        }
    return all;
}

void check_cycle(graze_context *context, const points &at, std::size_t facet,
                 const std::uint32_t *index, std::size_t count) {
    std::vector<std::uint32_t> different;
    for (std::size_t k = 0; k < count && different.size() < 3; k++) {
        const std::uint32_t here = position(at, index[k]);
        if (std::find(different.begin(), different.end(), here) == different.end())
            different.push_back(here);
    }
    if (different.size() < 3)
        refuse(context, "facet %zu: only %zu different positions; a facet needs at least three",
               facet, different.size());
}

piece triangle(const points &at, std::size_t facet, std::size_t u, std::size_t v, std::size_t w) {
    piece p = {};
    const std::size_t vertex[3] = {u, v, w};
    for (int k = 0; k < 3; k++) {
        p.cell.vertex[k] = static_cast<std::uint32_t>(vertex[k]);
        p.at[k] = position(at, vertex[k]);
    }
    p.cell.facet = static_cast<std::uint32_t>(facet);
    return p;
}

/* Find the plane of a facet by its first two vertices and the first one off their line; false if
 * all lie on one line. */
bool spans_plane(piece &plane, const points &at, std::size_t facet, const cycle &all) {
    for (std::size_t k = 2; k < all.size(); k++) {
        plane = triangle(at, facet, all[0], all[1], all[k]);
        if (piece_orient(plane, at))
            return true;
    }
    return false;
}

void fan_facet(graze_context *context, std::vector<piece> &out, const points &at, std::size_t facet,
               const cycle &all, std::size_t *flat) {
    for (std::size_t k = 1; k + 1 < all.size(); k++) {
        piece p = triangle(at, facet, all[0], all[k], all[k + 1]);
        const bool spans = piece_orient(p, at);
        if (!spans && flat != nullptr) {
            ++*flat;
            continue;
        }
        if (!spans)
            refuse(context,
                   "facet %zu: the triangle (%zu, %zu, %zu) of its fan has no area; cut the facet "
                   "into triangles another way",
                   facet, all[0], all[k], all[k + 1]);
        p.cell.diagonal = static_cast<std::uint8_t>((k > 1 ? 1 : 0) | (k + 2 < all.size() ? 4 : 0));
        out.push_back(p);
    }
}

/* A quadrilateral that turns the same way at all corners is convex. */
bool convex_quadrilateral(std::vector<piece> &out, const points &at, std::size_t facet,
                          const cycle &all, int drop) {
    if (all.size() != 4)
        return false;
    std::uint32_t p[4];
    for (int k = 0; k < 4; k++)
        p[k] = position(at, all[k]);
    const int sense = at.turn(drop, p[0], p[1], p[2]);
    for (int k = 0; k < 4; k++)
        if (sense == 0 || at.turn(drop, p[k], p[(k + 1) % 4], p[(k + 2) % 4]) != sense)
            return false;
    for (int k = 1; k < 3; k++) {
        piece t = triangle(at, facet, all[0], all[k], all[k + 1]);
        t.drop = static_cast<std::int8_t>(drop);
        t.facing = static_cast<std::int8_t>(sense);
        t.cell.diagonal = k == 1 ? 4 : 1;
        t.planar = true;
        out.push_back(t);
    }
    return true;
}

void cut_facet(graze_context *context, std::vector<piece> &out, const points &at, const soup &s,
               std::size_t facet, bool fan, std::size_t *flat) {
    const cycle all = vertices_of(at, s, facet);
    piece plane = {};
    const bool spans = spans_plane(plane, at, facet, all);
    if (!spans && flat != nullptr) {
        ++*flat;
        return;
    }
    const std::size_t cycles = s.facet_start[facet + 1] - s.facet_start[facet];
    if (cycles == 0)
        check_cycle(context, at, facet, s.index, 0);
    for (std::size_t c = s.facet_start[facet]; c < s.facet_start[facet + 1]; c++)
        check_cycle(context, at, facet, s.index + s.cycle_start[c],
                    s.cycle_start[c + 1] - s.cycle_start[c]);
    if (!spans)
        refuse(context, "facet %zu has no area: all its vertices lie on one line", facet);
    if (all.size() == 3) {
        plane.planar = true;
        out.push_back(plane);
        return;
    }
    for (std::size_t v : all) {
        if (at.side(plane.at[0], plane.at[1], plane.at[2], position(at, v)) == 0)
            continue;
        if (fan && cycles == 1) {
            fan_facet(context, out, at, facet, all, flat);
            return;
        }
        refuse(context,
               "facet %zu is not planar: vertex %zu is off the plane of vertices %u, %u, %u%s",
               facet, v, plane.cell.vertex[0], plane.cell.vertex[1], plane.cell.vertex[2],
               cycles == 1 ? "; expected a planar facet, or triangulation"
                           : "; expected it in that plane");
    }
    if (!convex_quadrilateral(out, at, facet, all, plane.drop))
        cut_planar_facet(context, out, at, s, facet, plane);
}

/* The first facet that is not legal, with its message, and the facets with a fault of its kind. */
class bad_facets {
  public:
    void take(const failure &found, const graze_context *context, std::size_t facet) {
        if (found.kind == nullptr)
            throw failure(found);
        if (kind_ == nullptr) {
            kind_ = found.kind;
            message_ = graze_context_message(context);
        }
        if (kind_ == found.kind)
            list_.add(facet, std::to_string(facet));
        else
            others_++;
    }
    void report(graze_context *context) const {
        const std::string others =
            others_ > 0 ? "; " + std::to_string(others_) + " with other faults" : "";
        if (kind_ != nullptr)
            refuse(context, "%s%s%s", message_.c_str(), list_.text("such facets").c_str(),
                   others.c_str());
    }

  private:
    const char *kind_ = nullptr;
    std::string message_;
    fault_list list_;
    std::size_t others_ = 0;
};

} // namespace

std::vector<piece> cut_facets(graze_context *context, const points &at, const soup &s, bool fan,
                              std::size_t *flat) {
    std::vector<piece> out;
    out.reserve(s.index_count);
    interruption cancel(context);
    bad_facets bad;
    for (std::size_t facet = 0; facet < s.facet_count; facet++) {
        cancel.poll();
        try {
            cut_facet(context, out, at, s, facet, fan, flat);
        } catch (const failure &found) {
            bad.take(found, context, facet);
        }
    }
    bad.report(context);
    return out;
}
