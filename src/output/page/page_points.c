/* Points as rows of JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page_points.h"

#include <stdlib.h>
#include "decide/verdict/classify.h"
#include "decide/verdict/verdict.h"
#include "output/draw/marks.h"
#include "output/page/encode.h"
#include "output/report/decimal_time.h"

enum { DECIMAL_DIGITS = 12 };

/* A ratio; or the decimal, the polynomial's coefficients, and the interval of a root. */
static void put_page_time(text *out, const graze_time *time) {
    if (time_is_rational(time)) {
        text_put(out, "\"");
        text_rational(out, time->low);
        text_put(out, "\"");
        return;
    }
    char *decimal = decimal_of_time(NULL, time, DECIMAL_DIGITS);
    out->failed |= !decimal;
    text_format(out, "[\"%s\",\"", decimal ? decimal : "");
    free(decimal);
    text_coefficients(out, time->poly);
    text_put(out, "\",\"");
    text_rational(out, time->low);
    text_put(out, "\",\"");
    text_rational(out, time->high);
    text_put(out, "\"]");
}

/* X or T for the kind, then the cells: `X f3 e1-2 v5`. */
static void put_page_cells(text *out, const contact *c) {
    static const char letters[] = " fev";
    text_put(out, verdict_kind(c->left, c->right) == GRAZE_INTERSECTION ? "\"X" : "\"T");
    for (size_t k = 0; k < c->cell_count; k++) {
        const graze_cell *cell = &c->cell[k];
        text_format(out, " %c%zu", letters[cell->kind], cell->a);
        if (cell->kind == GRAZE_CELL_EDGE)
            text_format(out, "-%zu", cell->b);
    }
    text_put(out, "\"");
}

static void put_contacts_of(text *out, const graze_trace *trace) {
    text_put(out, "[");
    for (size_t k = 0; k < trace->contact_count; k++) {
        const contact *c = &trace->contact[k];
        text_put(out, k ? "," : "");
        put_page_time(out, c->from);
        text_put(out, ",");
        if (c->from == c->to)
            text_put(out, "0");
        else
            put_page_time(out, c->to);
        text_put(out, ",");
        put_page_cells(out, c);
    }
    text_put(out, "]");
}

/* A text that may be missing. */
static void put_text_or_0(text *out, const char *const *texts, size_t k) {
    text_put(out, ",");
    if (texts && texts[k])
        encode_string(out, texts[k]);
    else
        text_put(out, "0");
}

static void put_page_row(text *out, const draw_request *request, size_t k, int d,
                         const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    text_put(out, "[\"");
    for (int i = 0; i < d; i++) {
        text_put(out, i ? " " : "");
        text_rational(out, request->points + k * (size_t)d + i);
    }
    text_format(out, "\",\"%s\",%d,%d,%d,%lu,%lu,", trace->word, (int)tone_of(v), v->definition,
                v->case_, v->i, v->t);
    encode_string(out, request->names[k]);
    put_text_or_0(out, request->strata, k);
    put_text_or_0(out, request->answers, k);
    text_put(out, ",");
    put_contacts_of(out, trace);
    text_put(out, "]");
}

graze_status page_rows(text *out, graze_context *context, const graze_scene *scene,
                       const draw_request *request) {
    int d = scene->motion->dimension;
    graze_status status = GRAZE_OK;
    text_put(out, "[");
    for (size_t k = 0; k < request->point_count && !status; k++) {
        graze_trace trace;
        const query_point point = {.rational = request->points + k * (size_t)d};
        status = classify_point(&trace, context, scene, point, TRACE_CONTACTS);
        if (status)
            break;
        status = trace_canonicalise(&trace, context);
        if (!status) {
            text_put(out, k ? ",\n" : "\n");
            put_page_row(out, request, k, d, &trace);
            status = context_poll(context);
        }
        trace_clear(&trace);
    }
    text_put(out, "]");
    return status;
}
