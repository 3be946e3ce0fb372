/* The public functions of OpenSCAD's `.csg` files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <stdio.h>
#include "base/context/file.h"
#include "input/scad/scad.h"

/* The hash of an OpenSCAD file, the `.csg.json` text made of it, and the report. */
typedef struct scad_work {
    unsigned char sha256[32];
    text made, report, note;
} scad_work;

static void scad_work_init(scad_work *w) {
    text_init(&w->made);
    text_init(&w->report);
    text_init(&w->note);
}

static void scad_work_clear(scad_work *w) {
    text_clear(&w->made);
    text_clear(&w->report);
    text_clear(&w->note);
}

/* Write the `.csg.json` text of a file and read the solid from it. The text's numbers are already
 * rounded. */
static graze_status read_made(graze_solid **out, scad_work *w, graze_context *context,
                              const char *path, const scad_choice *choice) {
    FREED(char, bytes, NULL);
    size_t length;
    graze_rounding rounding = context->rounding;
    TRY(file_read(&bytes, &length, w->sha256, context, path));
    TRY(scad_write(&w->made, &w->report, &w->note, context, path, bytes, length, choice));
    if (w->made.failed || w->report.failed || w->note.failed)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a solid");
    context->rounding = GRAZE_ROUND_NONE;
    graze_status status =
        solid_create_curved_text(out, context, path, w->made.data, w->made.length, w->sha256);
    context->rounding = rounding;
    if (!status && w->note.length > 0)
        snprintf((*out)->note, sizeof(*out)->note, "%s", w->note.data);
    return status;
}

graze_status api_scad_solid(graze_solid **out, graze_context *context, const char *path,
                            const unsigned char *sha256) {
    HELD(scad_work, w);
    scad_choice as_it_stands = {.smooth = 0};
    *out = NULL;
    TRY(read_made(out, &w, context, path, &as_it_stands));
    if (!sha256 || memcmp(sha256, w.sha256, sizeof w.sha256) == 0)
        return GRAZE_OK;
    graze_solid_destroy(*out);
    *out = NULL;
    return solid_is_another(context, path);
}

/* Check the caller's options and take them over. */
static graze_status take_choice(scad_choice *out, fmpq_t tolerance, graze_context *context,
                                const graze_scad_options *o) {
    *out = (scad_choice){.smooth = o->smooth};
    if (o->smooth < 0)
        return api_misuse(context, "graze_scad_text", "smooth must be 0 or more");
    if (!o->near_rotation)
        return GRAZE_OK;
    graze_status status = api_rational(tolerance, context, o->near_rotation);
    if (!status && fmpq_sgn(tolerance) <= 0)
        status = api_misuse(context, "graze_scad_text", "near_rotation must be positive");
    out->near_rotation = tolerance;
    return status;
}

graze_status graze_scad_text(char **out, char **report, graze_context *context, const char *path,
                             const graze_scad_options *options) {
    graze_scad_options o;
    graze_solid *solid = NULL;
    scad_choice choice;
    HELD(scad_work, w);
    EMPTY(out);
    EMPTY(report);
    PUBLIC(out, context, path);
    TRY(api_options(&o, sizeof o, context, __func__, options));
    LOCAL(fmpq, tolerance);
    TRY(take_choice(&choice, tolerance, context, &o));
    TRY(read_made(&solid, &w, context, path, &choice));
    graze_solid_destroy(solid);
    if (w.note.length > 0)
        text_format(&w.report, "%s\n", w.note.data);
    TRY(text_finish(out, context, &w.made));
    if (!report || !text_finish(report, context, &w.report))
        return GRAZE_OK;
    graze_free(*out);
    *out = NULL;
    return GRAZE_ESYSTEM;
}
