/* Times as text: exact, and as correctly rounded decimals.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * An irrational root is never a tie, so its isolating interval is narrowed until MPFR rounds both
 * ends to the same digits; all numbers between them then round alike.
 */
#include "output/report/row_parts.h"

#include "base/context/scope.h"

int time_is_rational(const graze_time *time) {
    /* Without a context the call cannot fail: no limit, no cancel callback. */
    (void)time_canonicalise((graze_time *)time, NULL);
    return fmpq_equal(time->low, time->high);
}

/* The end of an interval, first rounded in `direction` to `precision` bits and then to nearest as
 * decimal digits. */
static char *end_digits(mpfr_exp_t *exponent, const fmpq_t end, mpfr_rnd_t direction,
                        mpfr_prec_t precision, int digits) {
    LOCAL(mpq, exact);
    LOCAL_MPFR(value, precision);
    fmpq_get_mpq(exact, end);
    mpfr_set_q(value, exact, direction);
    return mpfr_get_str(NULL, exponent, 10, (size_t)digits, value, MPFR_RNDN);
}

/* The isolating interval of a time, converted from the piece's parameter to the motion's. */
static void bounds_in_t(fmpq_t low, fmpq_t high, const algebraic *u, const motion_piece *piece) {
    algebraic_bounds(low, high, u);
    motion_time_at(low, piece, low);
    motion_time_at(high, piece, high);
}

/* The digits that both ends round to; NULL if they round differently. */
static char *common_digits(const fmpq_t low, const fmpq_t high, mpfr_prec_t precision, int digits) {
    mpfr_exp_t low_exponent, high_exponent;
    char *from = end_digits(&low_exponent, low, MPFR_RNDD, precision, digits);
    char *to = end_digits(&high_exponent, high, MPFR_RNDU, precision, digits);
    char *out = NULL;
    if (low_exponent == high_exponent && strcmp(from, to) == 0) {
        int negative = from[0] == '-';
        out = decimal_layout(negative, from + negative, (size_t)digits, low_exponent, 0);
    }
    mpfr_free_str(from);
    mpfr_free_str(to);
    return out;
}

static char *decimal_of_root(const graze_time *time, const fmpq_t since, int digits) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    HELD(algebraic, u);
    algebraic_set(&u, &time->u);
    char *out = NULL;
    ulong gain = FIRST_GAIN;
    for (mpfr_prec_t precision = 64 + 4 * (mpfr_prec_t)digits; !out; precision += precision / 8) {
        for (int k = 0; k < 4; k++)
            algebraic_refine_quadratically(&u, &gain);
        bounds_in_t(low, high, &u, &time->motion->piece[time->piece]);
        fmpq_sub(low, low, since);
        fmpq_sub(high, high, since);
        out = common_digits(low, high, precision, digits);
    }
    return out;
}

char *decimal_of_time_since(int *exact, const graze_time *time, const fmpq_t since, int digits) {
    if (!time_is_rational(time)) {
        if (exact)
            *exact = 0;
        return decimal_of_root(time, since, digits);
    }
    LOCAL(fmpq, later);
    fmpq_sub(later, time->low, since);
    return decimal_of_rational(exact, later, digits);
}

char *decimal_of_time(int *exact, const graze_time *time, int digits) {
    LOCAL(fmpq, zero);
    return decimal_of_time_since(exact, time, zero, digits);
}

int time_origin(fmpq *origin, const graze_motion *motion) {
    const slong large = 1000;
    LOCAL_VEC(fmpq, length, 2);
    fmpq *start = length + 1;
    fmpq_sub(length, motion->piece[motion->piece_count - 1].hi, motion->piece[0].lo);
    fmpq_mul_si(length, length, large);
    fmpq_abs(start, motion->piece[0].lo);
    int is_large = fmpq_cmp(start, length) >= 0;
    if (origin && is_large)
        fmpq_set(origin, motion->piece[0].lo);
    else if (origin)
        fmpq_zero(origin);
    return is_large;
}

void report_put_time(text *t, const graze_time *time) {
    if (time && time_is_rational(time)) {
        text_rational(t, time->low);
    } else if (time) {
        text_put(t, "root(");
        text_coefficients(t, time->poly);
        text_put(t, ";");
        text_rational(t, time->low);
        text_put(t, ";");
        text_rational(t, time->high);
        text_put(t, ")");
    }
}

enum { NEAR_DIGITS = 17 };

void report_put_time_near(text *t, const graze_time *time) {
    report_put_time(t, time);
    text_put(t, ",");
    if (time)
        text_owned(t, decimal_of_time(NULL, time, NEAR_DIGITS));
}
