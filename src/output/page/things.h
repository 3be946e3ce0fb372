/* The solid, the motion and the sweep's surface of a page.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_PAGE_THINGS_H
#define GRAZE_PAGE_THINGS_H

#include "base/number/text.h"
#include "decide/scene/scene.h"
#include "output/draw/request.h"

/** The solid as an object of JSON: vertices, triangles (E^2: none), edges. */
graze_status page_solid(text *out, graze_context *context, const graze_solid *solid);
/** The motion's pieces as an array of JSON: coefficients as doubles, which only draw. */
void page_motion(text *out, const graze_motion *motion, graze_operation operation);
/** The mesh of a request as an object of JSON; null if it has none.
 * @param centre  that of the page's box, from which places are told */
void page_mesh(text *out, const draw_request *request, const double *centre);
/** The surface of the sweep as an object of JSON; null if the request wants none.
 * @param centre  that of the page's box, from which places are told */
graze_status page_surface(text *out, graze_context *context, const graze_scene *scene,
                          const draw_request *request, const double *centre);

#endif
