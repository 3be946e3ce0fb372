/* If the corners of one simplex that are no corners of another lie strictly on one side of the
 * other's plane, the common points of both are in the convex hull of their common corners.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/bounds/bounds.h"

#include <math.h>
#include <string.h>
#include "base/number/vector.h"

static const double *double_corner(const graze_solid *solid, uint32_t simplex, int k) {
    size_t d = (size_t)solid->input.dimension;
    return solid->corners.at + d * (d * simplex + (size_t)k);
}

/* Have two vertices one position? Vertices with different numbers may. */
static int is_one_position(const graze_solid *solid, uint32_t v, uint32_t w) {
    const fmpq *at = solid->input.coordinates;
    int d = solid->input.dimension;
    return v == w || !vector_compare(at + (size_t)d * v, at + (size_t)d * w, d);
}

/* The corners of b that a has too, as a mask. */
static unsigned shared_corners(const graze_solid *solid, uint32_t a, uint32_t b) {
    unsigned mask = 0;
    int d = solid->input.dimension;
    for (int k = 0; k < d; k++)
        for (int l = 0; l < d; l++)
            if (is_one_position(solid, solid->cut.item[b].vertex[k], solid->cut.item[a].vertex[l]))
                mask |= 1u << k;
    return mask;
}

/* Whether all corners of b outside the mask are certainly on one side of a's plane, none on it. */
static int lie_on_one_side(const graze_solid *solid, uint32_t a, uint32_t b, unsigned but) {
    const double *from = double_corner(solid, a, 0);
    double error = solid->corners.error;
    normal n;
    int side = 0, d = solid->input.dimension;
    normal_of(&n, from, error, d);
    for (int k = 0; k < d; k++) {
        const double *v = double_corner(solid, b, k);
        double value = 0, size = 0, most = 0;
        if (but >> k & 1)
            continue;
        for (int i = 0; i < d; i++) {
            value += n.at[i] * (v[i] - from[i]);
            size += fabs(n.at[i]);
            most = larger(most, fabs(v[i] - from[i]));
        }
        double bound = FILTER_SLACK * (size * (2 * error + 8 * UNIT_ROUNDING * most) +
                                       3 * n.error * (most + 2 * error)) +
                       FILTER_FLOOR;
        int here = value > bound ? 1 : value < -bound ? -1 : 0;
        if (!here || (side && here != side))
            return 0;
        side = here;
    }
    return 1;
}

/* Whether the set of a span (bounds.h) and the segment a b are certainly apart along m. */
static int are_apart_along(const double *m, const span *wide, const double *a, const double *b) {
    double first = 0, last = 0, length = 0, bound = 0;
    for (int i = 0; i < 3; i++) {
        first += m[i] * (wide->from[i] - a[i]);
        last += m[i] * (wide->end[i] - a[i]);
        length += m[i] * (b[i] - a[i]);
        bound += fabs(m[i]) * (wide->wide[i] + 32 * UNIT_ROUNDING * wide->far);
    }
    bound = FILTER_SLACK * bound + FILTER_FLOOR;
    return smaller(first, last) - bound > larger(0, length) ||
           larger(first, last) + bound < smaller(0, length);
}

/* Is a box moved along a chord certainly apart from a segment? Among these directions is one that
 * separates them, if any does. */
static int misses_segment(const span *wide, const double *a, const double *b) {
    double edge[3], m[3];
    for (int i = 0; i < 3; i++)
        edge[i] = b[i] - a[i];
    cross3(m, wide->along, edge);
    if (are_apart_along(m, wide, a, b))
        return 1;
    for (int i = 0; i < 3; i++) {
        double axis[3] = {i == 0, i == 1, i == 2};
        if (are_apart_along(axis, wide, a, b))
            return 1;
        cross3(m, axis, edge);
        if (are_apart_along(m, wide, a, b))
            return 1;
        cross3(m, axis, wide->along);
        if (are_apart_along(m, wide, a, b))
            return 1;
    }
    return 0;
}

int common_corners(unsigned *of_b, const graze_solid *solid, uint32_t a, uint32_t b) {
    *of_b = shared_corners(solid, a, b);
    return lie_on_one_side(solid, a, b, *of_b) ||
           lie_on_one_side(solid, b, a, shared_corners(solid, b, a));
}

int may_rest_inside(const graze_solid *solid, uint32_t a, uint32_t b) {
    unsigned shared;
    int alone = common_corners(&shared, solid, a, b);
    return !alone && __builtin_popcount(shared) + 1 < solid->input.dimension;
}

int common_place_is_near(const graze_solid *solid, const span *wide, uint32_t a, uint32_t b) {
    unsigned of_b;
    double end[2][3] = {{0}};
    int count = 0, d = solid->input.dimension;
    if (!common_corners(&of_b, solid, a, b))
        return 1;
    for (int k = 0; k < d; k++)
        if (of_b >> k & 1)
            for (int e = count++ ? 1 : 0; e < 2; e++)
                memcpy(end[e], double_corner(solid, b, k), (size_t)d * sizeof end[e][0]);
    return count > 0 && !flip(FLIP_SEAM, misses_segment(wide, end[0], end[1]));
}
