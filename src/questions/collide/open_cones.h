/* Whether the cones of two solids at a common point have interior points in common: two open cones,
 * given by the sectors that bound them. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vectors are polynomials of u; only their direction at the placing's time matters.
 */
#ifndef GRAZE_COLLIDE_OPEN_CONES_H
#define GRAZE_COLLIDE_OPEN_CONES_H

#include "questions/collide/placing.h"

typedef struct moving_vector {
    fmpz_poly_struct c[3];
} moving_vector;

/** Positive combinations of `from` and `to`, which are independent; `normal` = from x to points out
 * of the cone. */
typedef struct sector {
    moving_vector from, to, normal;
} sector;

/** Sectors that meet in their ends alone, and bound a cone that is regular closed. */
typedef struct sectors_about {
    size_t count, capacity;
    sector *item;
} sectors_about;

void sectors_about_clear(sectors_about *list);

/**
 * Append the sectors of a simplex of `side` at a point of it, in the fixed solid's space.
 * @param zero the sides of the simplex that hold the point
 */
void sectors_about_add(sectors_about *list, placing *p, pair_side side, uint32_t simplex,
                       unsigned zero);

/** Have the two open cones a direction in common (proofs/collision.md C111)? 0 after a failure. */
int open_cones_meet(placing *p, const sectors_about *a, const sectors_about *b);

#endif
