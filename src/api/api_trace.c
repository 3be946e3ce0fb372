/* The public functions of traces, their times, and the reports.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <stdlib.h>
#include <string.h>
#include "api/api_trace.h"
#include "base/context/environment.h"
#include "decide/verdict/classify.h"
#include "decide/verdict/verdict.h"
#include "output/report/decimal_time.h"
#include "output/report/explain.h"
#include "output/report/json_rows.h"
#include "output/report/table_text.h"
#include "output/table/typed_read.h"
#include "output/table/typed_write.h"
#include "questions/distance/distance.h"
#include "questions/topo/topo.h"

graze_status graze_trace_create(graze_trace **out, graze_context *context, const graze_scene *scene,
                                graze_rationals point) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene || !point)
        return api_misuse(context, "graze_trace_create",
                          "out, context, scene and point must not be NULL");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    fmpq *p = _fmpq_vec_init(scene->motion->dimension);
    graze_trace *trace = malloc(sizeof *trace);
    graze_status status = trace ? api_point(p, context, scene, point)
                                : context_fail(context, GRAZE_ESYSTEM, "out of memory");
    if (!status)
        status =
            classify_point(trace, context, scene, (query_point){.rational = p}, TRACE_CONTACTS);
    _fmpq_vec_clear(p, scene->motion->dimension);
    if (status)
        free(trace);
    else
        *out = trace;
    return status;
}

void graze_trace_destroy(graze_trace *trace) {
    if (!trace)
        return;
    trace_clear(trace);
    free(trace);
}

const char *graze_trace_word(const graze_trace *trace) {
    return trace ? trace->word : "";
}

graze_verdict graze_trace_verdict(const graze_trace *trace) {
    graze_verdict none;
    memset(&none, 0, sizeof none);
    return trace ? trace->verdict : none;
}

size_t graze_trace_contact_count(const graze_trace *trace) {
    return trace ? trace->contact_count : 0;
}

graze_contact graze_trace_contact(const graze_trace *trace, size_t index) {
    graze_contact out;
    memset(&out, 0, sizeof out);
    if (index >= graze_trace_contact_count(trace))
        return out;
    const contact *c = &trace->contact[index];
    out.kind = verdict_kind(c->left, c->right);
    out.left = c->left;
    out.right = c->right;
    out.from = c->from;
    out.to = c->to;
    out.cells = c->cell;
    out.cell_count = c->cell_count;
    return out;
}

int graze_time_rational(mpq_t out, const graze_time *time) {
    if (!out || !time || !time_is_rational(time))
        return 0;
    api_rational_out(out, time->low);
    return 1;
}

int graze_time_degree(const graze_time *time) {
    if (!time)
        return 0;
    return time_is_rational(time) ? 1 : (int)fmpz_poly_degree(time->poly);
}

void graze_time_coefficient(mpz_t out, const graze_time *time, int k) {
    fmpz_t c;
    if (!out)
        return;
    fmpz_init(c);
    if (time && k >= 0 && time_is_rational(time)) {
        if (k == 0)
            fmpz_neg(c, fmpq_numref(time->low));
        else if (k == 1)
            fmpz_set(c, fmpq_denref(time->low));
    } else if (time && k >= 0) {
        fmpz_poly_get_coeff_fmpz(c, time->poly, k);
    }
    fmpz_get_mpz(out, c);
    fmpz_clear(c);
}

void graze_time_interval(mpq_t low, mpq_t high, const graze_time *time) {
    if (!low || !high || !time)
        return;
    (void)time_is_rational(time);
    api_rational_out(low, time->low);
    api_rational_out(high, time->high);
}

graze_status graze_time_decimal(char **out, graze_context *context, const graze_time *time,
                                int digits) {
    if (out)
        *out = NULL;
    if (!out || !context || !time)
        return api_misuse(context, "graze_time_decimal", "out, context and time must not be NULL");
    if (digits < 1 || digits > 1000)
        return api_misuse(context, "graze_time_decimal", "digits must be from 1 to 1000");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    *out = decimal_of_time(NULL, time, digits);
    return *out ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

graze_status graze_number_decimal(char **out, graze_context *context, const mpq_t value,
                                  int digits) {
    if (out)
        *out = NULL;
    if (!out || !context || !value)
        return api_misuse(context, "graze_number_decimal",
                          "out, context and value must not be NULL");
    if (digits < 0 || digits > 1000)
        return api_misuse(context, "graze_number_decimal", "digits must be from 0 to 1000");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    int finite = 1;
    fmpq_t number;
    fmpq_init(number);
    graze_status status = api_rational(number, context, value);
    if (!status)
        *out = digits ? decimal_of_rational(NULL, number, digits) : decimal_finite(&finite, number);
    fmpq_clear(number);
    if (status || *out)
        return status;
    return finite ? context_fail(context, GRAZE_ESYSTEM, "out of memory")
                  : context_fail(context, GRAZE_EINPUT, "the number has no finite decimal");
}

graze_status graze_report_header(char **out, graze_context *context, const graze_scene *scene,
                                 const char *notes, const char *columns) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene)
        return api_misuse(context, "graze_report_header",
                          "out, context and scene must not be NULL");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    return report_header(out, context, scene, notes, columns);
}

graze_status api_trace_row(text *out, graze_row_totals *totals, graze_context *context,
                           const graze_scene *scene, const fmpq *point, const graze_trace *trace,
                           graze_format format, const char *rest) {
    graze_status status = GRAZE_OK;
    topo_finding found;
    finding_init(&found);
    const topo_finding *topo = scene->options.topo ? &found : NULL;
    if (topo)
        status = topo_decide(&found, context, scene, point, trace);
    distance space = {.low = 0};
    const distance *near = scene->tolerance > 0 ? &space : NULL;
    if (!status && near)
        status = distance_find(&space, context, scene, point, trace, scene->tolerance);
    if (status == GRAZE_OK && (near || format == GRAZE_FORMAT_JSONL))
        status = trace_canonicalise(trace, context);
    if (status == GRAZE_OK && format == GRAZE_FORMAT_JSONL)
        report_json(out, scene, point, trace, topo, near);
    else if (status == GRAZE_OK)
        report_csv(out, scene, point, trace, rest, topo, near);
    if (status == GRAZE_OK && totals) {
        totals->undecided += topo && found.position == GRAZE_TOPO_UNDECIDED;
        totals->wide += near && space.wide;
    }
    finding_clear(&found);
    return status;
}

graze_status api_check_format(graze_context *context, const char *function,
                              const graze_scene *scene, graze_format format) {
    if (format != GRAZE_FORMAT_CSV && format != GRAZE_FORMAT_JSONL)
        return api_misuse(context, function, "the format is unknown");
    if (format == GRAZE_FORMAT_JSONL && scene->options.columns == GRAZE_COLUMNS_PMC)
        return api_misuse(context, function,
                          "JSON Lines have all answers; expected GRAZE_FORMAT_CSV for pmc alone");
    return GRAZE_OK;
}

graze_status graze_report_row(char **out, graze_context *context, const graze_scene *scene,
                              graze_rationals point, const graze_trace *trace, graze_format format,
                              const char *rest) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene || !point || !trace)
        return api_misuse(context, "graze_report_row",
                          "out, context, scene, point and trace must not be NULL");
    graze_status status = api_check_format(context, "graze_report_row", scene, format);
    if (status)
        return status;
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    fmpq *p = _fmpq_vec_init(scene->motion->dimension);
    text t;
    text_init(&t);
    status = api_point(p, context, scene, point);
    if (!status)
        status = api_trace_row(&t, NULL, context, scene, p, trace, format, rest);
    _fmpq_vec_clear(p, scene->motion->dimension);
    if (status) {
        text_clear(&t);
        return status;
    }
    return text_finish(out, context, &t);
}

/* Trace one point and add its row. */
static graze_status report_point(text *out, graze_row_totals *totals, graze_context *context,
                                 const graze_scene *scene, const fmpq *point, graze_format format,
                                 const char *rest) {
    graze_trace trace;
    int with_times = format == GRAZE_FORMAT_JSONL || scene->tolerance > 0;
    trace_detail detail = with_times                                    ? TRACE_CONTACTS
                          : scene->options.columns == GRAZE_COLUMNS_PMC ? TRACE_PMC
                                                                        : TRACE_WORD;
    graze_status status =
        classify_point(&trace, context, scene, (query_point){.rational = point}, detail);
    if (!status) {
        status = api_trace_row(out, totals, context, scene, point, &trace, format, rest);
        trace_clear(&trace);
    }
    return !status && out->failed ? context_fail(context, GRAZE_ESYSTEM, "out of memory") : status;
}

graze_status graze_report_points(char **out, size_t *length, size_t *done, graze_row_totals *totals,
                                 graze_context *context, const graze_scene *scene,
                                 graze_rationals points, size_t n, graze_format format,
                                 const char *const *rest) {
    if (totals)
        *totals = (graze_row_totals){0, 0};
    if (out)
        *out = NULL;
    if (length)
        *length = 0;
    if (done)
        *done = 0;
    if (!out || !length || !done || !context || !scene || (n && !points))
        return api_misuse(context, "graze_report_points",
                          "out, length, done, context and scene, and with n > 0 also points, must "
                          "not be NULL");
    graze_status status = api_check_format(context, "graze_report_points", scene, format);
    if (status)
        return status;
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    size_t d = (size_t)scene->motion->dimension, whole = 0;
    fmpq *point = _fmpq_vec_init((slong)d);
    text t;
    text_init(&t);
    for (size_t k = 0; k < n && !status; k++) {
        status = api_point(point, context, scene, points + k * d);
        if (!status)
            status = report_point(&t, totals, context, scene, point, format, rest ? rest[k] : NULL);
        whole = status ? whole : t.length;
        *done += !status;
    }
    _fmpq_vec_clear(point, (slong)d);
    if (*done) {
        t.data[whole] = '\0';
        *length = whole;
        *out = t.data;
    } else {
        text_clear(&t);
    }
    return status;
}

graze_status graze_report_point(char **out, graze_context *context, const graze_scene *scene,
                                graze_rationals point, graze_format format, const char *rest) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene || !point)
        return api_misuse(context, "graze_report_point",
                          "out, context, scene and point must not be NULL");
    size_t length, done;
    return graze_report_points(out, &length, &done, NULL, context, scene, point, 1, format, &rest);
}

static void put_in_text(void *to, const char *bytes, size_t length) {
    text_bytes(to, bytes, length);
}

graze_status graze_report_export(char **out, size_t *length, graze_context *context,
                                 const char *table, size_t table_length, graze_export form) {
    if (out)
        *out = NULL;
    if (length)
        *length = 0;
    if (!out || !length || !context || !table)
        return api_misuse(context, "graze_report_export",
                          "out, length, context and table must not be NULL");
    if (form != GRAZE_EXPORT_VTK && form != GRAZE_EXPORT_NPY)
        return api_misuse(context, "graze_report_export", "there is no such form");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    typed_table typed;
    text bytes;
    text_init(&bytes);
    typed_init(&typed, context);
    graze_status status = typed_add(&typed, table, table_length);
    if (!status)
        status = typed_end(&typed);
    if (!status)
        status = typed_write(&typed, form, (sink){put_in_text, &bytes});
    typed_clear(&typed);
    if (status) {
        text_clear(&bytes);
        return status;
    }
    size_t made = bytes.length;
    status = text_finish(out, context, &bytes);
    *length = status ? 0 : made;
    return status;
}

graze_status graze_report_explain(char **out, graze_context *context, const graze_scene *scene,
                                  graze_rationals point, const graze_trace *trace) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene || !point || !trace)
        return api_misuse(context, "graze_report_explain",
                          "out, context, scene, point and trace must not be NULL");
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    fmpq *p = _fmpq_vec_init(scene->motion->dimension);
    graze_status status = api_point(p, context, scene, point);
    if (!status)
        status = trace_canonicalise(trace, context);
    topo_finding found;
    finding_init(&found);
    const topo_finding *topo = scene->options.topo ? &found : NULL;
    if (!status && topo)
        status = topo_decide(&found, context, scene, p, trace);
    distance space = {.low = 0};
    const distance *near = scene->tolerance > 0 ? &space : NULL;
    if (!status && near)
        status = distance_find(&space, context, scene, p, trace, scene->tolerance);
    if (!status)
        status = report_explain(out, context, scene, p, trace, topo, near);
    finding_clear(&found);
    _fmpq_vec_clear(p, scene->motion->dimension);
    return status;
}
