/* The page, put together from its template.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include "base/context/file.h"
#include "base/context/scope.h"
#include "questions/certify/certify.h"

/* Put the names and colours of all tones, in the order of their numbers. */
static void put_tones(json_writer *w) {
    json_open(w, "tones", '[');
    for (int t = 0; t < TONE_COUNT; t++) {
        json_open(w, NULL, '[');
        json_text(w, NULL, tone_name((tone)t));
        text_format(json_begin(w, NULL), "\"#%06x\"", tone_colour((tone)t));
        json_close(w, ']');
    }
    json_close(w, ']');
}

static graze_status put_scene_box(json_writer *w, double centre[3], graze_context *context,
                                  const graze_scene *scene, const draw_request *request) {
    int d = scene->motion->dimension;
    double box[6];
    LOCAL_VEC(fmpq, own, 2 * d);
    const fmpq *low = request->low ? request->low : own;
    const fmpq *high = request->low ? request->high : own + d;
    TRY(request->low ? GRAZE_OK : scene_box(own, own + d, context, scene));
    json_open(w, "box", '[');
    for (int k = 0; k < 2 * d; k++) {
        box[k] = fmpq_get_d(k < d ? low + k : high + k - d);
        json_double(w, NULL, box[k]);
    }
    json_close(w, ']');
    for (int k = 0; k < d; k++)
        centre[k] = (box[k] + box[k + d]) / 2;
    return range_check(context, box, box + d, d);
}

/* Put a solid; for a curved one the approximation of eye_solid_make, and the titles of its
 * primitives. */
static graze_status put_any_solid(json_writer *w, graze_context *context,
                                  const graze_solid *solid) {
    const csg *curved = solid->curved;
    graze_solid made;
    if (!curved)
        return page_solid(w, context, solid);
    graze_status status = eye_solid_make(&made, context, curved);
    if (!status)
        status = page_solid(w, context, &made);
    eye_solid_clear(&made);
    json_line(w, 0);
    json_open(w, "primitives", '[');
    for (size_t k = 0; k < curved->primitive_count; k++)
        encode_string(w, NULL, curved->primitive[k].title);
    json_close(w, ']');
    return status;
}

/* Put each byte of the files by which graze-check proves the points, and of its page. */
static graze_status put_proof(json_writer *w, graze_context *context, const graze_scene *scene,
                              const char *const *path) {
    static const char *const kinds[] = {"solid", "motion", "certificate", "checker"};
    const unsigned char *own[] = {scene->solid->input.sha256, scene->motion->sha256};
    const certifier c = {.scene = scene};
    HELD(text, head);
    TRY(certify_head(&head, context, &c));
    const char *signs = head.failed ? NULL : strstr(head.data, "signs ");
    json_open(w, "proof", '{');
    for (int k = 0; k < 4 && path[k] && signs; k++) {
        FREED(char, content, NULL);
        unsigned char hash[32];
        size_t length;
        encoder e;
        TRY(file_read(&content, &length, hash, context, path[k]));
        if (k < 2    ? memcmp(hash, own[k], sizeof hash) != 0
            : k == 2 ? strncmp(content, head.data, (size_t)(signs - head.data)) != 0
                     : !strstr(content, "<title>graze-check</title>"))
            return context_fail_in(context, GRAZE_EINPUT, path[k], 0, "is no %s of this scene",
                                   kinds[k]);
        encode_begin(&e, w, kinds[k]);
        for (size_t i = 0; i < length; i++)
            encode_byte(&e, (unsigned char)content[i]);
        encode_end(&e);
    }
    json_close(w, '}');
    w->out->failed |= head.failed;
    return GRAZE_OK;
}

static graze_status put_scene(json_writer *w, graze_context *context, const graze_scene *scene,
                              const draw_request *request) {
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    double centre[3];
    json_open(w, NULL, '{');
    json_text(w, "version", GRAZE_VERSION);
    json_count(w, "dimension", (unsigned long)scene->motion->dimension);
    json_text(w, "operation", unsweep ? "unsweep" : "sweep");
    json_text(w, "folds", scene->options.folds == GRAZE_FOLDS_COMBINED ? "combined" : "separate");
    json_number(w, "meet",
                scene->ends == GRAZE_ENDS_MEET    ? "true"
                : scene->ends == GRAZE_ENDS_APART ? "false"
                                                  : "null");
    json_bool(w, "since", time_origin(NULL, scene->motion));
    json_count(w, "times", request->times);
    encode_string(w, "title", request->title ? request->title : "");
    put_tones(w);
    TRY(put_scene_box(w, centre, context, scene, request));
    json_line(w, 0);
    page_motion(w, scene->motion, scene->options.operation);
    json_line(w, 0);
    TRY(put_any_solid(w, context, scene->solid));
    json_line(w, 0);
    TRY(page_surface(w, context, scene, request, centre));
    json_line(w, 0);
    page_mesh(w, request, centre);
    json_line(w, 0);
    TRY(page_cells(w, context, scene, request));
    json_line(w, 0);
    TRY(page_rows(w, context, scene, request, centre));
    if (request->proof)
        TRY(put_proof(w, context, scene, request->proof));
    json_close(w, '}');
    return GRAZE_OK;
}

/* Put the template up to a mark, and return the text behind the mark. */
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
    TRY(put_scene(&(json_writer){.out = &out}, context, scene, request));
    rest = put_until(&out, rest, "@PROGRAM@");
    for (size_t k = 0; asset_program[k]; k++)
        text_put(&out, asset_program[k]);
    text_put(&out, rest);
    return out.failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory for a page")
                      : save_file(context, file, &out);
}
