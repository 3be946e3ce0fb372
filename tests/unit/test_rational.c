/* Number tokens, rounding and bounds, against hand-made values, the C library's correctly rounded
 * strtod and strtof, and the definition of rounding.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <float.h>
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "fixture.h"
#include "../lib/random.h"

static graze_status parse(fmpq_t out, const char *token) {
    return rational_parse(out, context, token, strlen(token));
}

static void check_token(const char *token, const char *expected) {
    fmpq_t value;
    fmpq_init(value);
    if (parse(value, token) != GRAZE_OK) {
        fail_msg("'%s': %s", token, graze_context_message(context));
    }
    char *text = rational_text(value);
    if (strcmp(text, expected) != 0) {
        fail_msg("'%s' read as %s, not %s", token, text, expected);
    }
    assert_true(rational_is_token(token, strlen(token)));
    free(text);
    fmpq_clear(value);
}

static void tokens_are_exact(void **state) {
    (void)state;
    check_token("-12", "-12");
    check_token("+12", "12");
    check_token("007", "7");
    check_token("0.1", "1/10");
    check_token(".5", "1/2");
    check_token("5.", "5");
    check_token("-.25", "-1/4");
    check_token("1.5e-3", "3/2000");
    check_token("2.5E+2", "250");
    check_token("1.20e1", "12");
    check_token("22/7", "22/7");
    check_token("-4/6", "-2/3");
    check_token("0/5", "0");
    check_token("-0", "0");
    check_token("-0.0e7", "0");
    check_token("1180591620717411303424", "1180591620717411303424"); /* 2^70 */
}

/* 1e-400 is far below every double: its denominator is a 1 and 400 zeros. */
static void small_number_is_exact(void **state) {
    (void)state;
    char expected[404] = "1/1";
    memset(expected + 3, '0', 400);
    check_token("1e-400", expected);
}

static void other_texts_are_refused(void **state) {
    (void)state;
    static const char *const texts[] = {
        "",     " ",    "+",   "-",   ".",     "e5",    "1e",    "1e+",   "--1",
        "1/0",  "1/-2", "/2",  "1/",  "1.5/2", "1/2.5", "1 2",   " 1",    "1 ",
        "0x10", "nan",  "inf", "1,5", "1_0",   "1e5.0", "1/2/3", "1e5/2", "\xd9\xa1"};
    fmpq_t value;
    fmpq_init(value);
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        if (parse(value, texts[k]) != GRAZE_EINPUT) {
            fail_msg("'%s' is taken for a number", texts[k]);
        }
        assert_string_not_equal(graze_context_message(context), "");
    }
    assert_int_equal(rational_parse(value, context, "1\0002", 3), GRAZE_EINPUT);
    fmpq_clear(value);
}

/* The limit counts the digits of the number written out: 100 has 3, 0.001 has 3 behind its point.
 */
static void digits_are_limited(void **state) {
    (void)state;
    static const struct {
        const char *token;
        graze_status status;
    } cases[] = {{"123", GRAZE_OK},
                 {"1234", GRAZE_ELIMIT},
                 {"1e2", GRAZE_OK},
                 {"1e3", GRAZE_ELIMIT},
                 {"1e-3", GRAZE_OK},
                 {"1e-4", GRAZE_ELIMIT},
                 {"12.3", GRAZE_OK},
                 {"12.34", GRAZE_ELIMIT},
                 {"123/456", GRAZE_OK},
                 {"1/1234", GRAZE_ELIMIT},
                 {"1234/1", GRAZE_ELIMIT},
                 {"1e1000000000", GRAZE_ELIMIT},
                 {"1e-1000000000", GRAZE_ELIMIT},
                 {"0e99999999999999999999", GRAZE_ELIMIT}};
    fmpq_t value;
    fmpq_init(value);
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_DIGITS, 3), GRAZE_OK);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        if (parse(value, cases[k].token) != cases[k].status) {
            fail_msg("'%s' does not give status %d", cases[k].token, (int)cases[k].status);
        }
    }
    fmpq_clear(value);
}

/* A decimal with a random sign, up to 25 digits, and an exponent over and past the range. */
static void random_decimal(char *out, size_t size, int range) {
    char digits[26];
    int n = 1 + (int)draw_below(25);
    for (int k = 0; k < n; k++) {
        digits[k] = (char)('0' + draw_below(10));
    }
    digits[n] = '\0';
    snprintf(out, size, "%s%s.%se%d", draw_below(2) ? "-" : "", digits, draw_below(2) ? "5" : "",
             (int)draw_below(2 * range) - range);
}

static void check_rounding(const char *token, double expected, graze_rounding rounding,
                           double most) {
    fmpq_t value, wanted;
    fmpq_init(value);
    fmpq_init(wanted);
    assert_int_equal(graze_context_set_rounding(context, rounding), GRAZE_OK);
    graze_status status = parse(value, token);
    if (expected > most || expected < -most) {
        if (status != GRAZE_EINPUT) {
            fail_msg("'%s' does not overflow", token);
        }
    } else {
        assert_int_equal(rational_from_double(wanted, context, expected), GRAZE_OK);
        if (status != GRAZE_OK || !fmpq_equal(value, wanted)) {
            fail_msg("'%s' is not rounded to %a", token, expected);
        }
    }
    fmpq_clear(wanted);
    fmpq_clear(value);
}

static void rounding_agrees_with_strtod(void **state) {
    (void)state;
    random_start(7);
    char token[80];
    for (int k = 0; k < 20000; k++) {
        random_decimal(token, sizeof token, 345);
        check_rounding(token, strtod(token, NULL), GRAZE_ROUND_BINARY64, DBL_MAX);
        random_decimal(token, sizeof token, 60);
        check_rounding(token, strtof(token, NULL), GRAZE_ROUND_BINARY32, FLT_MAX);
    }
}

/* Ties go to the even mantissa, subnormals keep the fixed spacing, overflow begins half a unit past
 * the largest number. */
static void rounding_at_the_corners(void **state) {
    (void)state;
    check_rounding("9007199254740993", 9007199254740992.0, GRAZE_ROUND_BINARY64, DBL_MAX);
    check_rounding("9007199254740995", 9007199254740996.0, GRAZE_ROUND_BINARY64, DBL_MAX);
    check_rounding("16777217", 16777216.0, GRAZE_ROUND_BINARY32, FLT_MAX);
    check_rounding("16777219", 16777220.0, GRAZE_ROUND_BINARY32, FLT_MAX);
    check_rounding("4.9e-324", 0x1p-1074, GRAZE_ROUND_BINARY64, DBL_MAX);
    check_rounding("2.4e-324", 0, GRAZE_ROUND_BINARY64, DBL_MAX);
    check_rounding("1e-400", 0, GRAZE_ROUND_BINARY64, DBL_MAX);
    check_rounding("1e-45", 0x1p-149, GRAZE_ROUND_BINARY32, FLT_MAX);
    check_rounding("22/7", 22.0 / 7.0, GRAZE_ROUND_BINARY64, DBL_MAX);
    check_rounding("-1/3", -1.0 / 3.0, GRAZE_ROUND_BINARY64, DBL_MAX);
    /* 2^1024 - 2^970 is the first that overflows; one less does not. */
    fmpq_t value;
    fmpq_init(value);
    for (int less = 0; less < 2; less++) {
        fmpz_t power;
        fmpz_init(power);
        fmpq_zero(value);
        fmpz_one_2exp(fmpq_numref(value), 1024);
        fmpz_one_2exp(power, 970);
        fmpz_sub(fmpq_numref(value), fmpq_numref(value), power);
        fmpz_sub_ui(fmpq_numref(value), fmpq_numref(value), (ulong)less);
        assert_int_equal(rational_round(value, context, GRAZE_ROUND_BINARY64),
                         less ? GRAZE_OK : GRAZE_EINPUT);
        fmpz_clear(power);
    }
    fmpq_clear(value);
}

static void doubles_are_exact(void **state) {
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.0, "0"},
                 {-0.0, "0"},
                 {0.5, "1/2"},
                 {-3.0, "-3"},
                 {0x1p70, "1180591620717411303424"},
                 {0.1, "3602879701896397/36028797018963968"}};
    fmpq_t value, unit;
    fmpq_init(value);
    fmpq_init(unit);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        assert_int_equal(rational_from_double(value, context, cases[k].value), GRAZE_OK);
        char *text = rational_text(value);
        assert_string_equal(text, cases[k].text);
        free(text);
    }
    assert_int_equal(rational_from_double(value, context, 0x1p-1074), GRAZE_OK);
    fmpq_one(unit);
    fmpq_div_2exp(unit, unit, 1074);
    assert_true(fmpq_equal(value, unit));
    assert_int_equal(rational_from_double(value, context, (double)(0.0f / 0.0f)), GRAZE_EINPUT);
    assert_int_equal(rational_from_double(value, context, 1e308 * 10), GRAZE_EINPUT);
    fmpq_clear(unit);
    fmpq_clear(value);
}

/* Bounds are below and above; for a value that is a normal double both are that double, and else no
 * double lies between them. */
static void check_bounds(const char *token) {
    fmpq_t value, bound;
    double low, high;
    fmpq_init(value);
    fmpq_init(bound);
    set_rational(value, token);
    rational_bounds(&low, &high, value);
    if (low >= -DBL_MAX) {
        assert_int_equal(rational_from_double(bound, context, low), GRAZE_OK);
        if (fmpq_cmp(bound, value) > 0) {
            fail_msg("%s: lower bound %a", token, low);
        }
    }
    if (high <= DBL_MAX) {
        assert_int_equal(rational_from_double(bound, context, high), GRAZE_OK);
        if (fmpq_cmp(bound, value) < 0) {
            fail_msg("%s: upper bound %a", token, high);
        }
    }
    double nearest = strtod(token, NULL);
    if (nearest > DBL_MIN || nearest < -DBL_MIN) {
        if (nearest != low && nearest != high) {
            fail_msg("%s: bounds %a and %a leave out %a", token, low, high, nearest);
        }
    }
    fmpq_clear(bound);
    fmpq_clear(value);
}

static void bounds_enclose(void **state) {
    (void)state;
    random_start(11);
    char token[80];
    check_bounds("0");
    check_bounds("1");
    check_bounds("-1");
    check_bounds("1e400");
    check_bounds("-1e400");
    check_bounds("1e-400");
    check_bounds("-1e-310");
    check_bounds("1.7976931348623157081e308");
    check_bounds("1.7976931348623158e308");
    for (int k = 0; k < 20000; k++) {
        random_decimal(token, sizeof token, 345);
        check_bounds(token);
    }
}

/* Digits of an integer at the corners of 64 bits: around 2^62, 2^63 and 2^64 (FLINT's and our
 * words end there), products of 2 and 5, some zeros before and behind, or any digits. */
static void corner_digits(char *out) {
    fmpz_t value;
    fmpz_init(value);
    out[0] = '\0';
    switch (draw_below(4)) {
    case 0:
        fmpz_set_ui(value, 1);
        fmpz_mul_2exp(value, value, 62 + draw_below(3));
        fmpz_add_si(value, value, draw_below(5) - 2);
        break;
    case 1:
        fmpz_set_ui(value, 5);
        fmpz_pow_ui(value, value, draw_below(30));
        fmpz_mul_2exp(value, value, draw_below(70));
        break;
    case 2:
        fmpz_set_ui(value, draw_below(1000));
        break;
    default:
        for (unsigned k = 1 + draw_below(24); k > 0; k--) {
            fmpz_mul_ui(value, value, 10);
            fmpz_add_ui(value, value, draw_below(10));
        }
    }
    for (unsigned k = draw_below(3) ? 0 : draw_below(25); k > 0; k--) {
        strcat(out, "0");
    }
    fmpz_get_str(out + strlen(out), 10, value);
    for (unsigned k = draw_below(3) ? 0 : draw_below(25); k > 0; k--) {
        strcat(out, "0");
    }
    fmpz_clear(value);
}

static int is_canonical(const fmpq_t value) {
    mpq_t copy;
    mpq_init(copy);
    fmpz_get_mpz(mpq_numref(copy), fmpq_numref(value));
    fmpz_get_mpz(mpq_denref(copy), fmpq_denref(value));
    int canonical = rational_is_canonical(copy);
    mpq_clear(copy);
    return canonical;
}

/* Read, written and found canonical as FLINT's own functions have it. */
static void check_against(const char *token, fmpq_t expected) {
    fmpq_t value;
    fmpq_init(value);
    fmpq_canonicalise(expected);
    if (parse(value, token) != GRAZE_OK || !fmpq_equal(value, expected) || !is_canonical(value)) {
        fail_msg("'%s' is read wrongly", token);
    }
    char *text = rational_text(value), *wanted = fmpq_get_str(NULL, 10, expected);
    if (strcmp(text, wanted) != 0 || strlen(wanted) >= rational_room(value)) {
        fail_msg("'%s' is written as %s, not %s, or has no room", token, text, wanted);
    }
    flint_free(wanted);
    free(text);
    fmpq_clear(value);
}

static void tokens_agree_with_long_arithmetic(void **state) {
    (void)state;
    random_start(23);
    char digits[120], more[120], token[300];
    fmpq_t expected;
    fmpz_t power;
    fmpq_init(expected);
    fmpz_init(power);
    for (int round = 0; round < 40000; round++) {
        corner_digits(digits);
        const char *sign = draw_below(3) ? "" : draw_below(2) ? "-" : "+";
        fmpz_set_str(fmpq_numref(expected), digits, 10);
        if (draw_below(4) == 0) {
            do {
                corner_digits(more);
                fmpz_set_str(fmpq_denref(expected), more, 10);
            } while (fmpz_is_zero(fmpq_denref(expected)));
            snprintf(token, sizeof token, "%s%s/%s", sign, digits, more);
        } else {
            size_t behind = draw_below(strlen(digits) + 1);
            long exponent = draw_below(2) ? 0 : draw_below(80) - 40;
            snprintf(token, sizeof token, "%s%.*s.%se%ld", sign, (int)(strlen(digits) - behind),
                     digits, digits + strlen(digits) - behind, exponent);
            long shift = exponent - (long)behind;
            fmpz_set_ui(power, 10);
            fmpz_pow_ui(power, power, (ulong)labs(shift));
            fmpz_one(fmpq_denref(expected));
            fmpz_mul(shift < 0 ? fmpq_denref(expected) : fmpq_numref(expected),
                     shift < 0 ? fmpq_denref(expected) : fmpq_numref(expected), power);
        }
        if (*sign == '-') {
            fmpz_neg(fmpq_numref(expected), fmpq_numref(expected));
        }
        check_against(token, expected);
    }
    fmpz_clear(power);
    fmpq_clear(expected);
}

/* Any two integers, the second also 0 and negative: what FLINT's gcd says. */
static void canonical_is_what_the_gcd_says(void **state) {
    (void)state;
    random_start(29);
    char numerator[120], denominator[120];
    fmpq_t value;
    fmpq_init(value);
    int found = 0;
    for (int round = 0; round < 40000; round++) {
        corner_digits(numerator);
        corner_digits(denominator);
        fmpz_set_str(fmpq_numref(value), numerator, 10);
        fmpz_set_str(fmpq_denref(value), denominator, 10);
        if (draw_below(2)) {
            fmpz_neg(fmpq_numref(value), fmpq_numref(value));
        }
        if (draw_below(8) == 0) {
            fmpz_neg(fmpq_denref(value), fmpq_denref(value));
        }
        if (is_canonical(value) != fmpq_is_canonical(value)) {
            fail_msg("%s/%s: canonical or not", numerator, denominator);
        }
        found += fmpq_is_canonical(value);
    }
    assert_true(found > 1000 && found < 39000);
    fmpq_clear(value);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(tokens_are_exact, set_up, tear_down),
        cmocka_unit_test_setup_teardown(small_number_is_exact, set_up, tear_down),
        cmocka_unit_test_setup_teardown(other_texts_are_refused, set_up, tear_down),
        cmocka_unit_test_setup_teardown(digits_are_limited, set_up, tear_down),
        cmocka_unit_test_setup_teardown(rounding_agrees_with_strtod, set_up, tear_down),
        cmocka_unit_test_setup_teardown(rounding_at_the_corners, set_up, tear_down),
        cmocka_unit_test_setup_teardown(doubles_are_exact, set_up, tear_down),
        cmocka_unit_test_setup_teardown(tokens_agree_with_long_arithmetic, set_up, tear_down),
        cmocka_unit_test_setup_teardown(canonical_is_what_the_gcd_says, set_up, tear_down),
        cmocka_unit_test_setup_teardown(bounds_enclose, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
