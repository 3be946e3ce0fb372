/* The public function of pictures: argument checks, defaults, one call.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <math.h>
#include "output/draw/draw.h"
#include "output/page/page.h"
#include "questions/topo/topo.h"

/* The message for a fault of the options; NULL if there is none. */
static const char *misused(const graze_draw_options *o, int d) {
    if (o->title && strlen(o->title) > 512)
        return "title must have at most 512 bytes";
    if (o->surface < -1 || o->surface > 19)
        return "surface must be from -1 to 19";
    if (o->times == 1 || o->times > 64)
        return "times must be from 2 to 64";
    if (!o->low != !o->high)
        return "low and high must both be given or both be NULL";
    if (d == 3 && o->plane && (o->plane_axis < 0 || o->plane_axis > 2))
        return "plane_axis must be 0, 1 or 2";
    if (d == 2 && (o->plane || o->normal))
        return "a plane belongs to scenes of dimension 3";
    if (o->normal && !mpq_sgn(o->normal[0]) && !mpq_sgn(o->normal[1]) && !mpq_sgn(o->normal[2]))
        return "normal must not be 0";
    if (o->point_count && (!o->points || !o->names))
        return "points and names must not be NULL";
    if (o->by != GRAZE_DRAW_BY_CLASS && o->by != GRAZE_DRAW_BY_DISTANCE)
        return "by must be GRAZE_DRAW_BY_CLASS or GRAZE_DRAW_BY_DISTANCE";
    for (int k = 0; k < 3; k++)
        if (!(fabs(o->view[k]) < 1e100))
            return "view must be of finite numbers";
    for (size_t k = 0; k < o->point_count; k++)
        if (!o->names[k])
            return "a name must not be NULL";
    for (int k = 0; k < d && o->low; k++)
        if (mpq_cmp(o->low[k], o->high[k]) >= 0)
            return "low must be less than high in all coordinates";
    return NULL;
}

/* The caller's rationals one after the other: low, high, plane, normal, points. */
static graze_status take_numbers(fmpq *out, graze_context *context, const graze_draw_options *o,
                                 size_t d) {
    for (size_t k = 0; k < d && o->low; k++) {
        TRY(api_rational(out + k, context, o->low[k]));
        TRY(api_rational(out + d + k, context, o->high[k]));
    }
    if (o->plane)
        TRY(api_rational(out + 2 * d, context, *o->plane));
    for (size_t k = 0; k < 3 && o->normal; k++)
        TRY(api_rational(out + 2 * d + 1 + k, context, o->normal[k]));
    for (size_t k = 0; k < o->point_count * d; k++)
        TRY(api_coordinate(context, api_rational(out + 2 * d + 4 + k, context, o->points[k]),
                           "point", k / d, k % d));
    return GRAZE_OK;
}

/* Turn a normal along an axis into the plane orthogonal to this axis (plane_axis). */
static void take_axis(draw_request *request, fmpq *plane) {
    int axis = -1, others = 0;
    for (int k = 0; k < 3; k++) {
        if (fmpq_is_zero(request->normal + k))
            continue;
        others += axis >= 0;
        axis = k;
    }
    if (others || axis < 0)
        return;
    fmpq_div(plane, plane, request->normal + axis);
    request->plane_axis = axis;
    request->normal = NULL;
}

unsigned graze_class_colour(graze_class class_) {
    graze_verdict verdict = {.class_ = class_};
    if (class_ < GRAZE_REGULAR || class_ > GRAZE_EXTERIOR)
        return 0;
    return tone_colour(tone_of(&verdict));
}

graze_status graze_draw(graze_context *context, const graze_scene *scene, const char *file,
                        const graze_draw_options *options) {
    PUBLIC(context, scene, file);
    graze_draw_options taken;
    TRY(api_options(&taken, sizeof taken, context, __func__, options));
    const graze_draw_options *o = &taken;
    size_t d = (size_t)scene->motion->dimension, count = 2 * d + 4 + o->point_count * d;
    const char *wrong = misused(o, (int)d);
    if (wrong)
        return api_misuse(context, "graze_draw", wrong);
    int page = file_has_extension(file, "html");
    REFUSED(o->proof && !(page && o->proof[0] && o->proof[1] && o->proof[2]),
            "proof goes with .html, and has three names or four");
    if (page && o->surface > 0)
        TRY(api_takes(context, "graze_draw: surface", scene->solid));
    if (o->by == GRAZE_DRAW_BY_DISTANCE)
        TRY(api_takes(context, "graze_draw: by distance", scene->solid));
    TRY(api_takes(context, "graze_draw", scene->solid));
    LOCAL_VEC(fmpq, numbers, (slong)count);
    TRY(take_numbers(numbers, context, o, d));
    int seen = o->view[0] != 0 || o->view[1] != 0 || o->view[2] != 0;
    draw_request request = {
        .title = o->title,
        .grid = o->grid,
        .times = o->times ? o->times : 5,
        .by_distance = o->by == GRAZE_DRAW_BY_DISTANCE,
        .low = o->low ? numbers : NULL,
        .high = o->low ? numbers + d : NULL,
        .plane_axis = o->plane ? o->plane_axis : 2,
        .plane = o->plane ? numbers + 2 * d : NULL,
        .normal = o->normal ? numbers + 2 * d + 1 : NULL,
        .view = {seen ? o->view[0] : 2, seen ? o->view[1] : -3, seen ? o->view[2] : 2},
        .points = numbers + 2 * d + 4,
        .point_count = o->point_count,
        .names = o->names,
        .strata = o->strata,
        .answers = o->answers,
        .proof = o->proof,
        .surface = o->surface < 0 ? 0
                   : o->surface   ? (unsigned)o->surface
                   : d == 2       ? 8
                                  : 5,
    };
    if (o->normal)
        take_axis(&request, numbers + 2 * d);
    return (page ? page_write : draw_picture)(context, scene, file, &request);
}

/* The message for a fault of the call; NULL if there is none. */
static const char *misused_cones(const graze_scene *scene, const char *file,
                                 const graze_trace *trace) {
    if (!file_has_extension(file, "svg") && !file_has_extension(file, "png") &&
        !file_has_extension(file, "pdf"))
        return "the extension is that of no picture; expected .svg, .png or .pdf";
    if (scene->motion->dimension != 2)
        return "cones are drawn in scenes of dimension 2";
    if (scene->options.operation != GRAZE_SWEEP)
        return "cones are drawn of a sweep";
    if (trace->verdict.pmc != GRAZE_ON)
        return "cones are drawn about a point that is `on`";
    return NULL;
}

graze_status graze_draw_cones(graze_context *context, const graze_scene *scene, const char *file,
                              graze_rationals point, const graze_trace *trace) {
    PUBLIC(context, scene, file, point, trace);
    const char *wrong = misused_cones(scene, file, trace);
    if (wrong)
        return api_misuse(context, "graze_draw_cones", wrong);
    TRY(api_takes(context, "graze_draw_cones", scene->solid));
    LOCAL_VEC(fmpq, p, scene->motion->dimension);
    TRY(api_point(p, context, scene, point));
    topo_finding found;
    finding_init(&found);
    graze_status status = topo_decide(&found, context, scene, p, trace);
    if (!status)
        status = draw_cones(context, scene, file, p, &found);
    finding_clear(&found);
    return status;
}
