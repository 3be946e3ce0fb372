/* Resultants and discriminants by values against FLINT's by pseudo-remainders.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "topo/eliminate.h"
#include "fixture.h"
#include "../lib/random.h"

enum { PAIRS = 300, DEGREE = 4 };

/* A polynomial in x and y of total degree at most DEGREE, sparse, not 0. */
static void random_curve(fmpz_mpoly_t out, const curve_list *list) {
    fmpz_mpoly_zero(out, list->ring);
    while (fmpz_mpoly_is_zero(out, list->ring))
        for (ulong i = 0; i <= DEGREE; i++)
            for (ulong j = 0; i + j <= DEGREE; j++) {
                ulong e[RING_VARIABLES] = {[RING_X] = i, [RING_Y] = j};
                if (random_below(2))
                    fmpz_mpoly_set_coeff_si_ui(out, random_about(9), e, list->ring);
            }
}

static void assert_same(const fmpz_poly_t found, const fmpz_mpoly_t expected, int other,
                        const curve_list *list) {
    fmpz_poly_t p;
    fmpz_poly_init(p);
    assert_int_equal(fmpz_mpoly_get_fmpz_poly(p, expected, other, list->ring), 1);
    assert_int_equal(fmpz_poly_equal(found, p), 1);
    fmpz_poly_clear(p);
}

static void one_pair(curve_list *list, int variable, int *resultants, int *discriminants) {
    fmpz_mpoly_t a, b, expected;
    fmpz_poly_t found;
    sliced_curve s, t;
    fmpz_mpoly_init(a, list->ring);
    fmpz_mpoly_init(b, list->ring);
    fmpz_mpoly_init(expected, list->ring);
    fmpz_poly_init(found);
    random_curve(a, list);
    random_curve(b, list);
    sliced_init(&s, a, variable, list);
    sliced_init(&t, b, variable, list);
    if (s.degree > 0) {
        assert_int_equal(eliminate(found, context, &s, NULL), GRAZE_OK);
        assert_int_equal(fmpz_mpoly_discriminant(expected, a, variable, list->ring), 1);
        assert_same(found, expected, 1 - variable, list);
        ++*discriminants;
    }
    if (s.degree > 0 && t.degree > 0) {
        assert_int_equal(eliminate(found, context, &s, &t), GRAZE_OK);
        assert_int_equal(fmpz_mpoly_resultant(expected, a, b, variable, list->ring), 1);
        assert_same(found, expected, 1 - variable, list);
        ++*resultants;
    }
    sliced_clear(&s);
    sliced_clear(&t);
    fmpz_poly_clear(found);
    fmpz_mpoly_clear(expected, list->ring);
    fmpz_mpoly_clear(b, list->ring);
    fmpz_mpoly_clear(a, list->ring);
}

static void by_values_and_remainders(void **state) {
    (void)state;
    int resultants = 0, discriminants = 0;
    curve_list list;
    curves_init(&list);
    random_start(2026);
    for (int k = 0; k < PAIRS; k++)
        one_pair(&list, k % 2, &resultants, &discriminants);
    assert_in_range(resultants, PAIRS / 2, PAIRS);
    assert_in_range(discriminants, PAIRS / 2, PAIRS);
    curves_clear(&list);
}

static int asked;

static int third(void *data) {
    (void)data;
    return ++asked == 3;
}

/* Between two values the caller may cancel. */
static void cancel(void **state) {
    (void)state;
    curve_list list;
    fmpz_mpoly_t a;
    fmpz_poly_t found;
    sliced_curve s;
    curves_init(&list);
    fmpz_mpoly_init(a, list.ring);
    fmpz_poly_init(found);
    static const char *names[] = {"x", "y", "t"};
    assert_int_equal(fmpz_mpoly_set_str_pretty(a, "y^3+x^3-x*y", names, list.ring), 0);
    sliced_init(&s, a, RING_Y, &list);
    graze_context_set_cancel(context, third, NULL);
    assert_int_equal(eliminate(found, context, &s, NULL), GRAZE_ECANCELED);
    assert_int_equal(asked, 3);
    sliced_clear(&s);
    fmpz_poly_clear(found);
    fmpz_mpoly_clear(a, list.ring);
    curves_clear(&list);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(by_values_and_remainders, set_up, tear_down),
        cmocka_unit_test_setup_teardown(cancel, set_up, tear_down)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
