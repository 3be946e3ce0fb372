/* Correctly rounded decimals of rationals.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A rational is rounded by one integer division: no working precision settles a tie such as 3/20
 * at one digit.
 */
#include "base/number/decimal.h"

#include "base/context/scope.h"
#include "base/number/text.h"

char *decimal_layout(int negative, const char *digits, size_t count, slong exponent, int strip) {
    HELD(text, t);
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
    return text_take(&t);
}

char *decimal_finite(int *finite, const fmpq_t value) {
    LOCAL(fmpz, rest);
    LOCAL(fmpz, prime);
    fmpz_set_ui(prime, 5);
    LOCAL(fmpz, figures);
    slong places = (slong)fmpz_val2(fmpq_denref(value));
    fmpz_tdiv_q_2exp(rest, fmpq_denref(value), (ulong)places);
    slong fives = fmpz_remove(rest, rest, prime);
    places = fives > places ? fives : places;
    char *out = NULL;
    *finite = fmpz_is_one(rest);
    if (*finite) {
        fmpz_set_ui(figures, 10);
        fmpz_pow_ui(figures, figures, (ulong)places);
        fmpz_divexact(figures, figures, fmpq_denref(value));
        fmpz_mul(figures, figures, fmpq_numref(value));
        fmpz_abs(figures, figures);
        char *digits = fmpz_get_str(NULL, 10, figures);
        size_t count = strlen(digits);
        out = decimal_layout(fmpq_sgn(value) < 0, digits, count, (slong)count - places, 1);
        flint_free(digits);
    }
    return out;
}

/* Divide with remainder: |value| * 10^shift = quotient + remainder / divisor. */
static void scaled(fmpz_t quotient, fmpz_t remainder, fmpz_t divisor, const fmpq_t value,
                   slong shift) {
    LOCAL(fmpz, power);
    LOCAL(fmpz, numerator);
    fmpz_set_ui(power, 10);
    fmpz_pow_ui(power, power, (ulong)(shift < 0 ? -shift : shift));
    fmpz_abs(numerator, fmpq_numref(value));
    fmpz_set(divisor, fmpq_denref(value));
    if (shift < 0)
        fmpz_mul(divisor, divisor, power);
    else
        fmpz_mul(numerator, numerator, power);
    fmpz_fdiv_qr(quotient, remainder, numerator, divisor);
}

char *decimal_of_rational(int *exact, const fmpq_t value, int digits) {
    int is_exact = 1;
    LOCAL(fmpz, quotient);
    LOCAL(fmpz, remainder);
    LOCAL(fmpz, divisor);
    LOCAL(fmpz, bound);
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
    /* Rounding up 99...9 gives one figure more, and then the exponent grows by 1. */
    size_t count = strlen(figures);
    exponent += count > (size_t)digits;
    char *out =
        fmpq_is_zero(value)
            ? decimal_layout(0, "0", 1, 1, 1)
            : decimal_layout(fmpq_sgn(value) < 0, figures,
                             count > (size_t)digits ? (size_t)digits : count, exponent, is_exact);
    flint_free(figures);
    if (exact)
        *exact = is_exact;
    return out;
}
