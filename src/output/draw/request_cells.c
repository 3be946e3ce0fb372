/* The plane and the box of a request, the cells in them, and the cells' distances.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/views.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "base/number/vector.h"
#include "decide/verdict/verdict.h"
#include "questions/distance/distance.h"

/* The scene's box with a margin of 1/16 of its longest side. */
static graze_status roomy_box(fmpq *low, fmpq *high, graze_context *context,
                              const graze_scene *scene) {
    int d = scene->motion->dimension;
    TRY(scene_box(low, high, context, scene));
    LOCAL_VEC(fmpq, sides, d);
    LOCAL(fmpq, margin);
    vector_sub(sides, high, low, d);
    vector_widest(margin, sides, d);
    fmpq_div_2exp(margin, margin, 4);
    for (int k = 0; k < d; k++) {
        fmpq_sub(low + k, low + k, margin);
        fmpq_add(high + k, high + k, margin);
    }
    return GRAZE_OK;
}

/* Lay out the cells of an oblique plane, along its u and v. */
static graze_status lay_out_section(cells *out, section *oblique, graze_context *context,
                                    const draw_request *request, const fmpq *low,
                                    const fmpq *high) {
    static const int axis[2] = {0, 1};
    LOCAL_VEC(fmpq, least, 2);
    LOCAL_VEC(fmpq, most, 2);
    LOCAL_VEC(fmpq, middle, 3);
    LOCAL(fmpq, place);
    vector_middle(middle, low, high, 3);
    _fmpq_vec_dot(place, request->normal, middle, 3);
    if (request->plane)
        fmpq_set(place, request->plane);
    section_make(oblique, request->normal, place);
    if (!section_extent(least, most, oblique, low, high))
        return context_fail(context, GRAZE_EUSE, "the plane does not pass through the box");
    fmpq_zero(place);
    TRY(cells_layout(out, context, 2, axis, least, most, place, request->grid,
                     request->by_distance));
    out->section = oblique;
    return GRAZE_OK;
}

static graze_status lay_out_cells(cells *out, graze_context *context, const draw_request *request,
                                  int d, const fmpq *low, const fmpq *high) {
    int axis[2] = {0, 1};
    LOCAL(fmpq, place);
    if (d == 3) {
        axis[0] = request->plane_axis == 0;
        axis[1] = request->plane_axis == 2 ? 1 : 2;
        vector_middle(place, low + request->plane_axis, high + request->plane_axis, 1);
        if (request->plane)
            fmpq_set(place, request->plane);
    }
    return cells_layout(out, context, d, axis, low, high, place, request->grid,
                        request->by_distance);
}

/* A cell's side is this many times the width of an enclosure. */
enum { FINENESS = 64 };

static tone band_of(const cells *c, tone side, double value) {
    int k = (int)fmin(fabs(value) / c->step.size, BANDS - 1);
    return side == TONE_IN    ? (tone)(TONE_INNER + k)
           : side == TONE_OUT ? (tone)(TONE_OUTER + k)
                              : side;
}

/* Find answers and distances of all centres, choose the step of the levels such that the bands
 * reach the farthest cell, and set the tones. */
static graze_status cells_measure(cells *c, graze_context *context, const graze_scene *scene) {
    size_t count = c->count[0] * c->count[1];
    double width = fmpq_get_d(c->side) / FINENESS, most = 0;
    distance found;
    graze_pmc pmc;
    TRY(MAKE_ARRAY(context, c->distance, count, "the cells of a picture"));
    LOCAL_VEC(fmpq, point, 3);
    for (size_t k = 0; k < count; k++) {
        cells_place(point, c, 2, 2 * (k % c->count[0]) + 1, 2 * (k / c->count[0]) + 1);
        TRY(distance_at(&found, &pmc, context, scene, point, width));
        c->tone[k] = (unsigned char)(TONE_IN - 1 + (int)pmc);
        c->distance[k] = found.low + (found.high - found.low) / 2;
        TRY(context_poll(context));
        most = fmax(most, fabs(c->distance[k]));
    }
    c->step = step_for(most > 0 ? most / BANDS : 1);
    for (size_t k = 0; k < count; k++)
        c->tone[k] = (unsigned char)band_of(c, (tone)c->tone[k], c->distance[k]);
    return GRAZE_OK;
}

/* Append the multiple k of the step as a decimal. */
static void put_level(text *out, const cells *c, int k) {
    int exact;
    LOCAL(fmpq, value);
    LOCAL(fmpz, ten);
    fmpz_set_ui(ten, 10);
    fmpz_pow_ui(ten, ten, (ulong)abs(c->step.exponent));
    fmpq_set_si(value, k * c->step.mantissa, 1);
    (c->step.exponent < 0 ? fmpq_div_fmpz : fmpq_mul_fmpz)(value, value, ten);
    text_owned(out, decimal_of_rational(&exact, value, 10));
}

void band_put(text *out, const cells *c, tone t) {
    int k = t >= TONE_OUTER ? (int)(t - TONE_OUTER) : -1 - (int)(t - TONE_INNER);
    put_level(out, c, k);
    text_put(out, " to ");
    put_level(out, c, k + 1);
}

graze_status request_cells(cells *out, section *oblique, graze_context *context,
                           const graze_scene *scene, const draw_request *request) {
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, low, d);
    LOCAL_VEC(fmpq, high, d);
    if (!request->low)
        TRY(roomy_box(low, high, context, scene));
    if (request->low) {
        vector_set(low, request->low, d);
        vector_set(high, request->high, d);
    }
    TRY(request->normal ? lay_out_section(out, oblique, context, request, low, high)
                        : lay_out_cells(out, context, request, d, low, high));
    TRY(demand_check(context, scene, (double)out->count[0] * (double)out->count[1],
                     "the cells of a picture"));
    return (request->by_distance ? cells_measure : cells_classify)(out, context, scene);
}
