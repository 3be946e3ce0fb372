/* The page, put together from its template.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include <flint/fmpq_vec.h>
#include <string.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "input/csg/csg.h"
#include "input/solid/solid.h"
#include "output/draw/draw.h"
#include "output/report/report.h"

/* The names and colours of the picture's one palette, in the order of their numbers. */
static void put_tones(text *out) {
    text_put(out, "[");
    for (int t = 0; t < TONE_COUNT; t++) {
        text_put(out, t ? "," : "");
        text_format(out, "[\"%s\",\"#%06x\"]", tone_name((tone)t), tone_colour((tone)t));
    }
    text_put(out, "]");
}

static graze_status put_box(text *out, double box[6], graze_context *context, const fmpq *low,
                            const fmpq *high, int d) {
    for (int k = 0; k < 2 * d; k++) {
        box[k] = fmpq_get_d(k < d ? low + k : high + k - d);
        text_put(out, k ? "," : "[");
        encode_number(out, box[k]);
    }
    text_put(out, "]");
    return range_check(context, box, box + d, d);
}

static graze_status put_scene_box(text *out, double box[6], graze_context *context,
                                  const graze_scene *scene, const draw_request *request) {
    int d = scene->motion->dimension;
    LOCAL_VEC(fmpq, own, 2 * d);
    const fmpq *low = request->low ? request->low : own;
    const fmpq *high = request->low ? request->high : own + d;
    TRY(request->low ? GRAZE_OK : scene_box(own, own + d, context, scene));
    return put_box(out, box, context, low, high, d);
}

/* A curved solid as it is made for the eye, and the titles of its primitives. */
static graze_status put_any_solid(text *out, graze_context *context, const graze_solid *solid) {
    const csg *curved = solid->curved;
    graze_solid made;
    if (!curved)
        return page_solid(out, context, solid);
    graze_status status = eye_solid_make(&made, context, curved);
    if (!status)
        status = page_solid(out, context, &made);
    eye_solid_clear(&made);
    text_put(out, ",\n\"primitives\":[");
    for (size_t k = 0; k < curved->primitive_count && !status; k++) {
        text_put(out, k ? "," : "");
        encode_string(out, curved->primitive[k].title);
    }
    text_put(out, "]");
    return status;
}

static graze_status put_scene(text *out, graze_context *context, const graze_scene *scene,
                              const draw_request *request) {
    int unsweep = scene->options.operation == GRAZE_UNSWEEP, d = scene->motion->dimension;
    double box[6], centre[3];
    text_format(out, "{\"version\":\"%s\",\"dimension\":%d,\"operation\":\"%s\",\"folds\":\"%s\",",
                GRAZE_VERSION, d, unsweep ? "unsweep" : "sweep",
                scene->options.folds == GRAZE_FOLDS_COMBINED ? "combined" : "separate");
    text_format(out, "\"meet\":%s,\"since\":%s,\"times\":%lu,\"title\":",
                scene->ends == GRAZE_ENDS_MEET    ? "true"
                : scene->ends == GRAZE_ENDS_APART ? "false"
                                                  : "null",
                time_origin(NULL, scene->motion) ? "true" : "false", request->times);
    encode_string(out, request->title ? request->title : "");
    text_put(out, ",\"tones\":");
    put_tones(out);
    text_put(out, ",\"box\":");
    graze_status status = put_scene_box(out, box, context, scene, request);
    for (int k = 0; k < d && !status; k++)
        centre[k] = (box[k] + box[k + d]) / 2;
    text_put(out, ",\n\"motion\":");
    page_motion(out, scene->motion, scene->options.operation);
    text_put(out, ",\n\"solid\":");
    if (!status)
        status = put_any_solid(out, context, scene->solid);
    text_put(out, ",\n\"surface\":");
    if (!status)
        status = page_surface(out, context, scene, request, centre);
    text_put(out, ",\n\"mesh\":");
    page_mesh(out, request, centre);
    text_put(out, ",\n\"cells\":");
    if (!status)
        status = page_cells(out, context, scene, request);
    text_put(out, ",\n\"points\":");
    if (!status)
        status = page_rows(out, context, scene, request, centre);
    text_put(out, "}");
    return status;
}

/* The template up to a mark, which is left out; returns what follows it. */
static const char *put_until(text *out, const char *from, const char *mark) {
    const char *at = strstr(from, mark);
    text_bytes(out, from, at ? (size_t)(at - from) : strlen(from));
    return at ? at + strlen(mark) : "";
}

graze_status page_write(graze_context *context, const graze_scene *scene, const char *file,
                        const draw_request *request) {
    HELD(text, out);
    const char *rest = put_until(&out, asset_template, "@LICENCE@");
    text_put(&out, asset_licence);
    rest = put_until(&out, rest, "@THREE@");
    text_put(&out, asset_three);
    rest = put_until(&out, rest, "@SCENE@");
    graze_status status = put_scene(&out, context, scene, request);
    rest = put_until(&out, rest, "@PROGRAM@");
    for (size_t k = 0; asset_program[k]; k++)
        text_put(&out, asset_program[k]);
    text_put(&out, rest);
    if (!status)
        status = out.failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a page")
                            : save_file(context, file, &out);
    return status;
}
