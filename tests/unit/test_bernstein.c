/* Bernstein coefficients put together again to the polynomial they came from, on intervals of all
 * sizes, and values at dyadic and rational points. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include "../lib/random.h"

#include "base/number/bernstein.h"

#include <flint/fmpz_vec.h>

static void random_polynomial(fmpz_poly_t out, slong degree, ulong bits) {
    fmpz_t c;
    fmpz_init(c);
    fmpz_poly_zero(out);
    for (slong k = 0; k <= degree; k++) {
        fmpz_randtest(c, chance, bits);
        fmpz_poly_set_coeff_fmpz(out, k, c);
    }
    fmpz_clear(c);
}

/* Sum of c_k C(n, k) (2^e u - low)^k (high - 2^e u)^(n - k): (width)^n times the polynomial that
 * has these coefficients on the interval. */
static void rebuild(fmpz_poly_t out, const fmpz *c, slong n, const dyadic_interval *interval) {
    fmpz_poly_t from, to, term, power;
    fmpz_t factor;
    fmpz_poly_init(from);
    fmpz_poly_init(to);
    fmpz_poly_init(term);
    fmpz_poly_init(power);
    fmpz_init(factor);
    fmpz_one_2exp(factor, interval->exponent);
    fmpz_poly_set_coeff_fmpz(from, 1, factor);
    fmpz_neg(factor, factor);
    fmpz_poly_set_coeff_fmpz(to, 1, factor);
    fmpz_neg(factor, interval->low);
    fmpz_poly_set_coeff_fmpz(from, 0, factor);
    fmpz_poly_set_coeff_fmpz(to, 0, interval->high);
    fmpz_poly_zero(out);
    for (slong k = 0; k <= n; k++) {
        fmpz_bin_uiui(factor, (ulong)n, (ulong)k);
        fmpz_mul(factor, factor, c + k);
        fmpz_poly_pow(term, from, (ulong)k);
        fmpz_poly_pow(power, to, (ulong)(n - k));
        fmpz_poly_mul(term, term, power);
        fmpz_poly_scalar_addmul_fmpz(out, term, factor);
    }
    fmpz_poly_clear(from);
    fmpz_poly_clear(to);
    fmpz_poly_clear(term);
    fmpz_poly_clear(power);
    fmpz_clear(factor);
}

/* Whether a = m p for a positive integer m; m is put out. */
static int is_positive_multiple(fmpz_t m, const fmpz_poly_t a, const fmpz_poly_t p) {
    fmpz_poly_t multiple;
    fmpz_poly_init(multiple);
    int equal = fmpz_poly_degree(a) == fmpz_poly_degree(p);
    if (equal) {
        fmpz_fdiv_q(m, fmpz_poly_lead(a), fmpz_poly_lead(p));
        fmpz_poly_scalar_mul_fmpz(multiple, p, m);
        equal = fmpz_sgn(m) > 0 && fmpz_poly_equal(multiple, a);
    }
    fmpz_poly_clear(multiple);
    return equal;
}

static void check_form(fmpz_t m, const bernstein_form *form, const fmpz_poly_t p,
                       const dyadic_interval *interval) {
    slong n = form->c.count - 1;
    fmpz_poly_t whole;
    fmpz_poly_init(whole);
    fmpz *c = _fmpz_vec_init(n + 1);
    for (slong k = 0; k <= n; k++) {
        wide_get_fmpz(c + k, &form->c, k);
        assert_true(fmpz_bits(c + k) <= form->bits);
        assert_int_equal(fmpz_sgn(c + k), wide_sign(&form->c, k));
    }
    rebuild(whole, c, n, interval);
    if (!is_positive_multiple(m, whole, p)) {
        fmpz_poly_print_pretty(p, "u");
        flint_printf(" to degree %wd on [", n);
        fmpz_print(interval->low);
        flint_printf(", ");
        fmpz_print(interval->high);
        fail_msg("] / 2^%lu", (unsigned long)interval->exponent);
    }
    _fmpz_vec_clear(c, n + 1);
    fmpz_poly_clear(whole);
}

/* Degrees beyond the table of binomials, intervals whose ends and widths take several limbs. */
static void test_rebuilt(void **unused) {
    (void)unused;
    random_start(41);
    fmpz_poly_t p;
    dyadic_interval whole, left, right;
    fmpz_t m, n;
    fmpz_poly_init(p);
    dyadic_interval_init(&whole);
    dyadic_interval_init(&left);
    dyadic_interval_init(&right);
    fmpz_init(m);
    fmpz_init(n);
    for (int round = 0; round < 1500; round++) {
        slong degree = draw_below(round % 20 ? 10 : 40);
        do
            random_polynomial(p, degree, 1 + (ulong)draw_below(300));
        while (fmpz_poly_is_zero(p));
        slong formal = degree + draw_below(3);
        whole.exponent = (ulong)draw_below(draw_below(2) ? 4 : 400);
        fmpz_randtest(whole.low, chance, 1 + (ulong)draw_below(200));
        fmpz_randtest_not_zero(whole.high, chance, 1 + (ulong)draw_below(200));
        fmpz_abs(whole.high, whole.high);
        fmpz_add(whole.high, whole.low, whole.high);
        bernstein_form form, upper;
        bernstein_form_init(&form, p, formal, &whole);
        check_form(m, &form, p, &whole);
        bernstein_form_split(&form, &upper);
        dyadic_interval_halves(&left, &right, &whole);
        check_form(m, &form, p, &left);
        check_form(n, &upper, p, &right);
        assert_true(fmpz_equal(m, n));
        bernstein_form_clear(&form);
        bernstein_form_clear(&upper);
    }
    fmpz_poly_clear(p);
    dyadic_interval_clear(&whole);
    dyadic_interval_clear(&left);
    dyadic_interval_clear(&right);
    fmpz_clear(m);
    fmpz_clear(n);
}

/* On one point, 3/4: every coefficient of u - 1/2 is positive, and of u - 3/4 it is zero. */
static void test_point(void **unused) {
    (void)unused;
    dyadic_interval point;
    fmpz_poly_t p;
    dyadic_interval_init(&point);
    fmpz_poly_init(p);
    dyadic_interval_set_si(&point, 3, 3);
    point.exponent = 2;
    for (int k = 0; k < 2; k++) {
        bernstein_form form;
        fmpz_poly_set_str(p, k ? "2  -3 4" : "2  -1 2");
        bernstein_form_init(&form, p, 2, &point);
        for (slong i = 0; i <= 2; i++)
            assert_int_equal(wide_sign(&form.c, i), k ? 0 : 1);
        bernstein_form_clear(&form);
    }
    dyadic_interval_clear(&point);
    fmpz_poly_clear(p);
}

/* Against FLINT's values in lowest terms; every other x is dyadic, and often a root. */
static void test_values(void **unused) {
    (void)unused;
    random_start(42);
    fmpz_poly_t p, factor;
    fmpq_t x, value, other;
    fmpz_poly_init(p);
    fmpz_poly_init(factor);
    fmpq_init(x);
    fmpq_init(value);
    fmpq_init(other);
    for (int round = 0; round < 3000; round++) {
        ulong exponent = (ulong)draw_below(100);
        random_polynomial(p, draw_below(8), 1 + (ulong)draw_below(200));
        fmpq_randtest(x, chance, 1 + (ulong)draw_below(100));
        if (round % 2)
            dyadic_value(x, fmpq_numref(x), exponent);
        if (round % 3 == 0) {
            fmpz_poly_zero(factor);
            fmpz_poly_set_coeff_fmpz(factor, 1, fmpq_denref(x));
            fmpz_poly_set_coeff_fmpz(factor, 0, fmpq_numref(x));
            fmpz_neg(factor->coeffs, factor->coeffs);
            fmpz_poly_mul(p, p, factor);
        }
        fmpz_poly_evaluate_fmpq(value, p, x);
        assert_int_equal(rational_sign(p, x), fmpq_sgn(value));
        dyadic_value(other, fmpq_numref(x), exponent);
        fmpz_poly_evaluate_fmpq(value, p, other);
        assert_int_equal(dyadic_sign(p, fmpq_numref(x), exponent), fmpq_sgn(value));
        int order = fmpq_cmp(other, x);
        assert_int_equal(dyadic_compare(fmpq_numref(x), exponent, x), order > 0 ? 1 : -(order < 0));
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(factor);
    fmpq_clear(x);
    fmpq_clear(value);
    fmpq_clear(other);
}

/* Coefficients as large as their number of bits allows: with all p_i = 2^b - 1 on [0, 1] the first
 * one is a multiple of p(0), the last one the same multiple of p(1) = (n + 1) p(0). The widths are
 * cut so close that a bit less would lose the sign (degree 32, b = 16 modulo 64). */
static void test_widths(void **unused) {
    (void)unused;
    fmpz_poly_t p;
    fmpz_t first, last;
    dyadic_interval unit;
    fmpz_poly_init(p);
    fmpz_init(first);
    fmpz_init(last);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    for (slong n = 1; n <= 40; n++)
        for (ulong b = 1; b <= 130; b++) {
            bernstein_form form;
            fmpz_one_2exp(first, b);
            fmpz_sub_ui(first, first, 1);
            for (slong i = 0; i <= n; i++)
                fmpz_poly_set_coeff_fmpz(p, i, first);
            bernstein_form_init(&form, p, n, &unit);
            wide_get_fmpz(first, &form.c, 0);
            wide_get_fmpz(last, &form.c, n);
            assert_int_equal(fmpz_sgn(first), 1);
            fmpz_mul_ui(first, first, (ulong)n + 1);
            assert_true(fmpz_equal(first, last));
            bernstein_form_clear(&form);
        }
    fmpz_poly_clear(p);
    fmpz_clear(first);
    fmpz_clear(last);
    dyadic_interval_clear(&unit);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rebuilt),
        cmocka_unit_test(test_point),
        cmocka_unit_test(test_values),
        cmocka_unit_test(test_widths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
