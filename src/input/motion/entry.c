/* The entries of a motion file: JSON values to functions, numbers and integers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/draft.h"

#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/rational.h"

enum { TIME_SIZE = 60, STRETCH_ENDS = 4 };

void stretch_init(stretch *part, int dimension) {
    fmpq *n = _fmpq_vec_init(STRETCH_ENDS);
    *part = (stretch){dimension, n, n + 1, n + 2, n + 3, .fault = FAULT_NONE};
    fmpz_poly_q_init(part->t);
    fmpz_poly_q_init(part->s);
}

void stretch_clear(stretch *part) {
    _fmpq_vec_clear(part->from, STRETCH_ENDS);
    fmpz_poly_q_clear(part->t);
    fmpz_poly_q_clear(part->s);
}

void stretch_set(stretch *part, const fmpq_t lo, const fmpq_t hi, const cut_place *ends) {
    LOCAL(fmpq, span);
    fmpq_sub(span, hi, lo);
    fmpq_set_ui(part->from, ends[0].part, ends[0].of);
    fmpq_set_ui(part->to, ends[1].part, ends[1].of);
    fmpq_set(part->lo, lo);
    fmpq_addmul(part->lo, span, part->from);
    fmpq_set(part->hi, lo);
    fmpq_addmul(part->hi, span, part->to);
    quotient_set_line(part->t, part->lo, part->hi);
    quotient_set_line(part->s, part->from, part->to);
}

static graze_status read_value(fmpz_poly_q_t out, graze_context *context, const json *value,
                               const fmpz_poly_q_struct *t, const fmpz_poly_q_struct *s) {
    if (value->kind != JSON_NUMBER && value->kind != JSON_STRING)
        return json_fail(context, GRAZE_EINPUT, value, "expected %s",
                         t != NULL ? "a number or an expression in quotes"
                                   : "a number, bare or in quotes,");
    return json_at(context, expression_value(out, context, value->text, value->length, t, s),
                   value);
}

graze_status entry_function(fmpz_poly_q_t out, graze_context *context, const json *value,
                            const stretch *part) {
    return read_value(out, context, value, part->t, part->s);
}

graze_status entry_finite(fmpz_poly_q_t out, graze_context *context, const json *value,
                          const stretch *part) {
    TRY(entry_function(out, context, value, part));
    if (part->fault == FAULT_POLE)
        TRY(entry_no_root(context, value, fmpz_poly_q_denref(out), part->lo, part->hi,
                          "this entry has a pole"));
    return GRAZE_OK;
}

graze_status entry_vector(fmpz_poly_q_t *out, graze_context *context, const json *value,
                          size_t count, const stretch *part) {
    TRY(json_array(context, value, count));
    const json *item = value->first;
    for (size_t k = 0; k < count; k++, item = item->next)
        TRY(entry_finite(out[k], context, item, part));
    return GRAZE_OK;
}

graze_status entry_number(fmpq_t out, graze_context *context, const json *value) {
    LOCAL(fmpz_poly_q, constant);
    TRY(read_value(constant, context, value, NULL, NULL));
    fmpz_poly_get_coeff_fmpz(fmpq_numref(out), fmpz_poly_q_numref(constant), 0);
    fmpz_poly_get_coeff_fmpz(fmpq_denref(out), fmpz_poly_q_denref(constant), 0);
    return GRAZE_OK;
}

graze_status entry_integer(fmpz_t out, graze_context *context, const json *value) {
    LOCAL(fmpq, number);
    TRY(entry_number(number, context, value));
    if (!fmpz_is_one(fmpq_denref(number)))
        return json_fail(context, GRAZE_EINPUT, value, "'%.60s' is not an integer", value->text);
    fmpz_set(out, fmpq_numref(number));
    return GRAZE_OK;
}

/* lo + (hi - lo) u as text, or as much of it as has room. */
static void time_text(char out[TIME_SIZE], const fmpq_t lo, const fmpq_t hi, const fmpq_t u) {
    LOCAL(fmpq, time);
    fmpq_sub(time, hi, lo);
    fmpq_mul(time, time, u);
    fmpq_add(time, time, lo);
    char *text = rational_text(time);
    int whole = snprintf(out, TIME_SIZE, "%s", text != NULL ? text : "?") < TIME_SIZE;
    if (!whole)
        snprintf(out + TIME_SIZE - 4, 4, "...");
    free(text);
}

graze_status entry_no_root(graze_context *context, const json *where, const fmpz_poly_t p,
                           const fmpq_t lo, const fmpq_t hi, const char *what) {
    if (fmpz_poly_is_zero(p))
        return json_fail(context, GRAZE_EILLEGAL, where, "%s at every t", what);
    calculation c = {context, GRAZE_OK};
    calculation_spend(&c, (unsigned long)fmpz_poly_length(p) * polynomial_work(p));
    TRY(json_at(context, c.status, where));
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    int found;
    graze_status status = polynomial_root(&found, low, high, context, p);
    if (found) {
        char first[TIME_SIZE], last[TIME_SIZE];
        time_text(first, lo, hi, low);
        time_text(last, lo, hi, high);
        if (fmpq_equal(low, high)) {
            status = json_fail(context, GRAZE_EILLEGAL, where, "%s at t = %s", what, first);
        } else {
            status = json_fail(context, GRAZE_EILLEGAL, where, "%s between t = %s and t = %s", what,
                               first, last);
        }
    }
    return status;
}
