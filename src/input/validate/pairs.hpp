/* Pieces of a boundary, the predicates for the relative position of two of them, and the sides of
 * triangles, those of one edge together. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_VALIDATE_PAIRS_HPP
#define GRAZE_VALIDATE_PAIRS_HPP

#include "input/validate/validate.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>
#include "input/validate/points.hpp"

/**
 * A simplex with the data that the tests use again and again. Invariant for d = 3: the positions
 * are not collinear, and `facing` = turn(drop, at[0], at[1], at[2]) is not 0.
 */
struct piece {
    simplex cell;
    std::uint32_t at[3]; /* the positions of its vertices */
    std::int8_t drop;    /* the coordinate that is dropped to project its plane to E^2 */
    std::int8_t facing;
    bool planar; /* cut out of a planar facet: its siblings are known not to overlap it */
};

/** Set `drop` and `facing` from the positions; false if they are collinear. */
bool piece_orient(piece &p, const points &at);

/** Relative position of two segments of one plane: apart, sharing an end, one end resting inside
 * the other, crossing inside both, having more than a point in common, or being the same. */
enum class segments { apart, share, touch, cross, overlap, same };

/**
 * How segments a b and c d lie, each with ends at different positions, once coordinate `drop` is
 * dropped.
 * @param[out] touching the end that rests inside the other segment, where the answer is touch
 */
segments segments_lie(std::uint32_t &touching, const points &at, int drop, std::uint32_t a,
                      std::uint32_t b, std::uint32_t c, std::uint32_t d);

/** Have two segments of one line more than a point in common? */
bool collinear_overlap(const points &at, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                       std::uint32_t d);

/** Relative position of two triangles of positive area: having at most points or a common side in
 * common, in contact along a segment of a side, crossing inside both, or overlapping in their
 * plane. */
enum class triangles { clear, contact, cross, overlap };

/** The sides along which two triangles are in contact; -1 for none. A part of such a side lies
 * inside the other triangle or along a side of it. */
struct contact_sides {
    int first, second;
};

triangles triangles_lie(contact_sides &sides, const points &at, const piece &s, const piece &t);

/** Do two closed triangles (segments when the points are of dimension 2) have a point in common? */
bool pieces_meet(const points &at, const piece &s, const piece &t);

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
