/* The public functions of distances. SPDX-License-Identifier: GPL-3.0-or-later */
#include "api/api.h"

#include <math.h>
#include "base/number/rounding.h"
#include "decide/verdict/verdict.h"
#include "graze/distance.h"
#include "questions/distance/distance.h"

graze_status api_enclose(graze_enclosure *out, graze_context *context, const graze_scene *scene,
                         const fmpq *point, double tolerance) {
    graze_trace trace;
    distance found;
    TRY(classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS));
    graze_status status = distance_find(&found, context, scene, point, &trace, tolerance);
    graze_enclosure made = {found.low, found.high, 0, trace.verdict.pmc, found.wide};
    if (!status)
        status = distance_time_near(&made.time, context, &found, scene->motion);
    if (!status)
        *out = made;
    trace_clear(&trace);
    return status;
}

/* Enclose the distances of points given as rationals or, if `rationals` is NULL, as doubles. */
static graze_status enclose_points(graze_enclosure *out, graze_context *context,
                                   const char *function, const graze_scene *scene,
                                   graze_rationals rationals, const double *doubles, size_t n,
                                   double tolerance) {
    if (!context || !scene || (n && (!out || (!rationals && !doubles))))
        return api_misuse(
            context, function,
            "context and scene, and with n > 0 also out and points, must not be NULL");
    if (!(tolerance > 0 && isfinite(tolerance)))
        return api_misuse(context, function, "tolerance must be positive and finite");
    TRY(api_takes(context, function, scene->solid));
    if (n)
        memset(out, 0, n * sizeof *out);
    IN_ENVIRONMENT();
    size_t d = (size_t)scene->motion->dimension;
    LOCAL_VEC(fmpq, point, (slong)d);
    for (size_t p = 0; p < n; p++) {
        graze_status status =
            rationals ? api_point(point, context, scene, rationals + p * d) : GRAZE_OK;
        for (size_t k = 0; doubles && k < d && !status; k++)
            status = rational_from_double(point + k, context, doubles[p * d + k]);
        if (!status)
            status = api_enclose(out + p, context, scene, point, tolerance);
        TRY(context_item(context, status, "point", p, NULL));
    }
    return GRAZE_OK;
}

graze_status graze_distances(graze_enclosure *out, graze_context *context, const graze_scene *scene,
                             graze_rationals points, size_t n, double tolerance) {
    return enclose_points(out, context, __func__, scene, points, NULL, n, tolerance);
}

graze_status graze_distances_doubles(graze_enclosure *out, graze_context *context,
                                     const graze_scene *scene, const double *points, size_t n,
                                     double tolerance) {
    return enclose_points(out, context, __func__, scene, NULL, points, n, tolerance);
}

graze_status graze_scene_diagonal(double *out, graze_context *context, const graze_scene *scene) {
    PUBLIC(out, context, scene);
    TRY(api_takes(context, "graze_scene_diagonal", scene->solid));
    return distance_diagonal(out, context, scene);
}

graze_status graze_scene_width(double *out, graze_context *context, const graze_scene *scene,
                               double fraction) {
    double unit;
    PUBLIC(out, context, scene);
    REFUSED(!(fraction > 0 && isfinite(fraction)), "fraction must be positive and finite");
    TRY(api_takes(context, "graze_scene_width", scene->solid));
    TRY(distance_diagonal(&unit, context, scene));
    double width = fraction * unit;
    width = width > 0 && isfinite(width) ? nextafter(width, 0) : 0;
    if (!(width > 0))
        return context_fail(
            context, GRAZE_ELIMIT,
            "sdf times the diagonal is beyond doubles; expected a width between 1e-307 and 1e307");
    *out = width;
    return GRAZE_OK;
}
