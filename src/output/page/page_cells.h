/* The cells of a page: the plane, or a plane of space, coloured by class.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_PAGE_PAGE_CELLS_H
#define GRAZE_PAGE_PAGE_CELLS_H

#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "output/draw/request.h"

/** The cells of a request as an object of JSON (src/output/page/README.md), by class in any case.
 */
graze_status page_cells(text *out, graze_context *context, const graze_scene *scene,
                        const draw_request *request);

#endif
