/* A box that holds the sweep of a scene.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCENE_BOX_H
#define GRAZE_SCENE_BOX_H

#include "decide/scene/scene.h"

/**
 * A box of dyadic rationals that holds the sweep (for unsweep the unsweep).
 * @param[out] low, high d initialised rationals each
 * @return GRAZE_ECANCELED; GRAZE_ELIMIT the weight is too near 0 for the limit `work`
 */
graze_status scene_box(fmpq *low, fmpq *high, graze_context *context, const graze_scene *scene);

#endif
