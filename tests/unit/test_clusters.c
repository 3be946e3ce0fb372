/* Isolation of roots that lie close together: each list is certified by signs at the ends of its
 * intervals, evaluated by FLINT, and by a count that stands beside the family.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fixture.h"
#include "../lib/random.h"
#include "base/number/algebraic.h"
#include "numbers.h"

#include <flint/arith.h>

static size_t polls, polls_allowed;

static int count_polls(void *unused) {
    (void)unused;
    return ++polls > polls_allowed;
}

static int sign_of_value(const fmpz_poly_t p, const fmpq_t x) {
    fmpq_t value;
    fmpq_init(value);
    fmpz_poly_evaluate_fmpq(value, p, x);
    int sign = fmpq_sgn(value);
    fmpq_clear(value);
    return sign;
}

/* The list has the expected number of roots; each is a root by itself or between ends of different
 * signs, and they are ascending and apart. */
static void certify(const algebraic_list *list, const fmpz_poly_t p, size_t expected) {
    fmpq_t low, high, last;
    fmpq_init(low);
    fmpq_init(high);
    fmpq_init(last);
    assert_int_equal(list->count, expected);
    for (size_t k = 0; k < list->count; k++) {
        algebraic_bounds(low, high, &list->item[k]);
        assert_true(sign_of_value(p, low) * sign_of_value(p, high) ==
                    (algebraic_is_rational(&list->item[k]) ? 0 : -1));
        assert_true(k == 0 || fmpq_cmp(last, low) <= 0);
        fmpq_set(last, high);
    }
    fmpq_clear(low);
    fmpq_clear(high);
    fmpq_clear(last);
}

static void check_roots(const fmpz_poly_t p, size_t expected) {
    algebraic_list list;
    dyadic_interval unit;
    algebraic_list_init(&list);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    append_roots(&list, p, &unit);
    certify(&list, p, expected);
    for (size_t k = 1; k < list.count; k++)
        assert_int_equal(order_of(&list.item[k - 1], &list.item[k]), -1);
    dyadic_interval_clear(&unit);
    algebraic_list_clear(&list);
}

static void power_of_ten(fmpz_t out, ulong digits) {
    fmpz_set_ui(out, 10);
    fmpz_pow_ui(out, out, digits);
}

/* x^n + factor (a x - 1)^v */
static void mignotte(fmpz_poly_t out, slong n, slong factor, const fmpz_t a, ulong v) {
    fmpz_poly_t power;
    fmpz_poly_init(power);
    fmpz_poly_set_coeff_fmpz(power, 1, a);
    fmpz_poly_set_coeff_si(power, 0, -1);
    fmpz_poly_pow(power, power, v);
    fmpz_poly_scalar_mul_si(power, power, factor);
    fmpz_poly_zero(out);
    fmpz_poly_set_coeff_si(out, n, 1);
    fmpz_poly_add(out, out, power);
    fmpz_poly_clear(power);
}

/* x^n - 2 (a x - 1)^v with a >= 10, v < n / 2: at 1/a it is positive. For v even it is negative at
 * 0, at 2/a and at 1, and has by Descartes' rule, applied after x = 1/a -+ y, one root on either
 * side of 1/a. For v odd it is positive at 0 and 1/a and negative beyond: one root. With + 2 and v
 * even there is none, but v complex ones are as close. */
static void test_mignotte(void **unused) {
    (void)unused;
    fmpz_t a;
    fmpz_poly_t p;
    fmpz_init(a);
    fmpz_poly_init(p);
    static const slong degree[] = {5, 12, 30, 100};
    for (size_t k = 0; k < 4; k++)
        for (ulong digits = 1; digits <= 31; digits += 10)
            for (ulong v = 2; v <= 3 && 2 * (slong)v < degree[k]; v++) {
                power_of_ten(a, digits);
                mignotte(p, degree[k], -2, a, v);
                check_roots(p, v % 2 ? 1 : 2);
                mignotte(p, degree[k], 2, a, v);
                check_roots(p, v % 2 ? 1 : 0);
            }
    fmpz_clear(a);
    fmpz_poly_clear(p);
}

/* Mignotte's polynomials around dyadic numbers 2^-e, times 2^e x - 1: the point between their two
 * close roots is a root, met by exact halvings or by leaps. */
static void test_dyadic_middle(void **unused) {
    (void)unused;
    fmpz_t a;
    fmpz_poly_t p, line;
    fmpz_init(a);
    fmpz_poly_init(p);
    fmpz_poly_init(line);
    for (ulong e = 1; e <= 121; e += 30) {
        fmpz_one_2exp(a, e);
        fmpz_poly_set_coeff_fmpz(line, 1, a);
        fmpz_poly_set_coeff_si(line, 0, -1);
        mignotte(p, 40, -4, a, 2);
        check_roots(p, 2);
        fmpz_poly_mul(p, p, line);
        check_roots(p, 3);
    }
    fmpz_clear(a);
    fmpz_poly_clear(p);
    fmpz_poly_clear(line);
}

/* The product of x^40 - 2 (a x - 1)^2 and x^40 - 3 (a x - 1)^2: two pairs, each of whose roots is
 * closer to one of the other pair than to its own other one; and with 2^-b x + 1/a for x, two
 * clusters 2^-b apart. */
static void test_nested(void **unused) {
    (void)unused;
    fmpz_t a;
    fmpz_poly_t p, q;
    fmpz_init(a);
    fmpz_poly_init(p);
    fmpz_poly_init(q);
    for (ulong digits = 4; digits <= 16; digits += 6) {
        power_of_ten(a, digits);
        mignotte(p, 40, -2, a, 2);
        mignotte(q, 40, -3, a, 2);
        fmpz_poly_mul(p, p, q);
        check_roots(p, 4);
        power_of_ten(a, digits);
        fmpz_add_ui(a, a, 1);
        mignotte(q, 40, -2, a, 2);
        fmpz_poly_mul(p, p, q);
        check_roots(p, 6);
    }
    fmpz_clear(a);
    fmpz_poly_clear(p);
    fmpz_poly_clear(q);
}

/* T_n(2 x - 1): all n roots between 0 and 1. (20 x - 1) ... (20 x - 20) + 2^-e: with e large, still
 * all of them, the last one above 1 or below by the sign. */
static void test_spread(void **unused) {
    (void)unused;
    fmpz_poly_t p, line;
    fmpz_poly_init(p);
    fmpz_poly_init(line);
    fmpz_poly_set_str(line, "2  -1 2");
    for (ulong n = 2; n <= 90; n += 22) {
        arith_chebyshev_t_polynomial(p, n);
        fmpz_poly_compose(p, p, line);
        check_roots(p, n);
    }
    fmpz_poly_one(p);
    for (slong k = 1; k <= 20; k++) {
        fmpz_poly_set_coeff_si(line, 0, -k);
        fmpz_poly_set_coeff_si(line, 1, 20);
        fmpz_poly_mul(p, p, line);
    }
    check_roots(p, 20);
    fmpz_poly_scalar_mul_2exp(p, p, 200);
    fmpz_add_ui(p->coeffs, p->coeffs, 1);
    check_roots(p, 20);
    fmpz_sub_ui(p->coeffs, p->coeffs, 2);
    check_roots(p, 19);
    fmpz_poly_clear(p);
    fmpz_poly_clear(line);
}

/* The limit is met by the pair that needs about 5100 places, and not when it is that high. */
static void test_limit(void **unused) {
    (void)unused;
    fmpz_t a;
    fmpz_poly_t p;
    algebraic_list list;
    dyadic_interval unit;
    fmpz_init(a);
    fmpz_poly_init(p);
    algebraic_list_init(&list);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    power_of_ten(a, 30);
    mignotte(p, 100, -2, a, 2);
    static const unsigned long limit[] = {20, 200, 5070, 5100};
    for (size_t k = 0; k < 4; k++) {
        list.count = 0;
        assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_BITS, limit[k]), GRAZE_OK);
        assert_int_equal(algebraic_roots(&list, context, p, &unit),
                         k < 3 ? GRAZE_ELIMIT : GRAZE_OK);
    }
    certify(&list, p, 2);
    /* Numbers no further apart than the two are told apart within the limit or not at all. */
    int order;
    assert_int_equal(algebraic_compare(&order, context, &list.item[0], &list.item[1]), GRAZE_OK);
    assert_int_equal(order, -1);
    fmpz_clear(a);
    fmpz_poly_clear(p);
    algebraic_list_clear(&list);
    dyadic_interval_clear(&unit);
}

/* x^2 - 2^-1 and x^2 - 2^-1 - 2^-e: the order needs about e places, the sign too. */
static void test_narrowing_limit(void **unused) {
    (void)unused;
    fmpz_poly_t p, q;
    algebraic_list list;
    dyadic_interval unit;
    fmpz_poly_init(p);
    fmpz_poly_init(q);
    algebraic_list_init(&list);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    fmpz_poly_set_str(p, "3  -1 0 2");
    fmpz_poly_scalar_mul_2exp(q, p, 20000);
    fmpz_sub_ui(q->coeffs, q->coeffs, 1);
    append_roots(&list, p, &unit);
    append_roots(&list, q, &unit);
    int sign;
    fmpq_t middle;
    fmpq_init(middle);
    algebraic *x = &list.item[0], *y = &list.item[1];
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_BITS, 5000), GRAZE_OK);
    assert_int_equal(algebraic_compare(&sign, context, x, y), GRAZE_ELIMIT);
    assert_int_equal(algebraic_sign_at(&sign, context, q, x), GRAZE_ELIMIT);
    assert_int_equal(algebraic_between(middle, context, x, y), GRAZE_ELIMIT);
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_BITS, 50000), GRAZE_OK);
    assert_int_equal(algebraic_compare(&sign, context, x, y), GRAZE_OK);
    assert_int_equal(sign, -1);
    assert_int_equal(algebraic_sign_at(&sign, context, q, x), GRAZE_OK);
    assert_int_equal(sign, -1);
    assert_int_equal(algebraic_between(middle, context, x, y), GRAZE_OK);
    assert_int_equal(sign_of_value(p, middle), 1);
    assert_int_equal(sign_of_value(q, middle), -1);
    fmpq_clear(middle);
    fmpz_poly_clear(p);
    fmpz_poly_clear(q);
    algebraic_list_clear(&list);
    dyadic_interval_clear(&unit);
}

/* Every poll can end the isolation, and there are many. */
static void test_cancel(void **unused) {
    (void)unused;
    fmpz_t a;
    fmpz_poly_t p;
    algebraic_list list;
    dyadic_interval unit;
    fmpz_init(a);
    fmpz_poly_init(p);
    algebraic_list_init(&list);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    power_of_ten(a, 20);
    mignotte(p, 60, -2, a, 2);
    graze_context_set_cancel(context, count_polls, NULL);
    polls_allowed = SIZE_MAX;
    assert_int_equal(algebraic_roots(&list, context, p, &unit), GRAZE_OK);
    size_t all = polls;
    assert_true(all >= 10);
    for (polls_allowed = 0; polls_allowed < all; polls_allowed++) {
        polls = 0;
        context->work = 0;
        assert_int_equal(algebraic_roots(&list, context, p, &unit), GRAZE_ECANCELED);
        assert_int_equal(polls, polls_allowed + 1);
    }
    fmpz_clear(a);
    fmpz_poly_clear(p);
    algebraic_list_clear(&list);
    dyadic_interval_clear(&unit);
}

/* Values at points as close to a root as the distance of the pair, by truncated and by exact
 * arithmetic. */
static void test_signs(void **unused) {
    (void)unused;
    fmpz_t a, numerator;
    fmpz_poly_t p;
    fmpq_t x;
    int seen[3] = {0, 0, 0};
    random_start(41);
    fmpz_init(a);
    fmpz_init(numerator);
    fmpz_poly_init(p);
    fmpq_init(x);
    for (int round = 0; round < 300; round++) {
        ulong digits = 1 + (ulong)draw_below(12), exponent = 1 + (ulong)draw_below(3000);
        power_of_ten(a, digits);
        mignotte(p, 10 + draw_below(40), -2, a, 2);
        if (round % 2) { /* near 1/a, of any size and sign otherwise */
            fmpz_one_2exp(numerator, exponent);
            fmpz_fdiv_q(numerator, numerator, a);
        } else {
            fmpz_randtest(numerator, chance, exponent + 5);
        }
        if (round % 3 == 0) { /* a root that is dyadic */
            fmpz_poly_t line;
            fmpz_poly_init(line);
            fmpz_neg(a, numerator);
            fmpz_poly_set_coeff_fmpz(line, 0, a);
            fmpz_one_2exp(a, exponent);
            fmpz_poly_set_coeff_fmpz(line, 1, a);
            if (!fmpz_is_zero(numerator))
                fmpz_poly_mul(p, p, line);
            fmpz_poly_clear(line);
        }
        dyadic_value(x, numerator, exponent);
        int sign = sign_of_value(p, x);
        assert_int_equal(dyadic_sign(p, numerator, exponent), sign);
        seen[sign + 1]++;
    }
    assert_true(seen[0] > 20 && seen[1] > 20 && seen[2] > 20);
    fmpz_clear(a);
    fmpz_clear(numerator);
    fmpz_poly_clear(p);
    fmpq_clear(x);
}

/* x^k (a x^2 + a x - 1), and what x -> 1 - x makes of it: a root of any multiplicity at an end of
 * the interval, and one about 1/a away from it. */
static void roots_near_repeated_ends(void **state) {
    (void)state;
    fmpz_poly_t p, mirror;
    fmpz_poly_init(p);
    fmpz_poly_init(mirror);
    fmpz_poly_set_coeff_si(mirror, 0, 1);
    fmpz_poly_set_coeff_si(mirror, 1, -1);
    for (slong k = 1; k <= 4; k++)
        for (ulong bits = 20; bits <= 420; bits += 100) {
            fmpz_t a;
            fmpz_init(a);
            fmpz_one_2exp(a, bits);
            fmpz_poly_zero(p);
            fmpz_poly_set_coeff_si(p, k, -1);
            fmpz_poly_set_coeff_fmpz(p, k + 1, a);
            fmpz_poly_set_coeff_fmpz(p, k + 2, a);
            fmpz_clear(a);
            check_roots(p, 2);
            fmpz_poly_compose(p, p, mirror);
            check_roots(p, 2);
        }
    fmpz_poly_clear(p);
    fmpz_poly_clear(mirror);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mignotte),
        cmocka_unit_test(test_dyadic_middle),
        cmocka_unit_test(test_nested),
        cmocka_unit_test(test_spread),
        cmocka_unit_test(roots_near_repeated_ends),
        cmocka_unit_test(test_signs),
        cmocka_unit_test_setup_teardown(test_limit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_narrowing_limit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_cancel, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
