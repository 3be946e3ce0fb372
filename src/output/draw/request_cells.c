/* The plane and the box of a request, and its cells in them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/draw.h"

#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "output/draw/panel.h"
#include "output/draw/views.h"

/* The scene's box with a margin of 1/16 of its longest side. */
static graze_status roomy_box(fmpq *low, fmpq *high, graze_context *context,
                              const graze_scene *scene) {
    int d = scene->motion->dimension;
    graze_status status = scene_box(low, high, context, scene);
    LOCAL_VEC(fmpq, margin, 2);
    fmpq *side = margin + 1;
    for (int k = 0; k < d; k++) {
        fmpq_sub(side, high + k, low + k);
        if (fmpq_cmp(side, margin) > 0)
            fmpq_set(margin, side);
    }
    fmpq_div_2exp(margin, margin, 4);
    for (int k = 0; k < d; k++) {
        fmpq_sub(low + k, low + k, margin);
        fmpq_add(high + k, high + k, margin);
    }
    return status;
}

/* The cells of an oblique plane: u and v are their axes. */
static graze_status lay_out_section(cells *out, section *oblique, graze_context *context,
                                    const draw_request *request, const fmpq *low,
                                    const fmpq *high) {
    static const int axis[2] = {0, 1};
    LOCAL_VEC(fmpq, least, 2);
    LOCAL_VEC(fmpq, most, 2);
    LOCAL_VEC(fmpq, middle, 3);
    LOCAL(fmpq, place);
    for (int k = 0; k < 3; k++) {
        fmpq_add(middle + k, low + k, high + k);
        fmpq_div_2exp(middle + k, middle + k, 1);
    }
    _fmpq_vec_dot(place, request->normal, middle, 3);
    if (request->plane)
        fmpq_set(place, request->plane);
    section_make(oblique, request->normal, place);
    graze_status status = GRAZE_OK;
    if (!section_extent(least, most, oblique, low, high))
        status = context_fail(context, GRAZE_EUSE, "the plane does not pass through the box");
    fmpq_zero(place);
    if (!status)
        status = cells_layout(out, context, 2, axis, least, most, place, request->grid,
                              request->by_distance);
    out->section = oblique;
    return status;
}

static graze_status lay_out_cells(cells *out, graze_context *context, const draw_request *request,
                                  int d, const fmpq *low, const fmpq *high) {
    int axis[2] = {0, 1};
    LOCAL(fmpq, place);
    if (d == 3) {
        axis[0] = request->plane_axis == 0;
        axis[1] = request->plane_axis == 2 ? 1 : 2;
        fmpq_add(place, low + request->plane_axis, high + request->plane_axis);
        fmpq_div_2exp(place, place, 1);
        if (request->plane)
            fmpq_set(place, request->plane);
    }
    graze_status status =
        cells_layout(out, context, d, axis, low, high, place, request->grid, request->by_distance);
    return status;
}

graze_status request_cells(cells *out, section *oblique, graze_context *context,
                           const graze_scene *scene, const draw_request *request) {
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, low, d);
    LOCAL_VEC(fmpq, high, d);
    if (!request->low)
        TRY(roomy_box(low, high, context, scene));
    for (int k = 0; k < d && request->low; k++) {
        fmpq_set(low + k, request->low + k);
        fmpq_set(high + k, request->high + k);
    }
    TRY(request->normal ? lay_out_section(out, oblique, context, request, low, high)
                        : lay_out_cells(out, context, request, d, low, high));
    TRY(demand_check(context, scene, (double)out->count[0] * (double)out->count[1],
                     "the cells of a picture"));
    return (request->by_distance ? cells_measure : cells_classify)(out, context, scene);
}
