/* The points of a page: answers and contacts, from which the page makes its sentences.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_PAGE_PAGE_POINTS_H
#define GRAZE_PAGE_PAGE_POINTS_H

#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "output/draw/request.h"

/**
 * All points of a request as an object of JSON (src/output/page/README.md).
 * @param centre  that of the page's box, from which places are told
 */
graze_status page_rows(text *out, graze_context *context, const graze_scene *scene,
                       const draw_request *request, const double *centre);

#endif
