/* Coprime polynomials by Euclid's algorithm modulo the Mersenne prime 2^61 - 1, without divisions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/modular.h"

#include <flint/fmpz.h>
#include <stdint.h>

__extension__ typedef unsigned __int128 uint128;

static const uint64_t PRIME = (UINT64_C(1) << 61) - 1;

/* x modulo the prime, for x < 2^124. The first sum is below 2^64. */
static uint64_t reduce(uint128 x) {
    uint64_t sum = ((uint64_t)x & PRIME) + (uint64_t)(x >> 61);
    sum = (sum & PRIME) + (sum >> 61);
    return sum >= PRIME ? sum - PRIME : sum;
}

static slong degree_below(const uint64_t *a, slong degree) {
    while (degree >= 0 && a[degree] == 0)
        degree--;
    return degree;
}

static slong load_residues(uint64_t *out, const fmpz_poly_t p) {
    slong degree = fmpz_poly_degree(p);
    for (slong i = 0; i <= degree; i++)
        out[i] = fmpz_fdiv_ui(p->coeffs + i, PRIME);
    return degree_below(out, degree);
}

/* Replace a by a unit times the remainder of a modulo b, and return the degree of the remainder.
 * Each round multiplies a by b's leading coefficient and takes a multiple of b away. */
static slong remainder_degree(uint64_t *a, slong n, const uint64_t *b, slong m) {
    while (n >= m) {
        uint64_t lead = b[m], minus = PRIME - a[n];
        slong shift = n - m;
        for (slong i = 0; i < shift; i++)
            a[i] = reduce((uint128)lead * a[i]);
        for (slong i = shift; i < n; i++)
            a[i] = reduce((uint128)lead * a[i] + (uint128)minus * b[i - shift]);
        n = degree_below(a, n - 1);
    }
    return n;
}

/* The certificate holds if the prime does not divide both leading coefficients. */
int polynomials_certainly_coprime(const fmpz_poly_t p, const fmpz_poly_t q) {
    uint64_t first[MODULAR_DEGREE + 1], second[MODULAR_DEGREE + 1];
    if (fmpz_poly_degree(p) > MODULAR_DEGREE || fmpz_poly_degree(q) > MODULAR_DEGREE)
        return 0;
    slong n = load_residues(first, p), m = load_residues(second, q);
    if (n != fmpz_poly_degree(p) && m != fmpz_poly_degree(q))
        return 0;
    uint64_t *a = first, *b = second;
    while (m >= 0) {
        slong rest = remainder_degree(a, n, b, m);
        uint64_t *swap = a;
        a = b;
        b = swap;
        n = m;
        m = rest;
    }
    return n == 0;
}

slong common_factor(fmpz_poly_t g, const fmpz_poly_t p, const fmpz_poly_t q) {
    if (polynomials_certainly_coprime(p, q))
        fmpz_poly_one(g);
    else
        fmpz_poly_gcd(g, p, q);
    return fmpz_poly_degree(g);
}

graze_status common_factor_work(graze_context *context, const fmpz_poly_t p, const fmpz_poly_t q) {
    ulong n = (ulong)FLINT_MAX(fmpz_poly_length(p), fmpz_poly_length(q));
    ulong bits =
        (ulong)FLINT_MAX(FLINT_ABS(fmpz_poly_max_bits(p)), FLINT_ABS(fmpz_poly_max_bits(q)));
    return context_work(context, n * n * (bits / FLINT_BITS + 1));
}
