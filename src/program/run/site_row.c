/* Checks rows of contact points without making them again.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The answers of a row bind one another: trimmed and near_in go with the letters I of the word,
 * status with trimmed and near, and theta, order and orientation stand together or not at all.
 */
#include "program/run/site_row.h"

#include <stdlib.h>
#include <string.h>
#include "program/run/cell.h"

/* Answers behind the cell, in their order. */
enum {
    SITE_ROLE,
    SITE_THETA,
    SITE_ORDER,
    SITE_ORIENTATION,
    SITE_LEFT,
    SITE_RIGHT,
    SITE_TRIMMED,
    SITE_STATUS,
    SITE_NEAR,
    SITE_NEAR_IN,
    SITE_WORD,
    SITE_ANSWERS
};

int site_form_read(row_form *out, const char *names, int snap) {
    static const char *const of_dimension[] = {"time,bx,by,x,y,", "time,bx,by,bz,x,y,z,"};
    static const char answers[] = "cell,role,theta,contact_order,orientation,left,right,trimmed,"
                                  "status,near,near_in,word";
    field line = {names, strlen(names)}, rest;
    if (!line.length || names[line.length - 1] != '\n')
        return 0;
    line.length--;
    out->sites = 1;
    out->snap = snap;
    for (out->dimension = 2; out->dimension <= 3; out->dimension++)
        if (field_behind(&rest, line, of_dimension[out->dimension - 2]))
            break;
    if (out->dimension > 3 || !field_behind(&rest, rest, answers) ||
        (snap && !field_behind(&rest, rest, ",shift")))
        return 0;
    if (rest.length && *rest.start != ',')
        return 0;
    out->others = rest.length ? fields_count((field){rest.start + 1, rest.length - 1}) : 0;
    return !rest.length || out->others > 0;
}

/* Is a field one of the names, which end with NULL? */
static int is_among(field f, const char *const *names) {
    for (; *names; names++)
        if (field_is(f, *names))
            return 1;
    return 0;
}

/* A ratio, or root(...). */
static int is_time(field f) {
    field rest;
    return row_is_number(f) ||
           (field_behind(&rest, f, "root(") && rest.length && rest.start[rest.length - 1] == ')');
}

static int words_fit(const field *answer) {
    static const char *const roles[] = {"contact", "egress", "ingress", "hidden", NULL};
    static const char *const signs[] = {"+", "0", "-", NULL};
    static const char *const turns[] = {"preserving", "reversing", "degenerate", NULL};
    static const char *const states[] = {"I", "B", "O", "", NULL};
    unsigned long order;
    int on_slice = answer[SITE_THETA].length > 0;
    return is_among(answer[SITE_ROLE], roles) && is_among(answer[SITE_LEFT], states) &&
           is_among(answer[SITE_RIGHT], states) &&
           (on_slice ? is_among(answer[SITE_THETA], signs) &&
                           is_among(answer[SITE_ORIENTATION], turns) &&
                           (field_is(answer[SITE_ORDER], "inf") ||
                            field_count(&order, answer[SITE_ORDER], ~0ul))
                     : !answer[SITE_ORDER].length && !answer[SITE_ORIENTATION].length);
}

/* near and near_in, which are times or empty, beside the status of the site. */
static int times_fit(const field *answer, field time, int trimmed) {
    static const char *const clear[] = {"slides", "simple", "meets", NULL};
    field near = answer[SITE_NEAR], in = answer[SITE_NEAR_IN], status = answer[SITE_STATUS];
    if ((near.length && !is_time(near)) || (in.length ? !is_time(in) : trimmed))
        return 0;
    if (!trimmed)
        return !in.length && is_among(status, clear) &&
               field_equal(near, time) == field_is(status, "slides") &&
               (near.length == 0) == field_is(status, "simple");
    int here = field_equal(in, time);
    return near.length && field_is(status, here ? "trimmed_near" : "trimmed_far");
}

static int answers_fit(const field *answer, field time, graze_pmc pmc) {
    int trimmed = pmc == GRAZE_IN;
    return pmc != GRAZE_OUT && field_is(answer[SITE_TRIMMED], trimmed ? "yes" : "no") &&
           words_fit(answer) && times_fit(answer, time, trimmed);
}

/* A cell without contact: no answer, and nothing moved. */
static int is_missed(const field *answer, field shift) {
    size_t length = shift.length;
    for (int k = 0; k < SITE_ANSWERS; k++)
        length += answer[k].length;
    return length == 0;
}

const char *site_row_check(row_parts *out, const row_form *form, graze_context *context,
                           field row) {
    field rest = row, answer[SITE_ANSWERS], shift = {"", 0};
    graze_cell cell;
    graze_verdict verdict;
    for (int k = 0; k < 2 * form->dimension + 1; k++)
        row_take(&rest, ',');
    out->point = (field){row.start, (size_t)(rest.start - row.start)};
    field time = {row.start, 0}, named = row_take(&rest, ',');
    while (time.length < row.length && row.start[time.length] != ',')
        time.length++;
    if (out->point.length)
        out->point.length--; /* the comma behind it */
    if (!cell_read(&cell, named))
        return "time, points and a cell";
    for (int k = 0; k < SITE_ANSWERS; k++)
        answer[k] = row_take(&rest, ',');
    field last = answer[SITE_WORD];
    if (form->snap)
        last = shift = row_take(&rest, ',');
    int more = last.start + last.length < row.start + row.length;
    out->word = answer[SITE_WORD];
    out->topo = (field){"", 0};
    out->shift = shift;
    out->rest = rest;
    out->missed = form->snap && is_missed(answer, shift);
    if (!out->missed) {
        if (graze_word_verdict(&verdict, context, out->word.start, out->word.length,
                               &form->options))
            return "a word of letters O, I, B of which every second one is B";
        if (!answers_fit(answer, time, verdict.pmc) ||
            (form->snap && (!row_is_number(shift) || *shift.start == '-')))
            return "the answers that belong to its word";
    }
    if (more != (form->others > 0))
        return form->others ? "the further columns of the column line" : "no further columns";
    return NULL;
}

/* Is a field that number, as graze writes it? */
static int is_value(field f, const mpq_t value) {
    char *digits = mpq_get_str(NULL, 10, value);
    int same = digits && field_is(f, digits);
    free(digits);
    return same;
}

/* Is the square of the distance from y to the row's point what the row says? */
static int is_moved_so(const field *body, field shift, graze_rationals y, int dimension,
                       graze_context *context) {
    mpq_t sum, step;
    int good = 1;
    mpq_inits(sum, step, NULL);
    for (int k = 0; k < dimension && good; k++) {
        good = !graze_number_parse(step, context, body[k].start, body[k].length);
        mpq_sub(step, step, y[k]);
        mpq_mul(step, step, step);
        mpq_add(sum, sum, step);
    }
    good = good && is_value(shift, sum);
    mpq_clears(sum, step, NULL);
    return good;
}

const char *site_row_fits(const row_parts *parts, const row_form *form, const columns *c,
                          graze_context *context, graze_rationals number) {
    int d = form->dimension, good = 1;
    field rest = parts->point, at[7];
    for (int k = 0; k < 2 * d + 1; k++)
        at[k] = row_take(&rest, ',');
    if (!is_value(at[0], number[0]))
        return "this run's time";
    if (form->snap && !parts->missed)
        good = c->sites.in_world || is_moved_so(at + 1, parts->shift, number + 1, d, context);
    for (int k = 0; k < d && (!form->snap || parts->missed); k++)
        good &= is_value(at[(c->sites.in_world ? d + 1 : 1) + k], number[k + 1]);
    return good ? NULL : "this run's point";
}
