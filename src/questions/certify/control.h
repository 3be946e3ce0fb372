/* A piece of a trajectory in doubles, and simplices that it is certainly off.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CERTIFY_CONTROL_H
#define GRAZE_CERTIFY_CONTROL_H

#include "decide/trace/trajectory.h"
#include "input/solid/solid.h"

/** The control points x_k / w_k of a piece in E^3, each within 2^-48 of its size, and a box around
 * them. */
typedef struct control {
    double *at;   /* 3 * count */
    size_t count; /* 0: nothing is known, in E^2 or past the range of doubles */
    box box;
} control;

/** Room for trajectories of a degree; 0 without memory. control_clear frees it. */
int control_init(control *out, slong degree);
void control_clear(control *c);

/** Set the points from Bernstein coefficients, all those of W positive. */
void control_set(control *out, const trajectory *c, const fmpz *bernstein);

/** Is it certain that the plane form, or a side form, of a simplex has one strict sign at all
 * control points, that of the side form negative? 0 says nothing. */
int control_clears(const control *c, const graze_solid *solid, size_t simplex);

#endif
