/* The public functions of rows and reports.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <math.h>
#include "decide/verdict/verdict.h"
#include "output/report/report.h"
#include "questions/certify/certify.h"

/* Check that the columns behind the verdict go with each other and with the form of rows. */
static graze_status check_sets(graze_context *context, const char *function,
                               const graze_row_options *shown) {
    int known = shown->columns == GRAZE_COLUMNS_ALL || shown->columns == GRAZE_COLUMNS_PMC;
    known &= shown->at_rest == 0 || shown->at_rest == 1;
    for (const column_set *set = NULL; (set = columns_next(set, shown));)
        known &= set->asked != ASKED_BY_FLAG || columns_flag(set, shown) == 1;
    if (!known)
        return api_misuse(context, function, "an option has an unknown value");
    for (const column_set *set = NULL; (set = columns_next(set, shown));) {
        if (shown->at_rest && !set->at_rest)
            return api_misuse(context, function,
                              "rows of a solid at rest have pmc and sdf, and no other answer");
        if (shown->columns == GRAZE_COLUMNS_PMC && !shown->at_rest && set->needs > NEEDS_PMC)
            return api_misuse(context, function,
                              "topo, regular, moments and sdf are decided by the contacts, which "
                              "columns of pmc alone spare");
        if (set->is_exact && shown->format > GRAZE_FORMAT_JSONL)
            return api_misuse(context, function,
                              "moments are exact times, which binary rows cannot hold");
    }
    return GRAZE_OK;
}

graze_status api_rows(graze_row_options *out, graze_context *context, const char *function,
                      const graze_row_options *options) {
    TRY(api_options(out, sizeof *out, context, function, options));
    if (!(out->format >= GRAZE_FORMAT_CSV && out->format <= GRAZE_FORMAT_NPY))
        return api_misuse(context, function, "the format is unknown");
    TRY(check_sets(context, function, out));
    if (out->at_rest)
        out->columns = GRAZE_COLUMNS_PMC;
    else if (out->columns == GRAZE_COLUMNS_PMC && out->format == GRAZE_FORMAT_JSONL)
        return api_misuse(context, function,
                          "JSON Lines have all answers; expected another format for pmc alone");
    if (!(out->sdf >= 0 && isfinite(out->sdf)))
        return api_misuse(context, function, "sdf must be a positive finite width, or 0");
    if (out->boundary && !(out->sdf > 0))
        return api_misuse(context, function, "boundary needs a width in sdf");
    int near = out->motion_error == 0 || (out->motion_error > 0 && out->sdf > 0);
    if (near && isfinite(out->motion_error))
        return GRAZE_OK;
    return api_misuse(context, function,
                      "motion_error must be positive and finite beside a width sdf, or 0");
}

/* Refuse positions and distances of curved solids, and `regular` of a sweep, which has no dangling
 * part. */
static graze_status check_scene(graze_context *context, const graze_scene *scene,
                                const graze_row_options *shown) {
    if (shown->at_rest && !scene->standing)
        return api_misuse(context, "at_rest",
                          "the scene has a motion; expected one of "
                          "graze_scene_at_rest");
    if (shown->topo || shown->regular || shown->sdf > 0)
        TRY(api_takes(context,
                      shown->topo      ? "topo"
                      : shown->regular ? "regular"
                                       : "sdf",
                      scene->solid));
    if (!shown->regular || scene->options.operation == GRAZE_UNSWEEP)
        return GRAZE_OK;
    return api_misuse(context, "regular", "the scene is a sweep; expected an unsweep");
}

/* Add the row of a point that was traced as row_detail says. `totals` are counted on, unless they
 * are NULL; `texts` may be NULL. */
static graze_status add_row(text *out, graze_row_totals *totals, graze_context *context,
                            const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                            const graze_row_texts *texts, const graze_row_options *shown) {
    row r;
    TRY(check_scene(context, scene, shown));
    graze_status status = row_answer(&r, context, scene, shown, point, trace);
    r.texts = texts ? *texts : (graze_row_texts){NULL, NULL};
    if (status == GRAZE_OK && shown->format == GRAZE_FORMAT_CSV)
        report_csv(out, &r);
    else if (status == GRAZE_OK && shown->format == GRAZE_FORMAT_JSONL)
        report_json(out, &r);
    else if (status == GRAZE_OK)
        status = report_values(out, context, &r);
    if (status == GRAZE_OK && out->failed)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    if (status == GRAZE_OK && totals) {
        totals->undecided += (unsigned long)row_is_undecided(&r);
        totals->wide += shown->sdf > 0 && r.space.wide;
    }
    row_clear(&r);
    return status;
}

graze_status graze_report_header(char **out, graze_context *context, const graze_scene *scene,
                                 const char *notes, const char *columns,
                                 const graze_row_options *options) {
    graze_row_options shown;
    PUBLIC_OUT(out, context, scene);
    TRY(api_rows(&shown, context, "graze_report_header", options));
    TRY(check_scene(context, scene, &shown));
    return report_header(out, context, scene, notes, columns, &shown);
}

graze_status graze_report_row(char **out, graze_context *context, const graze_scene *scene,
                              graze_rationals point, const graze_trace *trace,
                              const graze_row_texts *texts, const graze_row_options *options) {
    graze_row_options shown;
    PUBLIC_OUT(out, context, scene, point, trace);
    TRY(api_rows(&shown, context, __func__, options));
    REFUSED(shown.format > GRAZE_FORMAT_JSONL, "expected GRAZE_FORMAT_CSV or GRAZE_FORMAT_JSONL");
    LOCAL_VEC(fmpq, p, scene->motion->dimension);
    HELD(text, t);
    TRY(api_point(p, context, scene, point));
    TRY(add_row(&t, NULL, context, scene, p, trace, texts, &shown));
    return text_finish(out, context, &t);
}

/* Trace one point and add its rows; `table` is NULL where none is wanted. */
static graze_status trace_rows(text *table, text *certificate, graze_row_totals *totals,
                               graze_context *context, const graze_scene *scene, const certifier *c,
                               const fmpq *point, const graze_row_texts *texts,
                               const graze_row_options *shown) {
    graze_trace trace;
    trace_detail detail = c && c->with_contacts ? TRACE_CONTACTS
                          : table               ? row_detail(shown)
                                                : TRACE_WORD;
    TRY(classify_point(&trace, context, scene, (query_point){.rational = point}, detail));
    graze_status status = c ? certify_row(certificate, context, c, point, &trace) : GRAZE_OK;
    if (!status && certificate->failed)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory");
    if (!status && table)
        status = add_row(table, totals, context, scene, point, &trace, texts, shown);
    trace_clear(&trace);
    return status;
}

/* Hand over the first `length` bytes, those of whole rows; none: `*out` stays NULL. */
static void whole_rows(char **out, size_t *out_length, text *t, size_t length) {
    if (!length) {
        text_clear(t);
        return;
    }
    t->data[length] = '\0';
    *out = t->data;
    *out_length = length;
}

graze_status api_points(char **const out[2], size_t *const length[2], size_t *done,
                        graze_row_totals *totals, graze_context *context, const graze_scene *scene,
                        const certifier *certifier, graze_rationals points, size_t n,
                        const graze_row_texts *texts, const graze_row_options *shown) {
    graze_status status = GRAZE_OK;
    size_t d = (size_t)scene->motion->dimension, whole[2] = {0, 0};
    LOCAL_VEC(fmpq, point, (slong)d);
    text made[2];
    for (int m = 0; m < 2; m++)
        text_init(&made[m]);
    for (size_t k = 0; k < n && !status; k++) {
        status = api_point(point, context, scene, points + k * d);
        if (!status)
            status = trace_rows(out[0] ? made : NULL, made + 1, totals, context, scene, certifier,
                                point, texts ? texts + k : NULL, shown);
        for (int m = 0; m < 2 && !status; m++)
            whole[m] = made[m].length;
        *done += !status;
    }
    for (int m = 0; m < 2; m++)
        whole_rows(out[m], length[m], &made[m], whole[m]);
    return status;
}

graze_status graze_report_points(char **out, size_t *length, size_t *done, graze_row_totals *totals,
                                 graze_context *context, const graze_scene *scene,
                                 graze_rationals points, size_t n, const graze_row_texts *texts,
                                 const graze_row_options *options) {
    graze_row_options shown;
    EMPTY(totals);
    EMPTY(out);
    EMPTY(length);
    EMPTY(done);
    REFUSED(!out || !length || !done || !context || !scene || (n && !points),
            "out, length, done, context and scene, and with n > 0 also points, must "
            "not be NULL");
    IN_ENVIRONMENT();
    TRY(api_rows(&shown, context, __func__, options));
    if (shown.columns == GRAZE_COLUMNS_PMC)
        TRY(filter_lay_bricks(&scene->filter, context));
    char **const to[2] = {out, NULL};
    size_t *const lengths[2] = {length, NULL};
    return api_points(to, lengths, done, totals, context, scene, NULL, points, n, texts, &shown);
}

graze_status graze_report_point(char **out, graze_context *context, const graze_scene *scene,
                                graze_rationals point, const graze_row_texts *texts,
                                const graze_row_options *options) {
    PUBLIC_OUT(out, context, scene, point);
    size_t length, done;
    return graze_report_points(out, &length, &done, NULL, context, scene, point, 1, texts, options);
}

graze_status graze_report_explain(char **out, graze_context *context, const graze_scene *scene,
                                  graze_rationals point, const graze_trace *trace,
                                  const graze_row_options *options) {
    graze_row_options shown;
    PUBLIC_OUT(out, context, scene, point, trace);
    TRY(api_rows(&shown, context, __func__, options));
    TRY(check_scene(context, scene, &shown));
    LOCAL_VEC(fmpq, p, scene->motion->dimension);
    TRY(api_point(p, context, scene, point));
    TRY(trace_canonicalise(trace, context));
    row r;
    graze_status status = row_answer(&r, context, scene, &shown, p, trace);
    if (!status)
        status = report_explain(out, context, &r);
    row_clear(&r);
    return status;
}
