/* The public functions of traces and their times.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "decide/verdict/verdict.h"
#include "output/report/report.h"

graze_status graze_trace_create(graze_trace **out, graze_context *context, const graze_scene *scene,
                                graze_rationals point) {
    PUBLIC_OUT(out, context, scene, point);
    LOCAL_VEC(fmpq, p, scene->motion->dimension);
    TRY(api_point(p, context, scene, point));
    CREATE(out, made, free,
           classify_point(made, context, scene, (query_point){.rational = p}, TRACE_CONTACTS));
}

DESTROYER(graze_trace, trace_clear(of))
FACT(const char *, graze_trace_word, graze_trace, of->word, "")
FACT(graze_verdict, graze_trace_verdict, graze_trace, of->verdict, (graze_verdict){0})
FACT(size_t, graze_trace_contact_count, graze_trace, of->contact_count, 0)

/* A contact in its public form, without its kind. */
static graze_contact contact_out(const contact *c) {
    return (graze_contact){.left = c->left,
                           .right = c->right,
                           .from = c->from,
                           .to = c->to,
                           .cells = c->cell,
                           .cell_count = c->cell_count};
}

int graze_trace_undecided(graze_contact *out, const graze_trace *trace) {
    if (!trace || !trace->undecided || !out)
        return 0;
    *out = contact_out(&trace->undecided->where);
    return 1;
}

const char *graze_trace_reason(const graze_trace *trace) {
    return trace && trace->undecided ? trace->undecided->reason : "";
}

graze_contact graze_trace_contact(const graze_trace *trace, size_t index) {
    graze_contact out = {0};
    if (index >= graze_trace_contact_count(trace))
        return out;
    const contact *c = &trace->contact[index];
    out = contact_out(c);
    out.kind = verdict_kind(c->left, c->right);
    return out;
}

int graze_time_rational(mpq_t out, const graze_time *time) {
    if (!out || !time || !time_is_rational(time))
        return 0;
    fmpq_get_mpq(out, time->low);
    return 1;
}

int graze_time_degree(const graze_time *time) {
    if (!time)
        return 0;
    return time_is_rational(time) ? 1 : (int)fmpz_poly_degree(time->poly);
}

void graze_time_coefficient(mpz_t out, const graze_time *time, int k) {
    if (!out)
        return;
    LOCAL(fmpz, c);
    if (time && k >= 0 && time_is_rational(time)) {
        if (k == 0)
            fmpz_neg(c, fmpq_numref(time->low));
        else if (k == 1)
            fmpz_set(c, fmpq_denref(time->low));
    } else if (time && k >= 0) {
        fmpz_poly_get_coeff_fmpz(c, time->poly, k);
    }
    fmpz_get_mpz(out, c);
}

void graze_time_interval(mpq_t low, mpq_t high, const graze_time *time) {
    if (!low || !high || !time)
        return;
    (void)time_is_rational(time);
    fmpq_get_mpq(low, time->low);
    fmpq_get_mpq(high, time->high);
}

graze_status graze_time_decimal(char **out, graze_context *context, const graze_time *time,
                                int digits) {
    PUBLIC_OUT(out, context, time);
    REFUSED(digits < 1 || digits > 1000, "digits must be from 1 to 1000");
    *out = decimal_of_time(NULL, time, digits);
    return *out ? GRAZE_OK : context_fail(context, GRAZE_ESYSTEM, "out of memory");
}

FACT(unsigned long, graze_time_row, graze_time, of->motion->piece[time_first_piece(of)].row, 0)

graze_status graze_number_decimal(char **out, graze_context *context, const mpq_t value,
                                  int digits) {
    PUBLIC_OUT(out, context, value);
    REFUSED(digits < 0 || digits > 1000, "digits must be from 0 to 1000");
    int finite = 1;
    LOCAL(fmpq, number);
    TRY(api_rational(number, context, value));
    *out = digits ? decimal_of_rational(NULL, number, digits) : decimal_finite(&finite, number);
    if (*out)
        return GRAZE_OK;
    return finite ? context_fail(context, GRAZE_ESYSTEM, "out of memory")
                  : context_fail(context, GRAZE_EINPUT, "the number has no finite decimal");
}
