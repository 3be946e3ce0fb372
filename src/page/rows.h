/* The points of a page: answers and contacts, from which the page makes its sentences.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_PAGE_ROWS_H
#define GRAZE_PAGE_ROWS_H

#include "draw/request.h"
#include "number/text.h"
#include "scene/scene.h"

/** All points of a request as an array of JSON (src/page/README.md). */
graze_status page_rows(text *out, graze_context *context, const graze_scene *scene,
                       const draw_request *request);

#endif
