/* The simplices of a boundary that hold a moving point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_STAR_H
#define GRAZE_COLLIDE_STAR_H

#include "questions/collide/placing.h"

/** A simplex, and its sides that hold the point. */
typedef struct star_simplex {
    uint32_t simplex;
    unsigned zero;
} star_simplex;

typedef struct star {
    size_t count, capacity;
    star_simplex *item;
} star;

/**
 * Find all closed simplices of a side that hold a point of an edge of it at the placing's time.
 * @param edge  its ends, or one vertex twice: then the point is that
 * @param share two polynomials, positive at the time: the point is share[0] times the first end
 * plus share[1] times the second, over their sum; not used for a vertex
 */
void star_find(star *out, placing *p, pair_side side, const uint32_t edge[2],
               const fmpz_poly_struct share[2]);

#endif
