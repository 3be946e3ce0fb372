/* Polynomials said to have no root in an interval, against roots that are known.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include "../lib/random.h"

#include <fenv.h>

#include "base/number/simplest.h"

enum { ROUNDS = 20000 };

/* The start of each test: the zero polynomial and [0, 0]. */
typedef struct question {
    fmpz_poly_t p;
    dyadic_interval interval;
} question;

static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/* 1 of certainly_rootless in some rounding mode, or in all if `all`. */
static int says_rootless(const fmpz_poly_t p, const dyadic_interval *interval, int all) {
    int said = 0;
    for (int k = 0; k < 4; k++) {
        fesetround(modes[k]);
        said += certainly_rootless(p, interval);
    }
    fesetround(FE_TONEAREST);
    return all ? said == 4 : said > 0;
}

/* p = (b x - a) q with q of any kind. */
static void with_root(fmpz_poly_t p, slong a, slong b) {
    fmpz_poly_t linear;
    fmpz_poly_init(linear);
    fmpz_poly_set_coeff_si(linear, 0, -a);
    fmpz_poly_set_coeff_si(linear, 1, b);
    do
        fmpz_poly_randtest(p, chance, 1 + draw_below(10), (flint_bitcnt_t)(1 + draw_below(2000)));
    while (fmpz_poly_is_zero(p));
    fmpz_poly_mul(p, p, linear);
    fmpz_poly_clear(linear);
}

/* An interval of width about 2^-places, in [0, 1], that holds a / b, often as its end. */
static void around(dyadic_interval *interval, slong a, slong b, ulong places) {
    fmpz_t one;
    fmpz_init(one);
    fmpz_one_2exp(one, places);
    interval->exponent = places;
    fmpz_mul_si(interval->low, one, a);
    fmpz_fdiv_q_si(interval->low, interval->low, b);
    fmpz_add_ui(interval->high, interval->low, 1 + (ulong)draw_below(3));
    fmpz_sub_ui(interval->low, interval->low, (ulong)draw_below(2));
    if (fmpz_sgn(interval->low) < 0)
        fmpz_zero(interval->low);
    if (fmpz_cmp(interval->high, one) > 0)
        fmpz_set(interval->high, one);
    fmpz_clear(one);
}

static int set_up(void **state) {
    static question asked;
    fmpz_poly_init(asked.p);
    dyadic_interval_init(&asked.interval);
    *state = &asked;
    return 0;
}

static int tear_down(void **state) {
    question *asked = *state;
    dyadic_interval_clear(&asked->interval);
    fmpz_poly_clear(asked->p);
    return 0;
}

/* With a root in the interval nothing is ever said. */
static void test_roots_are_never_lost(void **state) {
    question *asked = *state;
    fmpz_poly_struct *p = asked->p;
    dyadic_interval *interval = &asked->interval;
    random_start(7);
    for (int k = 0; k < ROUNDS; k++) {
        slong b = 1 + draw_below(1 << draw_below(20)), a = draw_below(b + 1);
        with_root(p, a, b);
        around(interval, a, b, (ulong)draw_below(51));
        if (says_rootless(p, interval, 0))
            fail_msg("round %d: a root was lost", k);
    }
}

/* (2 x - 1) (x + 1) 2^k = (2 x^2 + x - 1) 2^k: on [0, 1/4] the value at 1/8 is -27/32, and it
 * changes by at most 5/8, 1/8 times 4 + 1, up to the ends. On [0, 3/8] the value at 3/16 is
 * -95/128, less in size than 15/16, 3/16 times 5: nothing is said. */
static void test_by_hand(void **state) {
    question *asked = *state;
    fmpz_poly_struct *p = asked->p;
    dyadic_interval *interval = &asked->interval;
    for (ulong k = 0; k <= 3000; k += 1000) {
        fmpz_poly_zero(p);
        fmpz_poly_set_coeff_si(p, 2, 2);
        fmpz_poly_set_coeff_si(p, 1, 1);
        fmpz_poly_set_coeff_si(p, 0, -1);
        fmpz_poly_scalar_mul_2exp(p, p, k);
        interval->exponent = 3;
        fmpz_set_ui(interval->low, 0);
        fmpz_set_ui(interval->high, 2);
        assert_true(says_rootless(p, interval, 1));
        fmpz_set_ui(interval->high, 3);
        assert_false(says_rootless(p, interval, 0));
    }
}

/* x - 2 has no root in any of these, but outside [0, 1] or past 50 places nothing is said, nor of
 * degrees past 16. */
static void test_what_is_not_looked_at(void **state) {
    question *asked = *state;
    fmpz_poly_struct *p = asked->p;
    dyadic_interval *interval = &asked->interval;
    fmpz_poly_set_coeff_si(p, 1, 1);
    fmpz_poly_set_coeff_si(p, 0, -2);
    dyadic_interval_set_si(interval, 0, 1);
    assert_true(says_rootless(p, interval, 1));
    dyadic_interval_set_si(interval, -1, 0);
    assert_false(says_rootless(p, interval, 0));
    dyadic_interval_set_si(interval, 1, 2);
    assert_false(says_rootless(p, interval, 0));
    dyadic_interval_set_si(interval, 0, 1);
    interval->exponent = 51;
    assert_false(says_rootless(p, interval, 0));
    interval->exponent = 50;
    assert_true(says_rootless(p, interval, 1));
    fmpz_poly_set_coeff_si(p, 16, 1);
    assert_true(says_rootless(p, interval, 1));
    fmpz_poly_set_coeff_si(p, 17, 1);
    assert_false(says_rootless(p, interval, 0));
}

/* 2^3000 x + 1: the lower coefficient is past the range of doubles beside the other. */
static void test_small_coefficients(void **state) {
    question *asked = *state;
    fmpz_poly_struct *p = asked->p;
    dyadic_interval *interval = &asked->interval;
    fmpz_t big;
    fmpz_init(big);
    fmpz_one_2exp(big, 3000);
    fmpz_poly_set_coeff_fmpz(p, 1, big);
    fmpz_poly_set_coeff_si(p, 0, 1);
    interval->exponent = 3;
    fmpz_set_ui(interval->low, 0);
    fmpz_set_ui(interval->high, 1);
    assert_false(says_rootless(p, interval, 0));
    fmpz_set_ui(interval->low, 4);
    fmpz_set_ui(interval->high, 5);
    assert_true(says_rootless(p, interval, 1));
    fmpz_clear(big);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_roots_are_never_lost, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_by_hand, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_what_is_not_looked_at, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_small_coefficients, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
