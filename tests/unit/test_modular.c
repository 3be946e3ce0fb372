/* Common factors: the certificate against resultants and built-in factors, also where the prime
 * divides leading coefficients or whole polynomials. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpz.h>
#include "../lib/harness.h"
#include "../lib/random.h"
#include "base/number/modular.h"
#include "input/motion/affine.h"

static void random_polynomial(fmpz_poly_t out, slong degree, slong size) {
    fmpz_poly_zero(out);
    for (slong k = 0; k <= degree; k++)
        fmpz_poly_set_coeff_si(out, k, random_about(size));
    if (fmpz_poly_degree(out) < degree)
        fmpz_poly_set_coeff_si(out, degree, size);
}

static void fail_with(const fmpz_poly_t p, const fmpz_poly_t q, const char *what) {
    fmpz_poly_print_pretty(p, "x");
    flint_printf(" and ");
    fmpz_poly_print_pretty(q, "x");
    fail_msg(": %s", what);
}

/* Small polynomials often have a common factor; the resultant is zero just then. A certificate that
 * is almost never given would be as useless as a wrong one is wrong: a prime of 61 bits divides no
 * resultant that is not zero here, as |resultant| <= (sqrt(7) 9)^12 < 2^61. */
static void test_against_resultants(void **unused) {
    (void)unused;
    random_start(31);
    slong coprime = 0, common = 0;
    for (int round = 0; round < 4000; round++) {
        fmpz_poly_t p, q, g, exact;
        fmpz_t resultant;
        fmpz_poly_init(p);
        fmpz_poly_init(q);
        fmpz_poly_init(g);
        fmpz_poly_init(exact);
        fmpz_init(resultant);
        slong size = round % 2 ? 9 : 1;
        random_polynomial(p, draw_below(6) + 1, size);
        random_polynomial(q, draw_below(6) + 1, size);
        fmpz_poly_resultant(resultant, p, q);
        int expected = !fmpz_is_zero(resultant);
        if (polynomials_certainly_coprime(p, q) != expected)
            fail_with(p, q, expected ? "no certificate" : "a wrong certificate");
        slong degree = common_factor(g, p, q);
        fmpz_poly_gcd(exact, p, q);
        if (degree != fmpz_poly_degree(exact) || (degree > 0 && !fmpz_poly_equal(g, exact)))
            fail_with(p, q, "not the greatest common divisor");
        coprime += expected;
        common += !expected;
        fmpz_poly_clear(p);
        fmpz_poly_clear(q);
        fmpz_poly_clear(g);
        fmpz_poly_clear(exact);
        fmpz_clear(resultant);
    }
    assert_true(coprime > 1000 && common > 300);
}

/* A factor of degree one and more whose coefficients the prime divides: all but the constant one,
 * so that it is invisible modulo the prime; the leading one; or all. */
static void test_prime_in_the_factor(void **unused) {
    (void)unused;
    random_start(61);
    for (int round = 0; round < 3000; round++) {
        fmpz_poly_t p, q, g;
        fmpz_t prime;
        fmpz_poly_init(p);
        fmpz_poly_init(q);
        fmpz_poly_init(g);
        fmpz_init_set_ui(prime, (UINT64_C(1) << 61) - 1);
        random_polynomial(g, draw_below(4) + 1, 5);
        slong degree = fmpz_poly_degree(g), from = round % 3 == 0 ? 1 : round % 3 == 1 ? degree : 0;
        for (slong k = from; k <= degree; k++)
            fmpz_mul(g->coeffs + k, g->coeffs + k, prime);
        random_polynomial(p, draw_below(5), 1000);
        random_polynomial(q, draw_below(5), 1000);
        fmpz_poly_mul(p, p, g);
        fmpz_poly_mul(q, q, g);
        if (polynomials_certainly_coprime(p, q))
            fail_with(p, q, "a wrong certificate");
        if (common_factor(g, p, q) < degree)
            fail_with(p, q, "a factor was lost");
        fmpz_poly_clear(p);
        fmpz_poly_clear(q);
        fmpz_poly_clear(g);
        fmpz_clear(prime);
    }
}

/* One leading coefficient that survives is enough: with P the prime, P x + 1 and x are coprime, and
 * so they are modulo P; P x + 1 and P x + 2 are too, but modulo P that says nothing. Two that agree
 * modulo P, x and x + P, are coprime without a certificate. */
static void test_one_leading_coefficient(void **unused) {
    (void)unused;
    fmpz_poly_t a, b, x, shifted;
    fmpz_t prime;
    fmpz_poly_init(a);
    fmpz_poly_init(b);
    fmpz_poly_init(x);
    fmpz_poly_init(shifted);
    fmpz_init_set_ui(prime, (UINT64_C(1) << 61) - 1);
    fmpz_poly_set_coeff_si(a, 0, 1);
    fmpz_poly_set_coeff_fmpz(a, 1, prime);
    fmpz_poly_set_coeff_si(b, 0, 2);
    fmpz_poly_set_coeff_fmpz(b, 1, prime);
    fmpz_poly_set_coeff_si(x, 1, 1);
    fmpz_poly_set_coeff_si(shifted, 1, 1);
    fmpz_poly_set_coeff_fmpz(shifted, 0, prime);
    assert_int_equal(polynomials_certainly_coprime(a, x), 1);
    assert_int_equal(polynomials_certainly_coprime(x, a), 1);
    assert_int_equal(polynomials_certainly_coprime(a, b), 0);
    assert_int_equal(polynomials_certainly_coprime(x, shifted), 0);
    assert_int_equal(common_factor(b, x, shifted), 0);
    fmpz_poly_clear(a);
    fmpz_poly_clear(b);
    fmpz_poly_clear(x);
    fmpz_poly_clear(shifted);
    fmpz_clear(prime);
}

/* x^n - 1 and x - 1 have a common factor, x^n - 2 and x - 1 none, on both sides of the degree up to
 * which the certificate is tried. */
static void test_high_degree(void **unused) {
    (void)unused;
    fmpz_poly_t p, linear, g;
    fmpz_poly_init(p);
    fmpz_poly_init(linear);
    fmpz_poly_init(g);
    fmpz_poly_set_str(linear, "2  -1 1");
    for (slong n = MODULAR_DEGREE - 1; n <= MODULAR_DEGREE + 1; n++) {
        fmpz_poly_zero(p);
        fmpz_poly_set_coeff_si(p, n, 1);
        fmpz_poly_set_coeff_si(p, 0, -1);
        assert_int_equal(polynomials_certainly_coprime(p, linear), 0);
        assert_int_equal(common_factor(g, p, linear), 1);
        fmpz_poly_set_coeff_si(p, 0, -2);
        assert_int_equal(polynomials_certainly_coprime(p, linear), n <= MODULAR_DEGREE);
        assert_int_equal(polynomials_certainly_coprime(linear, p), n <= MODULAR_DEGREE);
        assert_int_equal(common_factor(g, linear, p), 0);
    }
    fmpz_poly_clear(p);
    fmpz_poly_clear(linear);
    fmpz_poly_clear(g);
}

/* Lowest terms by quotient_reduce against FLINT's, with common factors, contents and signs of all
 * kinds; and the numerator over a multiple of the denominator against the quotient's own value. */
static void test_lowest_terms(void **unused) {
    (void)unused;
    fmpz_poly_t common, factor;
    fmpz_poly_q_t given, expected;
    fmpz_poly_init(common);
    fmpz_poly_init(factor);
    fmpz_poly_q_init(given);
    fmpz_poly_q_init(expected);
    random_start(5);
    for (int k = 0; k < 20000; k++) {
        fmpz_poly_struct *top = fmpz_poly_q_numref(given), *bottom = fmpz_poly_q_denref(given);
        random_polynomial(top, draw_below(5) - 1, 30);
        random_polynomial(bottom, draw_below(4), 30);
        random_polynomial(factor, draw_below(3), 6);
        if (draw_below(2)) {
            fmpz_poly_mul(top, top, factor);
            fmpz_poly_mul(bottom, bottom, factor);
        }
        fmpz_poly_scalar_mul_si(bottom, bottom, draw_below(2) ? 12 : -1);
        fmpz_poly_set(fmpz_poly_q_numref(expected), top);
        fmpz_poly_set(fmpz_poly_q_denref(expected), bottom);
        fmpz_poly_q_canonicalise(expected);
        quotient_reduce(given);
        if (!fmpz_poly_equal(top, fmpz_poly_q_numref(expected)) ||
            !fmpz_poly_equal(bottom, fmpz_poly_q_denref(expected)))
            fail_with(top, bottom, "not in lowest terms");
        random_polynomial(common, draw_below(2) * draw_below(3), 9);
        fmpz_poly_mul(common, common, bottom);
        quotient_over(factor, given, common);
        fmpz_poly_mul(factor, factor, bottom);
        fmpz_poly_mul(common, common, top);
        if (!fmpz_poly_equal(factor, common))
            fail_with(factor, common, "a numerator over a multiple of its denominator");
    }
    fmpz_poly_q_clear(expected);
    fmpz_poly_q_clear(given);
    fmpz_poly_clear(factor);
    fmpz_poly_clear(common);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_resultants),
        cmocka_unit_test(test_prime_in_the_factor),
        cmocka_unit_test(test_one_leading_coefficient),
        cmocka_unit_test(test_high_degree),
        cmocka_unit_test(test_lowest_terms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
