/* The size of a scene, which relative tolerances are relative to.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_DIAGONAL_H
#define GRAZE_DISTANCE_DIAGONAL_H

#include "decide/scene/scene.h"

/** The diagonal of the box of S^0's corners, rounded down.
 * @return GRAZE_ELIMIT beyond 2^-300 to 2^300, GRAZE_ECANCELED */
graze_status distance_diagonal(double *out, graze_context *context, const graze_scene *scene);

#endif
