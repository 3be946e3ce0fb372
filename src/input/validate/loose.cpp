/* The edges at which triangles do not close (validate.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Whole edges cancel first. What is left is summed along lines, since the sides of triangles may
 * lie on one another without being one edge, as at a corner in the middle of an edge: on each line
 * the ends of such edges are gone through in their order, and each part between two neighbouring
 * ends is run through by the edges that begin before and end behind it.
 */
#include "input/validate/cgal.hpp"

#include <array>
#include "input/validate/steps.hpp"

namespace {

/* Counts of the triangles that run through an edge each way; `along` is the way in which the line's
 * coordinate `axis` grows. */
struct passes {
    std::size_t along = 0, against = 0;
};

/* An end of an edge on its line: passes begin there, or end. */
struct line_end {
    std::size_t line; /* index of the first open edge on the line */
    std::uint32_t position;
    bool begins;
    passes through;
};

/* A line along which coordinate `axis` changes. `at` holds the slopes of the next two coordinates
 * over that one, then the values of both where it is 0. */
struct line {
    std::array<mpq_class, 4> at;
    int axis;
    bool operator<(const line &other) const {
        return std::tie(axis, at) < std::tie(other.axis, other.at);
    }
};

line line_through(const points &at, std::uint32_t u, std::uint32_t v) {
    line out;
    out.axis = 0;
    while (at.rank(u, out.axis) == at.rank(v, out.axis))
        out.axis++;
    const mpq_class from = at.coordinate(u, out.axis);
    const mpq_class step = at.coordinate(v, out.axis) - from;
    for (int k = 0; k < 2; k++) {
        const int j = (out.axis + 1 + k) % 3;
        const mpq_class start = at.coordinate(u, j);
        out.at[k] = (at.coordinate(v, j) - start) / step;
        out.at[2 + k] = start - from * out.at[k];
    }
    return out;
}

/* An edge that triangles run through more often one way than the other. */
struct open_edge {
    std::uint32_t first, last; /* positions, in the order along the line */
    passes through;
    line on;
};

std::vector<open_edge> edges_left_open(graze_context *context, const std::vector<half_edge> &edges,
                                       const points &at, disjoint_sets &sets) {
    std::vector<open_edge> out;
    interruption cancel(context);
    for (auto first = edges.begin(), last = first; first != edges.end(); first = last) {
        passes through;
        cancel.poll();
        for (last = first; last != edges.end() && last->same_edge(*first); ++last) {
            (last->ascends ? through.along : through.against)++;
            sets.join(first->piece, last->piece);
        }
        if (through.along == through.against)
            continue;
        open_edge r = {first->low, first->high, through, line_through(at, first->low, first->high)};
        if (at.rank(r.first, r.on.axis) > at.rank(r.last, r.on.axis)) {
            std::swap(r.first, r.last);
            std::swap(r.through.along, r.through.against);
        }
        out.push_back(std::move(r));
    }
    return out;
}

/* The ends of edges in their order along each line. */
std::vector<line_end> ends_along_lines(std::vector<open_edge> &open, const points &at) {
    std::vector<line_end> ends;
    std::sort(open.begin(), open.end(),
              [](const open_edge &a, const open_edge &b) { return a.on < b.on; });
    for (std::size_t k = 0, first = 0; k < open.size(); k++) {
        if (open[first].on < open[k].on)
            first = k;
        ends.push_back({first, open[k].first, true, open[k].through});
        ends.push_back({first, open[k].last, false, open[k].through});
    }
    std::sort(ends.begin(), ends.end(), [&](const line_end &a, const line_end &b) {
        const int axis = open[a.line].on.axis;
        return a.line != b.line ? a.line < b.line
                                : at.rank(a.position, axis) < at.rank(b.position, axis);
    });
    return ends;
}

/* The parts of lines at which passes do not cancel. */
std::vector<loose_edge> parts_left_open(const std::vector<line_end> &ends) {
    std::vector<loose_edge> out;
    passes now;
    for (std::size_t k = 0; k < ends.size(); k++) {
        const line_end &e = ends[k];
        now.along = e.begins ? now.along + e.through.along : now.along - e.through.along;
        now.against = e.begins ? now.against + e.through.against : now.against - e.through.against;
        /* Every edge on a line ends on it, so nothing is open behind the last end. */
        if (now.along == now.against || e.position == ends[k + 1].position)
            continue;
        loose_edge part = {e.position, ends[k + 1].position, now.along, now.against};
        if (part.forward < part.backward) {
            std::swap(part.from, part.to);
            std::swap(part.forward, part.backward);
        }
        out.push_back(part);
    }
    return out;
}

void report_parts(loose_edges *out, std::vector<loose_edge> parts) {
    const auto is_odd = [](const loose_edge &e) { return e.forward % 2 != e.backward % 2; };
    const auto ends = [](const loose_edge &e) { return std::minmax(e.from, e.to); };
    std::sort(parts.begin(), parts.end(),
              [&](const loose_edge &a, const loose_edge &b) { return ends(a) < ends(b); });
    out->unbalanced_count = parts.size();
    out->odd_count = static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), is_odd));
    for (const loose_edge &e : parts)
        if (out->kept_count < LOOSE_EDGES_KEPT && (out->odd_count == 0 || is_odd(e)))
            out->kept[out->kept_count++] = e;
}

} // namespace

graze_status validate_loose(simplices *out, loose_edges *edges, size_t *flat_count,
                            graze_context *context, const soup *s, unsigned flags) {
    *out = {};
    *edges = {};
    *flat_count = 0;
    return guard(context, [&] {
        check_size(context, *s);
        const points at(3, s->vertex_count, s->coordinates);
        std::vector<piece> pieces =
            cut_facets(context, at, *s, (flags & GRAZE_SOLID_TRIANGULATE) != 0, flat_count);
        disjoint_sets sets(pieces.size());
        std::vector<open_edge> open = edges_left_open(context, sorted_half_edges(pieces), at, sets);
        report_parts(edges, parts_left_open(ends_along_lines(open, at)));
        hand_over(out, pieces, assign_components(pieces, sets));
    });
}
