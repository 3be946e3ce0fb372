/* The star of a moving point: the closed simplices of its boundary that hold it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_STAR_H
#define GRAZE_COLLIDE_STAR_H

#include "questions/collide/placing.h"

/** A simplex of the star, and its sides that hold the point. */
typedef struct star_simplex {
    uint32_t simplex;
    unsigned zero;
} star_simplex;

typedef struct star {
    size_t count, capacity;
    star_simplex *item;
} star;

/** Find all closed simplices of one solid that hold, at the placing's time, a point of an edge of
 * that solid.
 * @param edge the edge's ends, or a vertex twice: then that is the point
 * @param share two polynomials, positive at the time: the point is (share[0] first end + share[1]
 * second end) / (share[0] + share[1]); not used for a vertex */
void star_find(star *out, placing *p, pair_side side, const uint32_t edge[2],
               const fmpz_poly_struct share[2]);

#endif
