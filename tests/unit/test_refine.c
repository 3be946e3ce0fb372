/* Narrowing the interval of a real algebraic number, and what rests on it, on hard inputs. Signs
 * are checked by a Tarski query, which neither narrows an interval nor takes a common factor.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fixture.h"
#include "../lib/random.h"
#include "base/number/algebraic.h"
#include "numbers.h"

#include <flint/fmpq_poly.h>

enum { LONGEST_CHAIN = 40 };

/* Sign changes at u in p, p' q, and the negated remainders that follow. */
static int changes_at(fmpq_poly_t *chain, int length, const fmpq_t u) {
    int changes = 0, last = 0;
    fmpq_t value;
    fmpq_init(value);
    for (int k = 0; k < length; k++) {
        fmpq_poly_evaluate_fmpq(value, chain[k], u);
        int sign = fmpq_sgn(value);
        changes += sign != 0 && last != 0 && sign != last;
        last = sign != 0 ? sign : last;
    }
    fmpq_clear(value);
    return changes;
}

/* Sum of the signs of q over the roots of p between low and high, which are no roots of p: the one
 * sign if there is one root (Sturm, Tarski). */
static int sign_by_tarski(const fmpz_poly_t q, const fmpz_poly_t p, const fmpq_t low,
                          const fmpq_t high) {
    fmpq_poly_t chain[LONGEST_CHAIN], other;
    int length = 2;
    for (int k = 0; k < LONGEST_CHAIN; k++)
        fmpq_poly_init(chain[k]);
    fmpq_poly_init(other);
    fmpq_poly_set_fmpz_poly(chain[0], p);
    fmpq_poly_derivative(chain[1], chain[0]);
    fmpq_poly_set_fmpz_poly(other, q);
    fmpq_poly_mul(chain[1], chain[1], other);
    for (; !fmpq_poly_is_zero(chain[length - 1]); length++) {
        assert_true(length < LONGEST_CHAIN);
        fmpq_poly_rem(chain[length], chain[length - 2], chain[length - 1]);
        fmpq_poly_neg(chain[length], chain[length]);
    }
    int sign = changes_at(chain, length, low) - changes_at(chain, length, high);
    for (int k = 0; k < LONGEST_CHAIN; k++)
        fmpq_poly_clear(chain[k]);
    fmpq_poly_clear(other);
    return sign;
}

static int sign_at(const fmpz_poly_t p, const fmpq_t u) {
    fmpq_t value;
    fmpq_init(value);
    fmpz_poly_evaluate_fmpq(value, p, u);
    int sign = fmpq_sgn(value);
    fmpq_clear(value);
    return sign;
}

static int on_upper_side(const fmpz_poly_t p, const fmpq_t low, const fmpq_t u) {
    return sign_at(p, u) != sign_at(p, low);
}

/* Order of the roots of p in [a, b] and of q in [c, d]: by the ends, else by the sign of q at the
 * first root within the common part, where q changes its sign at the second root alone. */
static int order_by_tarski(const fmpz_poly_t p, fmpq_t a, fmpq_t b, const fmpz_poly_t q, fmpq_t c,
                           fmpq_t d) {
    if (fmpq_cmp(b, c) <= 0)
        return -1;
    if (fmpq_cmp(d, a) <= 0)
        return 1;
    const fmpq *low = fmpq_cmp(a, c) > 0 ? a : c, *high = fmpq_cmp(b, d) < 0 ? b : d;
    if (on_upper_side(p, a, low))
        return -1;
    if (on_upper_side(q, c, low))
        return 1;
    if (!on_upper_side(p, a, high) || sign_at(p, high) == 0)
        return 1;
    if (!on_upper_side(q, c, high) || sign_at(q, high) == 0)
        return -1;
    int sign = sign_by_tarski(q, p, low, high);
    return sign == 0 ? 0 : sign == sign_at(q, low) ? -1 : 1;
}

static void check_narrowed(const algebraic *x, const algebraic *before, ulong gain,
                           ulong gain_before) {
    fmpq_t low, high, low_before, high_before;
    fmpq_init(low);
    fmpq_init(high);
    fmpq_init(low_before);
    fmpq_init(high_before);
    algebraic_bounds(low, high, x);
    algebraic_bounds(low_before, high_before, before);
    assert_true(fmpq_cmp(low, low_before) >= 0 && fmpq_cmp(high, high_before) <= 0);
    if (algebraic_is_rational(x)) {
        assert_int_equal(sign_at(before->poly, x->value), 0);
    } else {
        assert_true(fmpz_poly_equal(x->poly, before->poly));
        assert_int_equal(x->low_sign, sign_at(x->poly, low));
        assert_int_equal(-x->low_sign, sign_at(x->poly, high));
        int quick = gain == 2 * gain_before;
        assert_true(quick || gain == (gain_before > 1 ? gain_before / 2 : 1));
        fmpq_sub(high, high, low);
        fmpq_sub(high_before, high_before, low_before);
        fmpq_mul_2exp(high, high, quick ? gain_before : 1);
        assert_true(fmpq_equal(high, high_before));
    }
    fmpq_clear(low);
    fmpq_clear(high);
    fmpq_clear(low_before);
    fmpq_clear(high_before);
}

/* Narrow to `digits` digits or to the rational number itself; the steps it took. The interval stays
 * in the one before and p changes its sign on it, so it keeps the one root. */
static int narrow(algebraic *x, ulong digits) {
    int steps = 0;
    ulong gain = 4;
    algebraic before;
    algebraic_init(&before);
    while (!algebraic_is_rational(x) && x->where.exponent < digits) {
        ulong gain_before = gain;
        algebraic_set(&before, x);
        algebraic_refine_quadratically(x, &gain);
        check_narrowed(x, &before, gain, gain_before);
        steps++;
    }
    algebraic_clear(&before);
    return steps;
}

static void roots_in_unit_interval(algebraic_list *list, const fmpz_poly_t p) {
    dyadic_interval unit;
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    algebraic_list_init(list);
    append_roots(list, p, &unit);
    dyadic_interval_clear(&unit);
}

/* 2 x^2 - 1: digits double, so 4000 take few steps, where halvings would take 4000. */
static void test_digits_double(void **unused) {
    (void)unused;
    fmpz_poly_t p;
    algebraic_list list;
    fmpz_poly_init(p);
    fmpz_poly_set_str(p, "3  -1 0 2");
    roots_in_unit_interval(&list, p);
    assert_int_equal(list.count, 1);
    assert_in_range(narrow(&list.item[0], 4000), 5, 30);
    algebraic_list_clear(&list);
    fmpz_poly_clear(p);
}

/* (2 x^2 - 1)(2 x^2 - 1 - 2^-e): the roots are 2^-e / (2 sqrt 2) apart, so that secants mislead
 * until the interval is as short. */
static void test_close_roots(void **unused) {
    (void)unused;
    fmpz_poly_t p, q;
    fmpz_poly_init(p);
    fmpz_poly_init(q);
    for (ulong e = 10; e <= 400; e += 130) {
        algebraic_list list;
        fmpz_poly_set_str(p, "3  -1 0 2");
        fmpz_poly_scalar_mul_2exp(q, p, e);
        fmpz_sub_ui(q->coeffs, q->coeffs, 1);
        fmpz_poly_mul(p, p, q);
        roots_in_unit_interval(&list, p);
        assert_int_equal(list.count, 2);
        for (size_t k = 0; k < 2; k++)
            assert_in_range(narrow(&list.item[k], e + 1000), 1, 3 * e + 60);
        /* Above the first root, below the second, q is negative. */
        assert_int_equal(sign_of(q, &list.item[0]), -1);
        assert_int_equal(sign_of(q, &list.item[1]), 0);
        assert_int_equal(order_of(&list.item[0], &list.item[1]), -1);
        algebraic_list_clear(&list);
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(q);
}

/* (2^e x - m)(x^2 + x + 5): the root m / 2^e is met, as in the end it is a point of division and
 * the secant's root is nearest to it. */
static void test_dyadic_root(void **unused) {
    (void)unused;
    fmpz_poly_t p, positive;
    fmpq_t root;
    random_start(41);
    fmpz_poly_init(p);
    fmpz_poly_init(positive);
    fmpq_init(root);
    fmpz_poly_set_str(positive, "3  5 1 1");
    for (ulong e = 3; e <= 300; e += 27) {
        algebraic_list list;
        fmpz_randbits(fmpq_numref(root), chance, e - 1);
        fmpz_abs(fmpq_numref(root), fmpq_numref(root));
        fmpz_setbit(fmpq_numref(root), 0);
        fmpz_one_2exp(fmpq_denref(root), e);
        fmpz_poly_zero(p);
        fmpz_poly_set_coeff_fmpz(p, 1, fmpq_denref(root));
        fmpz_poly_set_coeff_fmpz(p, 0, fmpq_numref(root));
        fmpz_neg(p->coeffs, p->coeffs);
        fmpz_poly_mul(p, p, positive);
        roots_in_unit_interval(&list, p);
        assert_int_equal(list.count, 1);
        narrow(&list.item[0], 10 * e + 100);
        assert_true(algebraic_is_rational(&list.item[0]));
        assert_true(fmpq_equal(list.item[0].value, root));
        algebraic_list_clear(&list);
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(positive);
    fmpq_clear(root);
}

/* 2^k (3 x - 1)^5 - x^2: a simple root where the curve is almost flat. And coefficients of 3000
 * bits. */
static void test_flat_and_huge(void **unused) {
    (void)unused;
    fmpz_poly_t p;
    fmpz_t c;
    size_t huge = 0;
    random_start(42);
    fmpz_poly_init(p);
    fmpz_init(c);
    for (int round = 0; round < 60; round++) {
        algebraic_list list;
        if (round % 3 == 0) {
            fmpz_poly_set_str(p, "2  -1 3");
            fmpz_poly_pow(p, p, 5);
            fmpz_poly_scalar_mul_2exp(p, p, 10 * (ulong)round);
            fmpz_sub_ui(p->coeffs + 2, p->coeffs + 2, 1);
        } else {
            for (slong k = 0; k < 6; k++) {
                fmpz_randbits(c, chance, 3000);
                fmpz_poly_set_coeff_fmpz(p, k, c);
            }
        }
        roots_in_unit_interval(&list, p);
        assert_true(round % 3 != 0 || list.count >= 1);
        for (size_t k = 0; k < list.count; k++, huge += round % 3 != 0)
            narrow(&list.item[k], 2500);
        algebraic_list_clear(&list);
    }
    assert_true(huge > 10);
    fmpz_poly_clear(p);
    fmpz_clear(c);
}

static void random_polynomial(fmpz_poly_t out, slong degree, ulong bits) {
    fmpz_t c;
    fmpz_init(c);
    fmpz_poly_zero(out);
    do
        for (slong k = 0; k <= degree; k++) {
            fmpz_randbits(c, chance, 1 + (ulong)draw_below(bits));
            fmpz_poly_set_coeff_fmpz(out, k, c);
        }
    while (fmpz_poly_degree(out) < degree);
    fmpz_clear(c);
}

static void check_pair(const fmpz_poly_t p, algebraic *x, const fmpz_poly_t q, algebraic *y,
                       int *seen) {
    fmpq_t a, b, c, d;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_init(c);
    fmpq_init(d);
    algebraic_bounds(a, b, x);
    algebraic_bounds(c, d, y);
    int x_given = algebraic_is_rational(x), y_given = algebraic_is_rational(y);
    if (!x_given && !y_given) {
        int order = order_by_tarski(p, a, b, q, c, d), sign = sign_by_tarski(q, p, a, b);
        if (sign_of(q, x) != sign || order_of(x, y) != order || order_of(y, x) != -order) {
            fmpz_poly_print_pretty(p, "x");
            flint_printf(" and ");
            fmpz_poly_print_pretty(q, "x");
            fail_msg(": sign %d or order %d is not confirmed", sign, order);
        }
        seen[order + 1]++;
    }
    fmpq_clear(a);
    fmpq_clear(b);
    fmpq_clear(c);
    fmpq_clear(d);
}

/* p = g r against q random, q = g s, and q = 2^k g s + 1 or - 1, whose roots lie close to those of
 * g. r and s are such that p and q have simple roots only. */
static void test_against_tarski(void **unused) {
    (void)unused;
    fmpz_poly_t g, p, q;
    int seen[3] = {0, 0, 0};
    random_start(43);
    fmpz_poly_init(g);
    fmpz_poly_init(p);
    fmpz_poly_init(q);
    for (int round = 0; round < 1500; round++) {
        ulong bits = 2 + (ulong)draw_below(60);
        random_polynomial(g, 1 + draw_below(3), bits);
        random_polynomial(p, draw_below(4), bits);
        random_polynomial(q, draw_below(4), bits);
        fmpz_poly_mul(p, p, g);
        if (round % 4 > 0)
            fmpz_poly_mul(q, q, g);
        if (round % 4 > 1) {
            fmpz_poly_scalar_mul_2exp(q, q, (ulong)draw_below(200));
            fmpz_add_si(q->coeffs, q->coeffs, round % 4 == 2 ? 1 : -1);
        }
        if (fmpz_poly_degree(q) < 1 || !fmpz_poly_is_squarefree(p) || !fmpz_poly_is_squarefree(q))
            continue;
        algebraic_list x, y;
        roots_in_unit_interval(&x, p);
        roots_in_unit_interval(&y, q);
        algebraic u, v;
        algebraic_init(&u);
        algebraic_init(&v);
        for (size_t i = 0; i < x.count; i++)
            for (size_t j = 0; j < y.count; j++) {
                algebraic_set(&u, &x.item[i]);
                algebraic_set(&v, &y.item[j]);
                check_pair(p, &u, q, &v, seen);
            }
        algebraic_clear(&u);
        algebraic_clear(&v);
        algebraic_list_clear(&x);
        algebraic_list_clear(&y);
    }
    assert_true(seen[0] > 100 && seen[1] > 100 && seen[2] > 100);
    fmpz_poly_clear(g);
    fmpz_poly_clear(p);
    fmpz_poly_clear(q);
}

/* p = a (u^4 - 1) - 1 and q = a (u - 1) - side u^2 in t, a = 2^k and u = 2^e t. */
static void set_uneven_pair(fmpz_poly_t p, fmpz_poly_t q, ulong k, ulong e, int side) {
    fmpz_poly_set_str(p, "5  -1 0 0 0 1");
    fmpz_poly_set_str(q, "2  -1 1");
    fmpz_poly_scalar_mul_2exp(p, p, k);
    fmpz_poly_scalar_mul_2exp(q, q, k);
    fmpz_sub_ui(p->coeffs, p->coeffs, 1);
    fmpz_poly_set_coeff_si(q, 2, -side);
    for (slong i = 0; i <= 4; i++)
        fmpz_mul_2exp(p->coeffs + i, p->coeffs + i, e * (ulong)i);
    for (slong i = 0; i <= 2; i++)
        fmpz_mul_2exp(q->coeffs + i, q->coeffs + i, e * (ulong)i);
}

/* Neither number is known to far more places than the distance of the pair has. */
static void check_places(const algebraic *x, const algebraic *y, ulong distance) {
    assert_true(x->where.exponent < 4 * distance && y->where.exponent < 4 * distance);
}

/* With e < k, p has one root in the unit interval, u = (1 + 1/a)^(1/4), where secants help only
 * after e halvings. q is nearly straight; u = 1 + side u^2 / a at its one root there: beyond
 * 1 + 1/a, or below 1. So p's root is less, or greater, by about 2^-(k + e). */
static void test_uneven_pairs(void **unused) {
    (void)unused;
    static const ulong exponent[] = {60, 199, 1000};
    fmpz_poly_t p, q;
    fmpz_poly_init(p);
    fmpz_poly_init(q);
    for (int round = 0; round < 36; round++) {
        ulong k = exponent[round % 3], e = round % 2 ? 20 : 50;
        int side = round / 6 % 2 ? 1 : -1, order = 2;
        algebraic_list first, second;
        fmpq_t middle;
        fmpq_init(middle);
        set_uneven_pair(p, q, k, e, side);
        roots_in_unit_interval(&first, p);
        if (round >= 24) /* the product has both roots, and one is p's */
            fmpz_poly_mul(q, q, p);
        roots_in_unit_interval(&second, q);
        algebraic *x = first.item, *y = second.item;
        assert_int_equal(first.count, 1);
        assert_int_equal(second.count, round >= 24 ? 2 : 1);
        if (round < 12) {
            assert_int_equal(algebraic_compare(&order, context, x, y), GRAZE_OK);
            assert_int_equal(order, -side);
        } else if (round < 24) {
            assert_int_equal(algebraic_between(middle, context, side > 0 ? x : y, side > 0 ? y : x),
                             GRAZE_OK);
            assert_int_equal(sign_at(p, middle), side);
            assert_int_equal(sign_at(q, middle), -side);
        } else {
            for (int j = 0; j < 2; j++) {
                assert_int_equal(algebraic_compare(&order, context, &y[j], x), GRAZE_OK);
                assert_int_equal(order, j == (side < 0) ? 0 : side);
            }
        }
        check_places(x, y, k + e);
        fmpq_clear(middle);
        algebraic_list_clear(&first);
        algebraic_list_clear(&second);
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(q);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_digits_double),
        cmocka_unit_test(test_close_roots),
        cmocka_unit_test(test_dyadic_root),
        cmocka_unit_test(test_flat_and_huge),
        cmocka_unit_test(test_against_tarski),
        cmocka_unit_test_setup_teardown(test_uneven_pairs, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
