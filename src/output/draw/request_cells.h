/* The cells of a request.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_REQUEST_CELLS_H
#define GRAZE_DRAW_REQUEST_CELLS_H

#include "output/draw/class_grid.h"
#include "output/draw/request.h"

/**
 * Lay out and classify the cells of a request, and measure them where it is by distance.
 * @param[out] out      cleared by cells_clear, also on failure
 * @param[out] oblique  the plane of a request with a normal; section_clear in any case, and not
 *                      before `out`. Zeroed before.
 * @return GRAZE_ELIMIT more cells than the limit `grid`; GRAZE_EUSE the plane misses the box
 */
graze_status request_cells(cells *out, section *oblique, graze_context *context,
                           const graze_scene *scene, const draw_request *request);

#endif
