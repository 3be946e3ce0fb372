/* How near to 0 a polynomial has no other root (questions/topo/eliminate.h): of random ones,
 * and of ones whose roots are known, the constant that is left exceeds all other terms at the place
 * found. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "../lib/harness.h"
#include "questions/topo/eliminate.h"

enum { ROUNDS = 2000 };

/* |c_z| > sum over k > z of |c_k| r^(k - z), z the lowest term, r = 2^-places. */
static int constant_exceeds(const fmpz_poly_t p, ulong places) {
    slong z = 0;
    fmpq_t sum, term;
    fmpz_t low;
    fmpq_init(sum);
    fmpq_init(term);
    fmpz_init(low);
    while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, z)))
        z++;
    for (slong k = z + 1; k < fmpz_poly_length(p); k++) {
        fmpq_set_fmpz(term, fmpz_poly_get_coeff_ptr(p, k));
        fmpq_abs(term, term);
        fmpq_div_2exp(term, term, places * (ulong)(k - z));
        fmpq_add(sum, sum, term);
    }
    fmpz_abs(low, fmpz_poly_get_coeff_ptr(p, z));
    int exceeds = fmpq_cmp_fmpz(sum, low) < 0;
    fmpq_clear(sum);
    fmpq_clear(term);
    fmpz_clear(low);
    return exceeds;
}

static void random_polynomials(void **state) {
    (void)state;
    flint_rand_t random;
    fmpz_poly_t p;
    flint_randinit(random);
    fmpz_poly_init(p);
    for (int round = 0; round < ROUNDS; round++) {
        ulong places = 0;
        fmpz_poly_randtest_not_zero(p, random, 1 + round % 9, 1 + (ulong)round % 70);
        fmpz_poly_shift_left(p, p, round % 4);
        places_below_roots(&places, p);
        assert_true(constant_exceeds(p, places));
    }
    fmpz_poly_clear(p);
    flint_randclear(random);
}

/* 2^60 x - 1 has the root 2^-60; x^3 alone, and a constant alone, have none: nothing is raised. A
 * number that is large enough stays. */
static void known_roots(void **state) {
    (void)state;
    ulong places = 0;
    fmpz_poly_t p;
    fmpz_poly_init(p);
    fmpz_poly_set_coeff_si(p, 0, -1);
    fmpz_poly_set_coeff_si(p, 1, 1L << 60);
    places_below_roots(&places, p);
    assert_true(places > 60 && places < 66);
    places = 1000;
    places_below_roots(&places, p);
    assert_int_equal(places, 1000);
    places = 0;
    fmpz_poly_zero(p);
    fmpz_poly_set_coeff_si(p, 3, 7);
    places_below_roots(&places, p);
    assert_int_equal(places, 0);
    fmpz_poly_clear(p);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_polynomials),
                                       cmocka_unit_test(known_roots)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
