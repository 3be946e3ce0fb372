/* Resultants by Chinese remainders, modulo 62-bit primes; a bound of the coefficients gives the
 * number of primes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The bound: a coefficient is at most the greatest absolute value of the resultant on the unit
 * circle, and by Hadamard this is at most A^(deg b) B^(deg a), where A and B are the sums of the
 * absolute values of all coefficients of a and b. Modulo a prime the resultant is interpolated at
 * places where no degree drops. The caller can cancel between two primes.
 */
#include <flint/nmod_poly.h>
#include <flint/ulong_extras.h>
#include "base/context/scope.h"
#include "questions/topo/eliminate.h"

/* A resultant that takes at most this number of products of words is computed without polling. */
enum { FEW_PRODUCTS = 20000 };

static void sliced_allocate(sliced_curve *out, slong degree, slong total) {
    out->degree = degree;
    out->total = total;
    out->coefficient = flint_malloc((size_t)(degree + 1) * sizeof *out->coefficient);
    for (slong k = 0; k <= degree; k++)
        fmpz_poly_init(out->coefficient + k);
}

void sliced_curve_init(sliced_curve *out, const fmpz_mpoly_t g, int variable,
                       const fmpz_mpoly_ctx_t ring) {
    int other = variable == RING_X ? RING_Y : RING_X;
    LOCAL(fmpz, c);
    sliced_allocate(out, fmpz_mpoly_degree_si(g, variable, ring),
                    fmpz_mpoly_total_degree_si(g, ring));
    for (slong k = 0; k < fmpz_mpoly_length(g, ring); k++) {
        ulong e[RING_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, g, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, g, k, ring);
        fmpz_poly_set_coeff_fmpz(out->coefficient + e[variable], (slong)e[other], c);
    }
}

void sliced_init_derivative(sliced_curve *out, const sliced_curve *s) {
    sliced_allocate(out, s->degree - 1, s->total - 1);
    for (slong k = 1; k <= s->degree; k++)
        fmpz_poly_scalar_mul_si(out->coefficient + k - 1, s->coefficient + k, k);
}

/* Make a curve of a polynomial; the curve does not depend on the other variable. */
static void sliced_init_constant(sliced_curve *out, const fmpz_poly_t f) {
    sliced_allocate(out, fmpz_poly_degree(f), fmpz_poly_degree(f));
    for (slong k = 0; k <= out->degree; k++)
        fmpz_poly_set_fmpz(out->coefficient + k, fmpz_poly_get_coeff_ptr(f, k));
}

void sliced_curve_clear(sliced_curve *s) {
    for (slong k = 0; k <= s->degree; k++)
        fmpz_poly_clear(s->coefficient + k);
    flint_free(s->coefficient);
}

int sliced_at(fmpz_poly_t out, const sliced_curve *s, const fmpz_t at) {
    LOCAL(fmpz, value);
    fmpz_poly_zero(out);
    for (slong k = 0; k <= s->degree; k++) {
        fmpz_poly_evaluate_fmpz(value, s->coefficient + k, at);
        fmpz_poly_set_coeff_fmpz(out, k, value);
    }
    return fmpz_poly_degree(out) == s->degree;
}

/* A curve modulo a prime. */
typedef struct reduced_curve {
    slong degree;
    nmod_poly_struct *coefficient, at[1]; /* `at`: its value at a number */
} reduced_curve;

static void reduced_curve_init(reduced_curve *out, const sliced_curve *s, ulong prime) {
    out->degree = s->degree;
    out->coefficient = flint_malloc((size_t)(s->degree + 1) * sizeof *out->coefficient);
    for (slong k = 0; k <= s->degree; k++) {
        nmod_poly_init(out->coefficient + k, prime);
        fmpz_poly_get_nmod_poly(out->coefficient + k, s->coefficient + k);
    }
    nmod_poly_init(out->at, prime);
}

static void reduced_curve_clear(reduced_curve *r) {
    for (slong k = 0; k <= r->degree; k++)
        nmod_poly_clear(r->coefficient + k);
    flint_free(r->coefficient);
    nmod_poly_clear(r->at);
}

/* Evaluate a reduced curve at `at`; returns 0 if the degree drops there. */
static int reduced_at(reduced_curve *r, ulong at) {
    nmod_poly_zero(r->at);
    for (slong k = r->degree; k >= 0; k--)
        nmod_poly_set_coeff_ui(r->at, k, nmod_poly_evaluate_nmod(r->coefficient + k, at));
    return nmod_poly_degree(r->at) == r->degree;
}

/* Find the resultant modulo a prime from n values; returns 0 if a leading coefficient vanishes
 * modulo the prime. */
static int resultant_modulo(nmod_poly_t out, const sliced_curve *a, const sliced_curve *b, slong n,
                            ulong prime) {
    ulong *at = flint_malloc((size_t)(2 * n) * sizeof *at), *value = at + n;
    HELD(reduced_curve, p, a, prime);
    HELD(reduced_curve, q, b, prime);
    int whole = !nmod_poly_is_zero(p.coefficient + p.degree) &&
                !nmod_poly_is_zero(q.coefficient + q.degree);
    slong k = 0;
    for (ulong place = 0; k < n && whole; place++) {
        if (!reduced_at(&p, place) || !reduced_at(&q, place))
            continue;
        at[k] = place;
        value[k++] = nmod_poly_resultant(p.at, q.at);
    }
    if (whole)
        nmod_poly_interpolate_nmod_vec(out, at, value, n);
    flint_free(at);
    return whole;
}

/* The number of bits of the sum of the absolute values of all coefficients. */
static ulong bits_of_sum(const sliced_curve *s) {
    LOCAL(fmpz, sum);
    for (slong k = 0; k <= s->degree; k++)
        for (slong i = 0; i < fmpz_poly_length(s->coefficient + k); i++) {
            const fmpz *c = fmpz_poly_get_coeff_ptr(s->coefficient + k, i);
            (fmpz_sgn(c) < 0 ? fmpz_sub : fmpz_add)(sum, sum, c);
        }
    return fmpz_bits(sum);
}

/* The resultant from n values modulo each prime; n exceeds the resultant's degree. */
static graze_status resultant_by_primes(fmpz_poly_t out, graze_context *context,
                                        const sliced_curve *a, const sliced_curve *b, slong n) {
    ulong bits = (ulong)b->degree * bits_of_sum(a) + (ulong)a->degree * bits_of_sum(b) + 2;
    ulong prime = (ulong)1 << 61;
    ulong steps = (ulong)(a->degree + b->degree + 2); /* each has an inverse, like 50 products */
    ulong work = (ulong)n * (steps * steps + 50 * steps + (ulong)n);
    LOCAL(fmpz, modulus);
    fmpz_set_ui(modulus, 1);
    fmpz_poly_zero(out);
    while (fmpz_bits(modulus) <= bits) {
        nmod_poly_t residue;
        prime = n_nextprime(prime, 0);
        nmod_poly_init(residue, prime);
        if (resultant_modulo(residue, a, b, n, prime)) {
            fmpz_poly_CRT_ui(out, out, modulus, residue, 1);
            fmpz_mul_ui(modulus, modulus, prime);
        }
        nmod_poly_clear(residue);
        TRY(context_work(context, work + (ulong)n * (ulong)fmpz_size(modulus)));
    }
    return GRAZE_OK;
}

graze_status eliminate(fmpz_poly_t out, graze_context *context, const sliced_curve *a,
                       const sliced_curve *b) {
    slong most = a->total * b->degree + b->total * a->degree - a->degree * b->degree;
    return resultant_by_primes(out, context, a, b, most + 1);
}

graze_status resultant_of(fmpz_t out, graze_context *context, const fmpz_poly_t f,
                          const fmpz_poly_t g) {
    ulong n = (ulong)fmpz_poly_length(f), m = (ulong)fmpz_poly_length(g);
    ulong words = (ulong)FLINT_MAX(fmpz_poly_max_limbs(f), fmpz_poly_max_limbs(g)) + 1;
    if (n * m * words * (n + m) * words < FEW_PRODUCTS) {
        fmpz_poly_resultant(out, f, g);
        return GRAZE_OK;
    }
    ZEROED(sliced_curve, a);
    ZEROED(sliced_curve, b);
    LOCAL(fmpz_poly, value);
    sliced_init_constant(&a, f);
    sliced_init_constant(&b, g);
    TRY(resultant_by_primes(value, context, &a, &b, 1));
    fmpz_poly_get_coeff_fmpz(out, value, 0);
    return GRAZE_OK;
}
