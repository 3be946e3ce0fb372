/* The work that many points of a scene ask for, bounded before it is begun.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_DEMAND_H
#define GRAZE_SCENE_DEMAND_H

#include "decide/scene/scene.h"

/** Work of finding the roots of a polynomial: n s / 256 for n coefficients, where s is the sum of w
 * + w^2/64 over them and w the words of one. */
double demand_of_roots(const fmpz_poly_t p);

/** GRAZE_ELIMIT where this work, of the functions of the motion's largest piece, exceeds the limit
 * `work` for `points` points together; `what` they are for. */
graze_status demand_check(graze_context *context, const graze_scene *scene, double points,
                          const char *what);

#endif
