/* Real algebraic numbers: roots, order and signs against polynomials built from known roots.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include "../lib/random.h"

#include <math.h>
#include "base/number/algebraic.h"
#include "base/number/simplest.h"
#include "numbers.h"

/* A root known in advance: p/q, or the positive root of n x^2 = m, that is sqrt(m/n). */
typedef struct known {
    slong m, n;
    int irrational;
} known;

static void known_factor(fmpz_poly_t out, known k) {
    fmpz_poly_zero(out);
    fmpz_poly_set_coeff_si(out, 0, -k.m);
    fmpz_poly_set_coeff_si(out, k.irrational ? 2 : 1, k.n);
}

/* a < b for positive numbers: compare a^2 and b^2, which are rational. */
static int known_less(known a, known b) {
    slong am = a.irrational ? a.m : a.m * a.m, an = a.irrational ? a.n : a.n * a.n;
    slong bm = b.irrational ? b.m : b.m * b.m, bn = b.irrational ? b.n : b.n * b.n;
    return am * bn < bm * an;
}

static int is_square(slong m) {
    for (slong k = 0; k * k <= m; k++)
        if (k * k == m)
            return 1;
    return 0;
}

/* A known number in (0, 1]; the irrational ones have m/n that is no square, as neither m n is. */
static known random_known(void) {
    for (;;) {
        known k = {draw_below(12) + 1, draw_below(12) + 1, (int)draw_below(2)};
        if (k.m <= k.n && !(k.irrational && is_square(k.m * k.n)))
            return k;
    }
}

/* Products of known factors with random multiplicities: the roots come out each once and in order,
 * and each vanishes on its own factor and on no other one's. */
static void test_known_roots(void **unused) {
    (void)unused;
    random_start(20261121);
    for (int round = 0; round < 400; round++) {
        known root[5];
        int n = (int)draw_below(5) + 1, kept = 0;
        fmpz_poly_t p, factor;
        fmpz_poly_init(p);
        fmpz_poly_init(factor);
        fmpz_poly_set_si(p, round % 2 ? 3 : -2);
        for (int k = 0; k < n; k++) {
            known candidate = random_known();
            int place = kept, repeated = 0;
            for (int j = 0; j < kept; j++)
                repeated |= !known_less(root[j], candidate) && !known_less(candidate, root[j]);
            known_factor(factor, candidate);
            for (ulong e = draw_below(3) + 1; e > 0; e--)
                fmpz_poly_mul(p, p, factor);
            if (repeated)
                continue;
            while (place > 0 && known_less(candidate, root[place - 1])) {
                root[place] = root[place - 1];
                place--;
            }
            root[place] = candidate;
            kept++;
        }
        algebraic_list list;
        algebraic_list_init(&list);
        append_roots(&list, p, &unit_interval);
        if ((int)list.count != kept) {
            fmpz_poly_print_pretty(p, "x");
            fail_msg(": %zu roots instead of %d", list.count, kept);
        }
        for (int k = 0; k < kept; k++)
            for (int j = 0; j < kept; j++) {
                known_factor(factor, root[j]);
                /* The factor n x^e - m is negative below its root. */
                int expected = k < j ? -1 : k > j;
                assert_int_equal(sign_of(factor, &list.item[k]), expected);
                assert_int_equal(order_of(&list.item[k], &list.item[j]), expected);
            }
        algebraic_list_clear(&list);
        fmpz_poly_clear(p);
        fmpz_poly_clear(factor);
    }
}

/* Whether a known number is in [low / 2^e, high / 2^e], by squares. */
static int is_within(known k, slong low, slong high, int e) {
    known from = {low, (slong)1 << e, 0}, to = {high, (slong)1 << e, 0};
    return !known_less(k, from) && !known_less(to, k);
}

/* Windows around roots, wide and narrow, of products with random multiplicities: a fraction among
 * the roots is divided out, and those in the window come out each once and in order. */
static void test_windows(void **unused) {
    (void)unused;
    random_start(20261123);
    dyadic_interval window;
    dyadic_interval_init(&window);
    for (int round = 0; round < 600; round++) {
        known root[] = {random_known(), random_known()};
        int e = (int)draw_below(14), order = known_less(root[1], root[0]);
        known first = root[order], second = root[1 - order];
        int same = !known_less(first, second);
        double at = (double)root[0].m / (double)root[0].n;
        slong low = (slong)ldexp(root[0].irrational ? sqrt(at) : at, e);
        slong below = (slong)draw_below(3), to = low + 1 + (slong)draw_below(3);
        slong from = low > below ? low - below : 0;
        fmpz_poly_t p, factor;
        fmpz_poly_init(p);
        fmpz_poly_init(factor);
        fmpz_poly_one(p);
        for (int k = 0; k < 2; k++) {
            known_factor(factor, root[k]);
            for (ulong times = draw_below(3) + 1; times > 0; times--)
                fmpz_poly_mul(p, p, factor);
        }
        dyadic_interval_set_si(&window, from, to);
        window.exponent = (ulong)e;
        algebraic_list list;
        algebraic_list_init(&list);
        append_roots(&list, p, &window);
        known inside[2];
        size_t expected = 0;
        if (is_within(first, from, to, e))
            inside[expected++] = first;
        if (!same && is_within(second, from, to, e))
            inside[expected++] = second;
        if (list.count != expected) {
            fmpz_poly_print_pretty(p, "x");
            fail_msg(" in [%ld, %ld] / 2^%d: %zu roots instead of %zu", from, to, e, list.count,
                     expected);
        }
        for (size_t k = 0; k < expected; k++) {
            known_factor(factor, inside[k]);
            assert_int_equal(sign_of(factor, &list.item[k]), 0);
        }
        algebraic_list_clear(&list);
        fmpz_poly_clear(p);
        fmpz_poly_clear(factor);
    }
    dyadic_interval_clear(&window);
}

/* The fraction of least denominator in a window, by trying all of them: it is divided out as a root
 * of its multiplicity, and no other one is. */
static void test_simplest(void **unused) {
    (void)unused;
    random_start(20261124);
    dyadic_interval window;
    dyadic_interval_init(&window);
    for (int round = 0; round < 2000; round++) {
        slong e = (slong)draw_below(9), unit = (slong)1 << e;
        slong low = (slong)draw_below((ulong)(3 * unit)), high = low + 1 + (slong)draw_below(4);
        slong a = 0, b = 0;
        for (int found = 0; !found;) {
            b++;
            a = (low * b + unit - 1) / unit;
            found = a * unit <= high * b;
        }
        int times = (int)draw_below(3), other = (int)draw_below(2);
        fmpz_poly_t p, factor, rest;
        fmpq_t root;
        fmpz_t large;
        fmpz_poly_init(p);
        fmpz_poly_init(factor);
        fmpz_poly_init(rest);
        fmpq_init(root);
        fmpz_init(large);
        fmpz_poly_set_coeff_si(p, 2, other ? 7 : 1);
        fmpz_poly_set_coeff_si(p, 0, -5);
        fmpz_set_ui(large, 3);
        fmpz_pow_ui(large, large, (ulong)draw_below(90));
        fmpz_poly_scalar_mul_fmpz(p, p, large);
        fmpz_poly_set(rest, p);
        fmpz_poly_set_coeff_si(factor, 1, b);
        fmpz_poly_set_coeff_si(factor, 0, -a);
        for (int k = 0; k < times; k++)
            fmpz_poly_mul(p, p, factor);
        fmpz_poly_swap(factor, rest);
        dyadic_interval_set_si(&window, low, high);
        window.exponent = (ulong)e;
        int empty;
        assert_int_equal(divide_by_simplest(root, rest, &empty, p, &window), times > 0);
        /* 7 x^2 - 5 or x^2 - 5 grows, so it has a root in there if it is negative at one end alone.
         */
        slong lead = other ? 7 : 1, five = 5 * unit * unit;
        assert_false(empty && lead * low * low < five && lead * high * high > five);
        if (times > 0) {
            assert_true(fmpz_poly_equal(rest, factor));
            fmpq_t least;
            fmpq_init(least);
            fmpq_set_si(least, a, (ulong)b);
            assert_true(fmpq_equal(root, least));
            fmpq_clear(least);
        }
        fmpz_poly_clear(p);
        fmpz_poly_clear(factor);
        fmpz_poly_clear(rest);
        fmpq_clear(root);
        fmpz_clear(large);
    }
    dyadic_interval_clear(&window);
}

/* The number of roots in (0, 1] by Sturm's theorem, as FLINT counts them over all of R after moving
 * (0, 1) to R+ and squaring; a second method for random polynomials. */
static slong count_by_sturm(const fmpz_poly_t p) {
    fmpz_poly_t moved, shifted;
    fmpz_t value, one;
    fmpz_poly_init(moved);
    fmpz_poly_init(shifted);
    fmpz_init(value);
    fmpz_init_set_ui(one, 1);
    /* q(y) = (1 + y)^n p(1 / (1 + y)): y > 0 is x in (0, 1). Then q(z^2) has twice as many roots,
     * none at 0. */
    fmpz_poly_reverse(moved, p, fmpz_poly_length(p));
    fmpz_poly_taylor_shift(moved, moved, one);
    fmpz_poly_inflate(shifted, moved, 2);
    fmpz_poly_primitive_part(shifted, shifted);
    fmpz_poly_evaluate_fmpz(value, p, one);
    slong at_one = fmpz_is_zero(value);
    while (fmpz_poly_degree(shifted) > 0 && fmpz_is_zero(shifted->coeffs))
        fmpz_poly_shift_right(shifted, shifted, 1);
    fmpz_poly_t squarefree, g;
    fmpz_poly_init(squarefree);
    fmpz_poly_init(g);
    fmpz_poly_derivative(g, shifted);
    fmpz_poly_gcd(g, shifted, g);
    fmpz_poly_div(squarefree, shifted, g);
    slong all = fmpz_poly_num_real_roots_sturm(squarefree);
    fmpz_poly_clear(squarefree);
    fmpz_poly_clear(g);
    fmpz_poly_clear(moved);
    fmpz_poly_clear(shifted);
    fmpz_clear(value);
    fmpz_clear(one);
    return all / 2 + at_one;
}

static void test_counts_against_sturm(void **unused) {
    (void)unused;
    random_start(7);
    slong total = 0;
    for (int round = 0; round < 2000; round++) {
        fmpz_poly_t p;
        fmpz_poly_init(p);
        slong degree = draw_below(9) + 1;
        for (slong k = 0; k <= degree; k++)
            fmpz_poly_set_coeff_si(p, k, draw_below(41) - 20);
        if (fmpz_poly_is_zero(p) || fmpz_is_zero(p->coeffs)) {
            fmpz_poly_clear(p);
            continue;
        }
        algebraic_list list;
        algebraic_list_init(&list);
        append_roots(&list, p, &unit_interval);
        total += (slong)list.count;
        if ((slong)list.count != count_by_sturm(p)) {
            fmpz_poly_print_pretty(p, "x");
            fail_msg(": %zu roots, Sturm counts %ld", list.count, (long)count_by_sturm(p));
        }
        for (size_t k = 0; k < list.count; k++)
            assert_int_equal(sign_of(p, &list.item[k]), 0);
        algebraic_list_clear(&list);
        fmpz_poly_clear(p);
    }
    assert_true(total > 500);
}

/* 2 x^2 - 1 and the same polynomial moved by 2^-300: roots no double tells apart. */
static void test_near_miss(void **unused) {
    (void)unused;
    fmpz_poly_t p, q;
    fmpz_poly_init(p);
    fmpz_poly_init(q);
    fmpz_poly_set_coeff_si(p, 0, -1);
    fmpz_poly_set_coeff_si(p, 2, 2);
    for (int sign = -1; sign <= 1; sign += 2) {
        fmpz_t big;
        fmpz_init(big);
        fmpz_one_2exp(big, 300);
        fmpz_poly_scalar_mul_fmpz(q, p, big);
        fmpz_sub_si(q->coeffs, q->coeffs, sign);
        algebraic_list list;
        algebraic_list_init(&list);
        append_roots(&list, p, &unit_interval);
        append_roots(&list, q, &unit_interval);
        assert_int_equal(list.count, 2);
        /* q = 2^300 p - sign: where p vanishes q has the sign -sign, and its root lies on the side
         * sign. */
        assert_int_equal(sign_of(q, &list.item[0]), -sign);
        assert_int_equal(order_of(&list.item[1], &list.item[0]), sign);
        algebraic_list_clear(&list);
        fmpz_clear(big);
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(q);
}

/* Roots exactly at both ends of a window and in its middle, of multiplicity two. */
static void test_ends(void **unused) {
    (void)unused;
    dyadic_interval window;
    dyadic_interval_init(&window);
    fmpz_set_si(window.low, 1);
    fmpz_set_si(window.high, 3);
    window.exponent = 2;
    fmpz_poly_t p;
    fmpz_poly_init(p);
    /* ((4x - 1)(2x - 1)(4x - 3))^2 */
    fmpz_poly_set_str(p, "4  -3 22 -48 32");
    fmpz_poly_mul(p, p, p);
    algebraic_list list;
    algebraic_list_init(&list);
    append_roots(&list, p, &window);
    assert_int_equal(list.count, 3);
    for (int k = 0; k < 3; k++) {
        fmpq_t expected;
        fmpq_init(expected);
        fmpq_set_si(expected, k + 1, 4);
        assert_true(algebraic_is_rational(&list.item[k]));
        assert_true(fmpq_equal(list.item[k].value, expected));
        fmpq_clear(expected);
    }
    algebraic_list_clear(&list);
    fmpz_poly_clear(p);
    dyadic_interval_clear(&window);
}

/* Between two numbers there is a third, also when one or both are irrational. */
static void test_between(void **unused) {
    (void)unused;
    fmpz_poly_t p;
    fmpz_poly_init(p);
    fmpz_poly_set_str(p, "5  1 0 -5 0 6"); /* (2x^2 - 1)(3x^2 - 1) */
    algebraic_list list;
    algebraic_list_init(&list);
    append_roots(&list, p, &unit_interval);
    assert_int_equal(list.count, 2);
    algebraic middle;
    algebraic_init(&middle);
    assert_int_equal(algebraic_between(middle.value, NULL, &list.item[0], &list.item[1]), GRAZE_OK);
    assert_int_equal(order_of(&list.item[0], &middle), -1);
    assert_int_equal(order_of(&middle, &list.item[1]), -1);
    algebraic_clear(&middle);
    algebraic_list_clear(&list);
    fmpz_poly_clear(p);
}

/* No part is guessed for constants, for high degrees, or for long ends; any other guess lies in the
 * interval. */
static void test_guesses(void **state) {
    (void)state;
    dyadic_interval whole, part;
    fmpz_poly_t p;
    dyadic_interval_init(&whole);
    dyadic_interval_init(&part);
    fmpz_poly_init(p);
    dyadic_interval_set_si(&whole, 0, 1);
    fmpz_poly_one(p);
    assert_int_equal(guess_interval(&part, p, &whole), 0);
    fmpz_poly_set_coeff_si(p, 25, -2);
    assert_int_equal(guess_interval(&part, p, &whole), 0);
    fmpz_poly_zero(p);
    fmpz_poly_set_coeff_si(p, 0, -1);
    fmpz_poly_set_coeff_si(p, 1, 3);
    assert_int_equal(guess_interval(&part, p, &whole), 1);
    fmpz_t unit;
    fmpz_init(unit);
    fmpz_one_2exp(unit, part.exponent);
    fmpz_mul_ui(part.low, part.low, 3);
    fmpz_mul_ui(part.high, part.high, 3);
    assert_true(fmpz_cmp(part.low, unit) < 0 && fmpz_cmp(unit, part.high) < 0); /* 1/3 */
    fmpz_clear(unit);
    fmpz_mul_2exp(whole.high, whole.high, 60);
    assert_int_equal(guess_interval(&part, p, &whole), 0);
    fmpz_neg(whole.low, whole.high);
    assert_int_equal(guess_interval(&part, p, &whole), 0);
    dyadic_interval_set_si(&whole, 0, 1);
    whole.exponent = 46;
    assert_int_equal(guess_interval(&part, p, &whole), 0);
    fmpz_poly_clear(p);
    dyadic_interval_clear(&part);
    dyadic_interval_clear(&whole);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_roots), cmocka_unit_test(test_counts_against_sturm),
        cmocka_unit_test(test_near_miss),   cmocka_unit_test(test_ends),
        cmocka_unit_test(test_between),     cmocka_unit_test(test_windows),
        cmocka_unit_test(test_simplest),    cmocka_unit_test(test_guesses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
