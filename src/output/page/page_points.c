/* Points: typed arrays by which they are drawn, and for each a line of text with the answer.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/page/page.h"

#include <math.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "decide/verdict/verdict.h"

enum { DECIMAL_DIGITS = 12 };
/* The greatest number of points whose roots are written exactly; points that are wrong or `on` have
 * precedence. */
enum { EXACT_MOST = 20000 };

/* The number of digits of a time that leaves DECIMAL_DIGITS digits in its difference from the
 * motion's start. */
static int decimal_digits(const graze_motion *motion) {
    double from = fmpq_get_d(motion->piece[0].lo);
    double length = fmpq_get_d(motion->piece[motion->piece_count - 1].hi) - from;
    double more = from != 0 && length > 0 ? log10(fabs(from) / length) : 0;
    return DECIMAL_DIGITS + (more > 3 && more < 30 ? (int)ceil(more) : 0);
}

/* Put a time: a ratio; or the decimal of a root and, if `exact`, its polynomial and interval, with
 * tildes between them. */
static void put_page_time(text *out, const graze_time *time, int exact) {
    if (time_is_rational(time)) {
        text_rational(out, time->low);
        return;
    }
    text_owned(out, decimal_of_time(NULL, time, decimal_digits(time->motion)));
    text_put(out, "~");
    if (exact)
        text_coefficients(out, time->poly);
    text_put(out, "~");
    if (exact)
        text_rational(out, time->low);
    text_put(out, "~");
    if (exact)
        text_rational(out, time->high);
}

/* Put X or T for the kind of a contact, then the cells: `X f3 e1-2 v5`, `T p0`. */
static void put_page_cells(text *out, const char *kind, const contact *c) {
    static const char letters[] = " fevp";
    text_put(out, kind);
    for (size_t k = 0; k < c->cell_count; k++) {
        const graze_cell *cell = &c->cell[k];
        text_format(out, " %c%zu", letters[cell->kind], cell->a);
        if (cell->kind == GRAZE_CELL_EDGE)
            text_format(out, "-%zu", cell->b);
    }
}

static void put_page_contact(text *out, const char *kind, const contact *c, int exact) {
    put_page_time(out, c->from, exact);
    text_put(out, ",");
    if (c->from != c->to)
        put_page_time(out, c->to, exact);
    text_put(out, ",");
    put_page_cells(out, kind, c);
}

/* Put the contacts. If a state is not decided, the place of the first such state, the reason and
 * pmc follow, each behind a bar. */
static void put_contacts_of(text *out, const graze_trace *trace, int exact) {
    for (size_t k = 0; k < trace->contact_count; k++) {
        const contact *c = &trace->contact[k];
        int crossing = verdict_kind(c->left, c->right) == GRAZE_INTERSECTION;
        text_put(out, k ? ";" : "");
        put_page_contact(out, crossing ? "X" : "T", c, exact);
    }
    if (trace->undecided) {
        text_put(out, "|");
        put_page_contact(out, "U", &trace->undecided->where, exact);
        text_format(out, "|%s|%s", trace->undecided->reason, graze_pmc_name(trace->verdict.pmc));
    }
}

/* The lists of the object, which are filled at the same time. */
typedef struct page_lists {
    json_writer lines;
    encoder place, tone;
    size_t exact; /* points told exactly so far */
} page_lists;

/* Put a point's line: coordinates, word, definition, case, i and t, contacts. */
static void put_page_line(json_writer *w, const fmpq *point, int d, const graze_trace *trace,
                          int exact) {
    const graze_verdict *v = &trace->verdict;
    json_line(w, 0);
    text *out = json_begin(w, NULL);
    text_put(out, "\"");
    for (int i = 0; i < d; i++) {
        text_put(out, i ? " " : "");
        text_rational(out, point + i);
    }
    text_format(out, "|%s|%d %d %lu %lu|", trace->word, v->definition, v->case_, v->i, v->t);
    put_contacts_of(out, trace, exact);
    text_put(out, "\"");
}

static graze_status put_page_point(page_lists *l, graze_context *context, const graze_scene *scene,
                                   const draw_request *request, size_t k, const double *centre) {
    int d = scene->motion->dimension;
    const fmpq *point = request->points + k * (size_t)d;
    graze_trace trace;
    TRY(classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS));
    graze_status status = trace_canonicalise(&trace, context);
    int asked = request->point_count <= EXACT_MOST || trace.verdict.pmc == GRAZE_ON ||
                (request->answers && request->answers[k]);
    int exact = asked && l->exact < EXACT_MOST;
    if (!status) {
        l->exact += (size_t)exact;
        put_page_line(&l->lines, point, d, &trace, exact);
        encode_place(&l->place, point, centre, d);
        encode_byte(&l->tone, (unsigned char)tone_of(&trace.verdict));
        status = context_poll(context);
    }
    trace_clear(&trace);
    return status;
}

/* 1 if each point's name is its number, counted from 1, as for points without names. */
static int are_numbers(const char *const *names, size_t count) {
    char number[24];
    int same = 1;
    for (size_t k = 0; k < count && same; k++) {
        snprintf(number, sizeof number, "%zu", k + 1);
        same = strcmp(names[k], number) == 0;
    }
    return same;
}

/* Put texts of points as a JSON array, with 0 for a missing text; 0 in place of the array if there
 * are no texts. */
static void put_page_texts(json_writer *w, const char *key, const char *const *texts,
                           size_t count) {
    json_line(w, 0);
    if (!texts) {
        json_count(w, key, 0);
        return;
    }
    json_open(w, key, '[');
    for (size_t k = 0; k < count; k++)
        if (texts[k])
            encode_string(w, NULL, texts[k]);
        else
            json_count(w, NULL, 0);
    json_close(w, ']');
}

/* Put the candidate's answers under the numbers of their points; most points have none. */
static void put_page_answers(json_writer *w, const char *const *answers, size_t count) {
    char number[24];
    json_line(w, 0);
    json_open(w, "answers", '{');
    for (size_t k = 0; k < count && answers; k++) {
        snprintf(number, sizeof number, "%zu", k);
        if (answers[k])
            encode_string(w, number, answers[k]);
    }
    json_close(w, '}');
}

graze_status page_rows(json_writer *w, graze_context *context, const graze_scene *scene,
                       const draw_request *request, const double *centre) {
    size_t count = request->point_count;
    HELD(text, places);
    HELD(text, tones);
    HELD(text, lines);
    page_lists l = {.lines = {.out = &lines}};
    encode_begin(&l.place, &(json_writer){.out = &places}, NULL);
    encode_begin(&l.tone, &(json_writer){.out = &tones}, NULL);
    json_open(&l.lines, NULL, '[');
    for (size_t k = 0; k < count; k++)
        TRY(put_page_point(&l, context, scene, request, k, centre));
    encode_end(&l.place);
    encode_end(&l.tone);
    json_close(&l.lines, ']');
    json_open(w, "points", '{');
    text_owned(json_begin(w, "places"), text_take(&places));
    json_line(w, 0);
    text_owned(json_begin(w, "tones"), text_take(&tones));
    json_line(w, 0);
    text_owned(json_begin(w, "lines"), text_take(&lines));
    put_page_texts(w, "names", are_numbers(request->names, count) ? NULL : request->names, count);
    put_page_texts(w, "strata", request->strata, count);
    put_page_answers(w, request->answers, count);
    json_close(w, '}');
    return GRAZE_OK;
}
