/* The velocity of trajectories at a time, as an affine function of the body point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_SPEED_H
#define GRAZE_CONTACT_SPEED_H

#include "questions/contact/site_record.h"

/** w(y) = at_zero + slope y: d rationals, and d * d row by row. */
typedef struct velocity_field {
    int dimension;
    fmpq *at_zero, *slope;
} velocity_field;

/** The fields on the sides of a time: `present` as in site_side, before t first. Where one piece is
 * on both sides they are equal. */
typedef struct speed {
    int dimension, present[2];
    velocity_field field[2];
} speed;

/** The fields on sides that were found. speed_clear in any case. */
void speed_make(speed *out, const graze_motion *motion, const site_side side[2]);
void speed_clear(speed *s);

/** g = -n w(y) on a side, for a normal of d rationals. */
void speed_along(fmpq_t out, const speed *s, int side, const fmpq *normal, const fmpq *y);

#endif
