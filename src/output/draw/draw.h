/* The picture of a scene: classes on a grid of cells, positions of the solid, trajectories.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_DRAW_H
#define GRAZE_DRAW_DRAW_H

#include "decide/scene/scene.h"
#include "output/draw/request.h"

/** Make a picture and write it to a file. @return what graze_draw does */
graze_status draw_picture(graze_context *context, const graze_scene *scene, const char *file,
                          const draw_request *request);

#endif
