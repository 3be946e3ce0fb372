/* The sides of triangles, those of one edge together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_HALF_EDGES_HPP
#define GRAZE_VALIDATE_HALF_EDGES_HPP

#include <algorithm>
#include <tuple>
#include "input/validate/pairs.hpp"

/** One side of one triangle. */
struct half_edge {
    std::uint32_t low, high; /* positions, low < high */
    std::uint32_t piece;
    std::uint8_t side;
    bool ascends; /* runs from low to high */

    bool same_edge(const half_edge &other) const {
        return low == other.low && high == other.high;
    }
};

/** All sides, sorted: those of one edge stand together, in the order of their triangles. */
inline std::vector<half_edge> sorted_half_edges(const std::vector<piece> &pieces) {
    std::vector<half_edge> edges;
    edges.reserve(3 * pieces.size());
    for (std::uint32_t i = 0; i < pieces.size(); i++)
        for (std::uint8_t k = 0; k < 3; k++) {
            const std::uint32_t a = pieces[i].at[k], b = pieces[i].at[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), i, k, a < b});
        }
    std::sort(edges.begin(), edges.end(), [](const half_edge &e, const half_edge &f) {
        return std::tie(e.low, e.high, e.piece, e.side) < std::tie(f.low, f.high, f.piece, f.side);
    });
    return edges;
}

#endif
