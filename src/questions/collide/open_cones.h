/* Do the interiors of two solids' local cones at a common point meet? A cone is given by the
 * sectors that bound it. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vectors are polynomials in u; only their directions at the placing's time matter.
 */
#ifndef GRAZE_COLLIDE_OPEN_CONES_H
#define GRAZE_COLLIDE_OPEN_CONES_H

#include "questions/collide/placing.h"

typedef struct moving_vector {
    fmpz_poly_struct c[3];
} moving_vector;

/** The positive combinations of `from` and `to`, which are independent; `normal` = from x to points
 * out of the cone. */
typedef struct sector {
    moving_vector from, to, normal;
} sector;

/** The sectors that bound a regular closed cone; they meet only in their ends. */
typedef struct sectors_about {
    size_t count, capacity;
    sector *item;
} sectors_about;

void sectors_about_clear(sectors_about *list);

/** Append the sectors that a simplex of `side` has at one of its points, in the fixed solid's
 * space.
 * @param zero the sides of the simplex that hold the point */
void sectors_about_add(sectors_about *list, placing *p, pair_side side, uint32_t simplex,
                       unsigned zero);

/** Do two open cones have a common direction (proofs/collision.md C111)? 0 after a failure. */
int open_cones_meet(placing *p, const sectors_about *a, const sectors_about *b);

#endif
