/* The crossing of a ring of area zero with itself, for a message: the ring's lobes cancel, so no
 * reader can turn it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/validate/boxes.hpp"

#include <algorithm>
#include <limits>
#include "input/validate/cgal.hpp"
#include "input/validate/steps.hpp"

namespace {

typedef std::pair<std::uint32_t, std::uint32_t> edge_pair;
constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

mpq_class coordinate(const soup &s, std::uint32_t vertex, int axis) {
    mpq_class value;
    fmpq_get_mpq(value.get_mpq_t(), s.coordinates + 2 * std::size_t(vertex) + axis);
    return value;
}

/* The point in which two segments cross, as (x, y). */
std::string crossing_text(const soup &s, const simplex &e, const simplex &f) {
    mpq_class a[2], d[2], g[2], h[2]; /* a + x d on one, a + g + y h on the other */
    for (int j = 0; j < 2; j++) {
        a[j] = coordinate(s, e.vertex[0], j);
        d[j] = coordinate(s, e.vertex[1], j) - a[j];
        g[j] = coordinate(s, f.vertex[0], j) - a[j];
        h[j] = coordinate(s, f.vertex[1], j) - coordinate(s, f.vertex[0], j);
    }
    const mpq_class x = (g[0] * h[1] - g[1] * h[0]) / (d[0] * h[1] - d[1] * h[0]);
    const mpq_class point[2] = {a[0] + x * d[0], a[1] + x * d[1]};
    return "(" + point[0].get_str() + ", " + point[1].get_str() + ")";
}

/* The smallest pair of edges that cross, so that the message depends on the ring alone. If no edges
 * cross, the pair is NONE and `overlap` tells whether edges lie on one another. */
edge_pair find_crossing(bool &overlap, graze_context *context, const points &at,
                        const std::vector<piece> &edges) {
    edge_pair first = {NONE, NONE};
    overlap = false;
    each_candidate(context, at, edges, [&](std::uint32_t i, std::uint32_t j) {
        const edge_pair here = {i, j};
        if (here > first)
            return;
        const piece &e = edges[i], &f = edges[j];
        std::uint32_t touching = 0;
        const segments lie = segments_lie(touching, at, 2, e.at[0], e.at[1], f.at[0], f.at[1]);
        overlap = overlap || lie == segments::overlap || lie == segments::same;
        if (lie == segments::cross)
            first = here;
    });
    return first;
}

/* A cycle as a soup of its own, which borrows all but the offsets. */
soup only_ring(const soup &s, std::size_t cycle, std::uint32_t *one) {
    soup ring = s;
    one[0] = 0;
    one[1] = 1;
    ring.facet_count = ring.cycle_count = 1;
    ring.facet_start = one;
    ring.cycle_start = s.cycle_start + cycle;
    return ring;
}

} // namespace

graze_status validate_crossing(graze_context *context, const soup *s, size_t cycle) {
    return guard(context, [&] {
        std::uint32_t one[2];
        const soup ring = only_ring(*s, cycle, one);
        const points at(2, s->vertex_count, s->coordinates);
        std::vector<piece> edges = cut_rings(at, ring);
        bool overlap = false;
        const edge_pair first = find_crossing(overlap, context, at, edges);
        if (first.first != NONE) {
            const simplex &e = edges[first.first].cell, &f = edges[first.second].cell;
            refuse(context,
                   "edges %u-%u and %u-%u cross; edges may touch in vertices only, and these meet "
                   "at %s",
                   e.vertex[0], e.vertex[1], f.vertex[0], f.vertex[1],
                   crossing_text(*s, e, f).c_str());
        }
        if (!overlap && !edges.empty())
            check_outline(context, edges, at, ring);
    });
}
