/* A box that holds the sweep of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_BOX_H
#define GRAZE_SCENE_BOX_H

#include "scene/scene.h"

/**
 * A box of dyadic rationals that holds the sweep (for unsweep the unsweep).
 * @param[out] low, high d initialised rationals each
 */
graze_status scene_box(fmpq *low, fmpq *high, graze_context *context, const graze_scene *scene);

#endif
