/* The picture of what contacts cover of the directions about an `on` point of E^2.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_CONES_H
#define GRAZE_DRAW_CONES_H

#include "decide/scene/scene.h"
#include "questions/topo/finding.h"

/** Draw it and write it to a file. @return what graze_draw_cones does */
graze_status draw_cones(graze_context *context, const graze_scene *scene, const char *file,
                        const fmpq *point, const topo_finding *topo);

#endif
