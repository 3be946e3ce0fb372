/* Correctly rounded decimals of exact numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A rational is rounded by one integer division: no working precision settles a tie such as 3/20
 * at one digit. An irrational root is never a tie, so its isolating interval is narrowed until MPFR
 * rounds both ends to the same digits; all numbers between them then round alike.
 */
#include "report/decimal.h"

#include <mpfr.h>
#include <stdlib.h>
#include <string.h>
#include "report/text.h"

int time_is_rational(const graze_time *time) {
    /* Without a context nothing ends it. */
    (void)time_canonicalise((graze_time *)time, NULL);
    return fmpq_equal(time->low, time->high);
}

/* Writes 0.DIGITS * 10^exponent. */
static char *layout(int negative, const char *digits, size_t count, slong exponent, int strip) {
    text t;
    text_init(&t);
    size_t shown = count;
    while (strip && shown > 1 && digits[shown - 1] == '0')
        shown--;
    if (negative)
        text_put(&t, "-");
    if (exponent > (slong)count || exponent < -4) {
        text_bytes(&t, digits, 1);
        if (shown > 1)
            text_put(&t, ".");
        text_bytes(&t, digits + 1, shown - 1);
        text_format(&t, "e%ld", (long)exponent - 1);
    } else if (exponent <= 0) {
        text_put(&t, "0.");
        text_bytes(&t, "0000", (size_t)-exponent);
        text_bytes(&t, digits, shown);
    } else {
        size_t whole = (size_t)exponent;
        text_bytes(&t, digits, whole);
        if (shown > whole) {
            text_put(&t, ".");
            text_bytes(&t, digits + whole, shown - whole);
        }
    }
    if (t.failed)
        text_clear(&t);
    return t.data;
}

/* quotient, remainder of |value| * 10^shift, remainder over *divisor. */
static void scaled(fmpz_t quotient, fmpz_t remainder, fmpz_t divisor, const fmpq_t value,
                   slong shift) {
    fmpz_t power, numerator;
    fmpz_init(power);
    fmpz_init(numerator);
    fmpz_set_ui(power, 10);
    fmpz_pow_ui(power, power, (ulong)(shift < 0 ? -shift : shift));
    fmpz_abs(numerator, fmpq_numref(value));
    fmpz_set(divisor, fmpq_denref(value));
    if (shift < 0)
        fmpz_mul(divisor, divisor, power);
    else
        fmpz_mul(numerator, numerator, power);
    fmpz_fdiv_qr(quotient, remainder, numerator, divisor);
    fmpz_clear(power);
    fmpz_clear(numerator);
}

char *decimal_of_rational(int *exact, const fmpq_t value, int digits) {
    int is_exact = 1;
    fmpz_t quotient, remainder, divisor, bound;
    fmpz_init(quotient);
    fmpz_init(remainder);
    fmpz_init(divisor);
    fmpz_init(bound);
    fmpz_set_ui(bound, 10);
    fmpz_pow_ui(bound, bound, (ulong)digits);
    slong bits = (slong)fmpz_bits(fmpq_numref(value)) - (slong)fmpz_bits(fmpq_denref(value));
    slong exponent = bits * 3 / 10;
    scaled(quotient, remainder, divisor, value, digits - exponent);
    if (!fmpq_is_zero(value)) {
        while (fmpz_cmp(quotient, bound) >= 0)
            scaled(quotient, remainder, divisor, value, digits - ++exponent);
        fmpz_divexact_ui(bound, bound, 10);
        while (fmpz_cmp(quotient, bound) < 0)
            scaled(quotient, remainder, divisor, value, digits - --exponent);
        is_exact = fmpz_is_zero(remainder);
        fmpz_mul_2exp(remainder, remainder, 1);
        int half = fmpz_cmp(remainder, divisor);
        if (half > 0 || (half == 0 && fmpz_is_odd(quotient)))
            fmpz_add_ui(quotient, quotient, 1);
    }
    char *figures = fmpz_get_str(NULL, 10, quotient);
    /* Rounding up 99...9 gives one figure more, and the exponent with it. */
    size_t count = strlen(figures);
    exponent += count > (size_t)digits;
    char *out = fmpq_is_zero(value)
                    ? layout(0, "0", 1, 1, 1)
                    : layout(fmpq_sgn(value) < 0, figures,
                             count > (size_t)digits ? (size_t)digits : count, exponent, is_exact);
    flint_free(figures);
    fmpz_clear(quotient);
    fmpz_clear(remainder);
    fmpz_clear(divisor);
    fmpz_clear(bound);
    if (exact)
        *exact = is_exact;
    return out;
}

/* The digits of one end, rounded to nearest, of a value held to the given precision. */
static char *end_digits(mpfr_exp_t *exponent, const fmpq_t end, mpfr_rnd_t direction,
                        mpfr_prec_t precision, int digits) {
    mpq_t exact;
    mpfr_t value;
    mpq_init(exact);
    mpfr_init2(value, precision);
    fmpq_get_mpq(exact, end);
    mpfr_set_q(value, exact, direction);
    char *text = mpfr_get_str(NULL, exponent, 10, (size_t)digits, value, MPFR_RNDN);
    mpfr_clear(value);
    mpq_clear(exact);
    return text;
}

/* The isolating interval of the time's local parameter, carried to the motion's parameter. */
static void bounds_in_t(fmpq_t low, fmpq_t high, const algebraic *u, const motion_piece *piece) {
    fmpq_t length;
    fmpq_init(length);
    fmpq_sub(length, piece->hi, piece->lo);
    algebraic_bounds(low, high, u);
    fmpq_mul(low, low, length);
    fmpq_add(low, low, piece->lo);
    fmpq_mul(high, high, length);
    fmpq_add(high, high, piece->lo);
    fmpq_clear(length);
}

/* Digits that both ends round to; NULL if they differ. */
static char *common_digits(const fmpq_t low, const fmpq_t high, mpfr_prec_t precision, int digits) {
    mpfr_exp_t low_exponent, high_exponent;
    char *from = end_digits(&low_exponent, low, MPFR_RNDD, precision, digits);
    char *to = end_digits(&high_exponent, high, MPFR_RNDU, precision, digits);
    char *out = NULL;
    if (low_exponent == high_exponent && strcmp(from, to) == 0) {
        int negative = from[0] == '-';
        out = layout(negative, from + negative, (size_t)digits, low_exponent, 0);
    }
    mpfr_free_str(from);
    mpfr_free_str(to);
    return out;
}

static char *decimal_of_root(const graze_time *time, int digits) {
    algebraic u;
    fmpq_t low, high;
    algebraic_init(&u);
    fmpq_init(low);
    fmpq_init(high);
    algebraic_set(&u, &time->u);
    char *out = NULL;
    ulong gain = FIRST_GAIN;
    for (mpfr_prec_t precision = 64 + 4 * (mpfr_prec_t)digits; !out; precision += precision / 8) {
        for (int k = 0; k < 4; k++)
            algebraic_refine_quadratically(&u, &gain);
        bounds_in_t(low, high, &u, &time->motion->piece[time->piece]);
        out = common_digits(low, high, precision, digits);
    }
    fmpq_clear(low);
    fmpq_clear(high);
    algebraic_clear(&u);
    return out;
}

char *decimal_of_time(int *exact, const graze_time *time, int digits) {
    if (time_is_rational(time))
        return decimal_of_rational(exact, time->low, digits);
    if (exact)
        *exact = 0;
    return decimal_of_root(time, digits);
}
