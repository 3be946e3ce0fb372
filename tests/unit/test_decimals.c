/* Decimals of rationals, derived and against MPFR.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <mpfr.h>
#include "../lib/harness.h"
#include "../lib/random.h"
#include "base/number/decimal.h"

static void set(fmpq_t out, const char *text) {
    assert_int_equal(fmpq_set_str(out, text, 10), 0);
    fmpq_canonicalise(out);
}

static void expect_decimal(const char *value, int digits, const char *decimal, int exact) {
    fmpq_t x;
    int is_exact;
    fmpq_init(x);
    set(x, value);
    char *text = decimal_of_rational(&is_exact, x, digits);
    if (strcmp(text, decimal) != 0 || is_exact != exact)
        fail_msg("%s at %d digits: %s (%d)", value, digits, text, is_exact);
    free(text);
    fmpq_clear(x);
}

/* Ties go to the even digit; carries and powers of ten are where an exponent goes wrong. */
static void expect_finite(const char *value, const char *decimal) {
    fmpq_t x;
    fmpq_init(x);
    fmpq_set_str(x, value, 10);
    int finite;
    char *text = decimal_finite(&finite, x);
    assert_int_equal(finite, decimal != NULL);
    if (decimal)
        assert_string_equal(text, decimal);
    else
        assert_null(text);
    free(text);
    fmpq_clear(x);
}

static void finite_decimals(void **state) {
    (void)state;
    expect_finite("0", "0");
    expect_finite("-7", "-7");
    expect_finite("1200", "1200");
    expect_finite("1/8", "0.125");
    expect_finite("-3/20", "-0.15");
    expect_finite("12345678901/1000", "12345678.901");
    expect_finite("1/1048576", "9.5367431640625e-7");
    expect_finite("7/3125", "0.00224");
    expect_finite("1/3", NULL);
    expect_finite("5/6", NULL);
    expect_finite("1/1000001", NULL);
}

static void decimals_of_rationals(void **state) {
    (void)state;
    expect_decimal("0", 5, "0", 1);
    expect_decimal("1/2", 12, "0.5", 1);
    expect_decimal("1/3", 12, "0.333333333333", 0);
    expect_decimal("-2/3", 4, "-0.6667", 0);
    expect_decimal("3/20", 1, "0.2", 0); /* 0.15: a tie no binary precision settles */
    expect_decimal("1/4", 1, "0.2", 0);
    expect_decimal("3/4", 1, "0.8", 0);
    expect_decimal("999/1000", 2, "1.0", 0);
    expect_decimal("19999/2", 4, "1.000e4", 0);
    expect_decimal("1000", 4, "1000", 1);
    expect_decimal("1000", 2, "1e3", 1);
    expect_decimal("12345", 5, "12345", 1);
    expect_decimal("123456", 5, "1.2346e5", 0);
    expect_decimal("1/100000", 3, "0.00001", 1);
    expect_decimal("1/1000000", 3, "1e-6", 1);
    expect_decimal("1/10", 1, "0.1", 1);
    expect_decimal("9/10", 1, "0.9", 1);
    expect_decimal("99/100", 1, "1", 0);
    expect_decimal("22/7", 6, "3.14286", 0);
}

/* The significant figures of a decimal, and the exponent e of its value 0.FIGURES * 10^e. */
static long figures_of(char *figures, const char *decimal) {
    long before = 0, count = 0;
    int point = 0;
    const char *p = decimal + (*decimal == '-');
    for (; *p && *p != 'e'; p++) {
        if (*p == '.')
            point = 1;
        else if (count > 0 || *p != '0')
            figures[count++] = *p;
        before += *p != '.' && !point && count > 0;
        before -= *p == '0' && point && count == 0;
    }
    figures[count] = '\0';
    return before + (*p == 'e' ? strtol(p + 1, NULL, 10) : 0);
}

/* The number of figures of a whole number without the zeros at its end. */
static int whole_figures(slong n) {
    int count = 0;
    while (n % 10 == 0)
        n /= 10;
    for (; n != 0; n /= 10)
        count++;
    return count;
}

/* The figures of MPFR: all of them, or without the zeros at the end where they are the number. */
static void expect_figures(const char *decimal, int exact, const mpfr_t value, int digits) {
    char figures[64], wanted[64];
    mpfr_exp_t exponent;
    long found = figures_of(figures, decimal);
    assert_non_null(mpfr_get_str(wanted, &exponent, 10, (size_t)digits, value, MPFR_RNDN));
    char *first = wanted + (*wanted == '-');
    for (size_t k = strlen(first); exact && k > 1 && first[k - 1] == '0'; k--)
        first[k - 1] = '\0';
    for (size_t k = strlen(figures); exact && k > 1 && figures[k - 1] == '0'; k--)
        figures[k - 1] = '\0'; /* of a whole number */
    if (strcmp(figures, first) != 0 || found != exponent || (*decimal == '-') != (*wanted == '-'))
        fail_msg("%s at %d digits, expected %s * 10^%ld", decimal, digits, wanted,
                 (long)exponent - (long)strlen(first));
}

/* Against MPFR at far more bits than the digits need. A fraction whose denominator ends in 3 or is
 * 1 is no tie in decimals but as a whole number, which MPFR has exactly and rounds to even, too. */
static void decimals_against_mpfr(void **state) {
    (void)state;
    int whole = 0, scaled = 0;
    fmpq_t x;
    mpq_t q;
    mpfr_t value;
    random_start(5);
    fmpq_init(x);
    mpq_init(q);
    mpfr_init2(value, 2000);
    for (int round = 0; round < 3000; round++) {
        slong numerator = random_about(1000000);
        ulong denominator = round % 8 ? (ulong)draw_below(30000) * 10 + 3 : 1;
        int digits = 2 + (int)draw_below(40), exact;
        if (numerator == 0)
            continue;
        fmpq_set_si(x, numerator, denominator);
        if (fmpz_is_one(fmpq_denref(x))) {
            whole++;
        } else {
            fmpz *side = draw_below(2) ? fmpq_numref(x) : fmpq_denref(x);
            for (slong k = draw_below(40); k > 0; k--, scaled++)
                fmpz_mul_ui(side, side, 10);
            fmpq_canonicalise(x);
        }
        char *text = decimal_of_rational(&exact, x, digits);
        fmpq_get_mpq(q, x);
        mpfr_set_q(value, q, MPFR_RNDN);
        expect_figures(text, exact, value, digits);
        /* Exact is a whole number of at most `digits` figures, zeros at its end apart. */
        int fits =
            fmpz_is_one(fmpq_denref(x)) && whole_figures(fmpz_get_si(fmpq_numref(x))) <= digits;
        assert_int_equal(exact, fits);
        free(text);
    }
    assert_true(whole > 300 && scaled > 10000);
    mpfr_clear(value);
    mpq_clear(q);
    fmpq_clear(x);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finite_decimals),
        cmocka_unit_test(decimals_of_rationals),
        cmocka_unit_test(decimals_against_mpfr),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
