/* The size of a scene, which relative tolerances are relative to.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_DIAGONAL_H
#define GRAZE_DISTANCE_DIAGONAL_H

#include "scene/scene.h"

/** The diagonal of the box of S^0's corners, rounded down. */
graze_status distance_diagonal(double *out, graze_context *context, const graze_scene *scene);

#endif
