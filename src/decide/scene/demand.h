/* A bound of the work for many points of a scene, checked before the work begins.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_DEMAND_H
#define GRAZE_SCENE_DEMAND_H

#include "decide/scene/scene.h"

/** The work of finding a polynomial's roots: n s / 256 for n coefficients, where s is the sum of w
 * + w^2/64 over the coefficients with w words each. */
double demand_of_roots(const fmpz_poly_t p);

/** GRAZE_ELIMIT if this work, for the functions of the motion's largest piece and for `points`
 * points together, exceeds the limit `work`.
 * @param what the points' use, for the message */
graze_status demand_check(graze_context *context, const graze_scene *scene, double points,
                          const char *what);

#endif
