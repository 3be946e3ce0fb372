/* Resultants, discriminants, shifts and parts of plane curves against FLINT's by pseudo-remainders,
 * compositions and factors.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_mpoly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <time.h>
#include "../lib/random.h"
#include "questions/topo/cover.h"
#include "questions/topo/eliminate.h"
#include "fixture.h"

enum { PAIRS = 300, DEGREE = 4 };

static fmpz_mpoly_ctx_t ring; /* of x and y */

/* `bits` random bits with a sign, or 0. */
static void random_number(fmpz_t out, ulong bits) {
    fmpz_zero(out);
    for (ulong k = 0; k < bits; k += 8) {
        fmpz_mul_2exp(out, out, 8);
        fmpz_add_ui(out, out, draw_below(256));
    }
    if (draw_below(2))
        fmpz_neg(out, out);
}

/* A polynomial in x and y of total degree at most `degree`, sparse, not 0. */
static void random_curve(fmpz_mpoly_t out, ulong degree, ulong bits) {
    fmpz_t c;
    fmpz_init(c);
    fmpz_mpoly_zero(out, ring);
    while (fmpz_mpoly_is_zero(out, ring))
        for (ulong i = 0; i <= degree; i++)
            for (ulong j = 0; i + j <= degree; j++) {
                ulong e[RING_VARIABLES] = {[RING_X] = i, [RING_Y] = j};
                random_number(c, bits);
                if (draw_below(2))
                    fmpz_mpoly_set_coeff_fmpz_ui(out, c, e, ring);
            }
    fmpz_clear(c);
}

static void assert_same(const fmpz_poly_t found, const fmpz_mpoly_t expected, int other) {
    fmpz_poly_t p;
    fmpz_poly_init(p);
    assert_int_equal(fmpz_mpoly_get_fmpz_poly(p, expected, other, ring), 1);
    assert_int_equal(fmpz_poly_equal(found, p), 1);
    fmpz_poly_clear(p);
}

/* With another curve, and with its own derivative. */
static void one_pair(int variable, ulong bits, int *resultants, int *turns) {
    fmpz_mpoly_t a, b, expected;
    fmpz_poly_t found;
    sliced_curve s, t, u;
    fmpz_mpoly_init(a, ring);
    fmpz_mpoly_init(b, ring);
    fmpz_mpoly_init(expected, ring);
    fmpz_poly_init(found);
    random_curve(a, DEGREE, bits);
    random_curve(b, DEGREE, bits);
    sliced_curve_init(&s, a, variable, ring);
    sliced_curve_init(&t, b, variable, ring);
    if (s.degree > 0 && t.degree > 0) {
        assert_int_equal(eliminate(found, context, &s, &t), GRAZE_OK);
        assert_int_equal(fmpz_mpoly_resultant(expected, a, b, variable, ring), 1);
        assert_same(found, expected, 1 - variable);
        ++*resultants;
    }
    if (s.degree > 1) {
        sliced_init_derivative(&u, &s);
        assert_int_equal(eliminate(found, context, &s, &u), GRAZE_OK);
        fmpz_mpoly_derivative(b, a, variable, ring);
        assert_int_equal(fmpz_mpoly_resultant(expected, a, b, variable, ring), 1);
        assert_same(found, expected, 1 - variable);
        sliced_curve_clear(&u);
        ++*turns;
    }
    sliced_curve_clear(&s);
    sliced_curve_clear(&t);
    fmpz_poly_clear(found);
    fmpz_mpoly_clear(expected, ring);
    fmpz_mpoly_clear(b, ring);
    fmpz_mpoly_clear(a, ring);
}

static void by_primes_and_remainders(void **state) {
    (void)state;
    int resultants = 0, turns = 0;
    random_start(2026);
    for (int k = 0; k < PAIRS; k++)
        one_pair(k % 2, k % 3 ? 8 : 120, &resultants, &turns);
    assert_in_range(resultants, PAIRS / 2, PAIRS);
    assert_in_range(turns, PAIRS / 2, PAIRS);
}

/* Elimination by primes is right for large numbers too. */
static void numbers(void **state) {
    (void)state;
    fmpz_poly_t f, g;
    fmpz_t found, expected, c;
    fmpz_poly_init(f);
    fmpz_poly_init(g);
    fmpz_init(found);
    fmpz_init(expected);
    fmpz_init(c);
    random_start(7);
    for (slong n = 1; n <= 12; n++)
        for (ulong bits = 8; bits <= 8000; bits *= 10) {
            for (slong k = 0; k <= n; k++) {
                random_number(c, bits);
                fmpz_poly_set_coeff_fmpz(f, k, c);
                random_number(c, bits);
                fmpz_poly_set_coeff_fmpz(g, n - k, c);
            }
            assert_int_equal(resultant_of(found, context, f, g), GRAZE_OK);
            fmpz_poly_resultant_euclidean(expected, f, g);
            assert_int_equal(fmpz_equal(found, expected), 1);
        }
    fmpz_poly_clear(f);
    fmpz_poly_clear(g);
    fmpz_clear(found);
    fmpz_clear(expected);
    fmpz_clear(c);
}

/* A function of degree n in time, linear in x and y; its leading coefficient vanishes at some of
 * the places that are looked at. */
static void random_pullback(pullback_form *f, slong n) {
    pullback_form_init(f);
    f->degree = n;
    for (int i = 0; i < 3; i++)
        for (slong k = 0; k <= n; k++)
            fmpz_poly_set_coeff_si(&f->linear[i], k, k == n && i == 2 ? 0 : random_about(4));
    fmpz_poly_set_coeff_si(&f->linear[0], n, 1);
}

/* The function as a polynomial of a ring that has time as its third variable. */
static void with_time(fmpz_mpoly_t out, const pullback_form *f, const fmpz_mpoly_ctx_t whole) {
    fmpz_mpoly_zero(out, whole);
    for (ulong i = 0; i < 3; i++)
        for (slong k = 0; k < fmpz_poly_length(&f->linear[i]); k++) {
            ulong e[3] = {i == 0, i == 1, (ulong)k};
            fmpz_mpoly_set_coeff_fmpz_ui(out, fmpz_poly_get_coeff_ptr(&f->linear[i], k), e, whole);
        }
}

static void assert_same_curve(const fmpz_mpoly_t found, const fmpz_mpoly_t expected,
                              const fmpz_mpoly_ctx_t whole) {
    fmpz_t c, d;
    fmpz_init(c);
    fmpz_init(d);
    assert_int_equal(fmpz_mpoly_length(found, ring), fmpz_mpoly_length(expected, whole));
    for (slong k = 0; k < fmpz_mpoly_length(expected, whole); k++) {
        ulong e[3];
        fmpz_mpoly_get_term_exp_ui(e, expected, k, whole);
        assert_int_equal(e[2], 0);
        fmpz_mpoly_get_term_coeff_fmpz(c, expected, k, whole);
        fmpz_mpoly_get_coeff_fmpz_ui(d, found, e, ring);
        assert_int_equal(fmpz_equal(c, d), 1);
    }
    fmpz_clear(c);
    fmpz_clear(d);
}

static void in_time(void **state) {
    (void)state;
    fmpz_mpoly_ctx_t whole;
    fmpz_mpoly_t found, expected, p, q;
    fmpz_mpoly_ctx_init(whole, 3, ORD_LEX);
    fmpz_mpoly_init(found, ring);
    fmpz_mpoly_init(expected, whole);
    fmpz_mpoly_init(p, whole);
    fmpz_mpoly_init(q, whole);
    random_start(12);
    for (slong n = 1; n <= 4; n++)
        for (slong m = 1; m <= 4; m++) {
            pullback_form f, g;
            random_pullback(&f, n);
            random_pullback(&g, m);
            with_time(p, &f, whole);
            with_time(q, &g, whole);
            assert_int_equal(grid_resultant(found, context, &f, &g, ring), GRAZE_OK);
            assert_int_equal(fmpz_mpoly_resultant(expected, p, q, 2, whole), 1);
            assert_same_curve(found, expected, whole);
            if (n > 1) {
                assert_int_equal(grid_discriminant(found, context, &f, ring), GRAZE_OK);
                assert_int_equal(fmpz_mpoly_discriminant(expected, p, 2, whole), 1);
                assert_same_curve(found, expected, whole);
            }
            pullback_form_clear(&f);
            pullback_form_clear(&g);
        }
    fmpz_mpoly_clear(found, ring);
    fmpz_mpoly_clear(expected, whole);
    fmpz_mpoly_clear(p, whole);
    fmpz_mpoly_clear(q, whole);
    fmpz_mpoly_ctx_clear(whole);
}

/* About a point: what FLINT composes, up to a constant. */
static void shifts(void **state) {
    (void)state;
    fmpq_mpoly_ctx_t rationals;
    fmpq_mpoly_t from, to, image[2];
    fmpq_mpoly_struct *images[2] = {image[0], image[1]};
    fmpz_mpoly_t g, found, opposite;
    fmpq point[2] = {{-7, 12}, {5, 18}};
    fmpq_mpoly_ctx_init(rationals, 2, ORD_LEX);
    fmpq_mpoly_init(from, rationals);
    fmpq_mpoly_init(to, rationals);
    fmpz_mpoly_init(g, ring);
    fmpz_mpoly_init(found, ring);
    fmpz_mpoly_init(opposite, ring);
    for (int v = 0; v < 2; v++) {
        fmpq_mpoly_init(image[v], rationals);
        fmpq_mpoly_gen(image[v], v, rationals);
        fmpq_mpoly_add_fmpq(image[v], image[v], point + v, rationals);
    }
    random_start(5);
    for (int k = 0; k < 50; k++) {
        random_curve(g, DEGREE, 40);
        assert_int_equal(shift_curve(found, context, g, point, ring), GRAZE_OK);
        fmpq_one(from->content);
        fmpz_mpoly_set(from->zpoly, g, ring);
        fmpq_mpoly_reduce(from, rationals);
        assert_int_equal(fmpq_mpoly_compose_fmpq_mpoly(to, from, images, rationals, rationals), 1);
        fmpz_mpoly_neg(opposite, found, ring);
        assert_true(fmpz_mpoly_equal(to->zpoly, found, ring) ||
                    fmpz_mpoly_equal(to->zpoly, opposite, ring));
    }
    for (int v = 0; v < 2; v++)
        fmpq_mpoly_clear(image[v], rationals);
    fmpq_mpoly_clear(from, rationals);
    fmpq_mpoly_clear(to, rationals);
    fmpz_mpoly_clear(g, ring);
    fmpz_mpoly_clear(found, ring);
    fmpz_mpoly_clear(opposite, ring);
    fmpq_mpoly_ctx_clear(rationals);
}

/* The product of the irreducible factors of a curve, or of the parts, each once. */
static void radical_of(fmpz_mpoly_t out, const fmpz_mpoly_t curve, const curve_list *parts) {
    fmpz_mpoly_factor_t factors;
    fmpz_mpoly_factor_init(factors, ring);
    fmpz_mpoly_one(out, ring);
    if (!parts)
        assert_int_equal(fmpz_mpoly_factor(factors, curve, ring), 1);
    for (slong k = 0; k < fmpz_mpoly_factor_length(factors, ring); k++)
        fmpz_mpoly_mul(out, out, factors->poly + k, ring);
    for (size_t k = 0; parts && k < parts->count; k++)
        fmpz_mpoly_mul(out, out, &parts->item[k], ring);
    fmpz_mpoly_factor_clear(factors, ring);
}

/* Curves a^2 b, b c and a c with numbers too large to be factored: their parts are squarefree and
 * coprime if their product is the product of all factors. */
static void parts(void **state) {
    (void)state;
    fmpz_mpoly_t f[3], g, all, found, expected;
    fmpz_mpoly_init(g, ring);
    fmpz_mpoly_init(all, ring);
    fmpz_mpoly_init(found, ring);
    fmpz_mpoly_init(expected, ring);
    for (int k = 0; k < 3; k++)
        fmpz_mpoly_init(f[k], ring);
    random_start(99);
    for (ulong bits = 8; bits <= 4000; bits *= 22)
        for (int round = 0; round < 10; round++) {
            curve_list list;
            int refused = 0;
            curve_list_init(&list);
            fmpz_mpoly_one(all, ring);
            for (int k = 0; k < 3; k++)
                random_curve(f[k], 2, bits);
            for (int k = 0; k < 3; k++) {
                fmpz_mpoly_mul(g, f[k], f[(k + 1) % 3], ring);
                if (k == 0)
                    fmpz_mpoly_mul(g, g, f[0], ring);
                fmpz_mpoly_mul(all, all, g, ring);
                assert_int_equal(coprime_add(&list, &refused, context, g), GRAZE_OK);
            }
            assert_int_equal(refused, 0);
            radical_of(found, NULL, &list);
            radical_of(expected, all, NULL);
            assert_int_equal(fmpz_mpoly_total_degree_si(found, ring),
                             fmpz_mpoly_total_degree_si(expected, ring));
            fmpz_mpoly_gcd(g, found, expected, ring);
            assert_int_equal(fmpz_mpoly_total_degree_si(g, ring),
                             fmpz_mpoly_total_degree_si(expected, ring));
            curve_list_clear(&list);
        }
    for (int k = 0; k < 3; k++)
        fmpz_mpoly_clear(f[k], ring);
    fmpz_mpoly_clear(g, ring);
    fmpz_mpoly_clear(all, ring);
    fmpz_mpoly_clear(found, ring);
    fmpz_mpoly_clear(expected, ring);
}

/* A common factor of more digits than the limit `bits` is not looked for. */
static void refusal(void **state) {
    (void)state;
    curve_list list;
    int refused = 0;
    fmpz_mpoly_t g;
    fmpz_mpoly_init(g, ring);
    curve_list_init(&list);
    random_start(3);
    random_curve(g, 4, 20000);
    fmpz_mpoly_mul(g, g, g, ring);
    assert_int_equal(coprime_add(&list, &refused, context, g), GRAZE_OK);
    assert_int_equal(refused, 1);
    refused = 0;
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_BITS, 1000000), GRAZE_OK);
    assert_int_equal(coprime_add(&list, &refused, context, g), GRAZE_OK);
    assert_int_equal(refused, 0);
    assert_int_equal(list.count, 1);
    curve_list_clear(&list);
    fmpz_mpoly_clear(g, ring);
}

static int asked;

static int third(void *data) {
    (void)data;
    return ++asked == 3;
}

/* Between two primes the caller may cancel; all of them would take minutes. */
static void cancel(void **state) {
    (void)state;
    fmpz_mpoly_t a;
    fmpz_poly_t found;
    sliced_curve s, t;
    fmpz_mpoly_init(a, ring);
    fmpz_poly_init(found);
    random_start(1);
    random_curve(a, 30, 4000);
    sliced_curve_init(&s, a, RING_Y, ring);
    sliced_init_derivative(&t, &s);
    graze_context_set_cancel(context, third, NULL);
    clock_t begun = clock();
    assert_int_equal(eliminate(found, context, &s, &t), GRAZE_ECANCELED);
    assert_int_equal(asked, 3);
    assert_true(clock() - begun < 20 * CLOCKS_PER_SEC);
    sliced_curve_clear(&s);
    sliced_curve_clear(&t);
    fmpz_poly_clear(found);
    fmpz_mpoly_clear(a, ring);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(by_primes_and_remainders, set_up, tear_down),
        cmocka_unit_test_setup_teardown(numbers, set_up, tear_down),
        cmocka_unit_test_setup_teardown(in_time, set_up, tear_down),
        cmocka_unit_test_setup_teardown(shifts, set_up, tear_down),
        cmocka_unit_test_setup_teardown(parts, set_up, tear_down),
        cmocka_unit_test_setup_teardown(refusal, set_up, tear_down),
        cmocka_unit_test_setup_teardown(cancel, set_up, tear_down)};
    fmpz_mpoly_ctx_init(ring, RING_VARIABLES, ORD_LEX);
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    fmpz_mpoly_ctx_clear(ring);
    return failed;
}
