/* A page of HTML that shows a scene, to be turned and asked.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The page holds all it needs: program, data, and three.js, which draws. It asks for nothing from a
 * network, and what it says of a point was decided here.
 */
#ifndef GRAZE_PAGE_PAGE_H
#define GRAZE_PAGE_PAGE_H

#include "decide/scene/scene.h"
#include "output/draw/request.h"

/** Write the page of a request. @return what graze_draw does */
graze_status page_write(graze_context *context, const graze_scene *scene, const char *file,
                        const draw_request *request);

#endif
