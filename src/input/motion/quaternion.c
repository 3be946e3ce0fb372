/* The rotation of a quaternion whose numbers are polynomials.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/affine.h"

#include "base/context/scope.h"

/* Divide the four polynomials by their common factor, at whose roots all four vanish; refuse such a
 * root between lo and hi. */
static graze_status divide_numbers(graze_context *context, const json *where, fmpz_poly_struct q[4],
                                   const fmpq_t lo, const fmpq_t hi) {
    LOCAL(fmpz_poly, common);
    for (int k = 0; k < 4; k++)
        polynomial_narrow(common, &q[k]);
    TRY(entry_no_root(context, where, common, lo, hi,
                      "the quaternion (complex number) of the rotation is zero"));
    for (int k = 0; k < 4; k++)
        polynomial_divide(&q[k], &q[k], common);
    return GRAZE_OK;
}

/* Set the denominator w to the norm, and each diagonal entry of N to the norm less twice two of the
 * squares. */
static void set_diagonal(common_map *out, fmpz_poly_struct q[4]) {
    fmpz_poly_struct square[4];
    fmpz_poly_zero(out->w);
    for (int k = 0; k < 4; k++) {
        fmpz_poly_init(&square[k]);
        fmpz_poly_sqr(&square[k], &q[k]);
        fmpz_poly_add(out->w, out->w, &square[k]);
    }
    for (int i = 0; i < out->dimension; i++) {
        fmpz_poly_struct *entry = common_map_linear(out, i, i);
        fmpz_poly_add(entry, &square[1 + (i + 1) % 3], &square[1 + (i + 2) % 3]);
        fmpz_poly_scalar_mul_2exp(entry, entry, 1);
        fmpz_poly_sub(entry, out->w, entry);
    }
    for (int k = 0; k < 4; k++)
        fmpz_poly_clear(&square[k]);
}

/* Set the entries of N at (i, j) and (j, i), j = i + 1 modulo 3, to 2 (q_i q_j - w q_k) and 2 (q_i
 * q_j + w q_k). */
static void set_pair(common_map *out, const fmpz_poly_struct q[4], int i) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    fmpz_poly_struct *minus = common_map_linear(out, i, j), *plus = common_map_linear(out, j, i);
    LOCAL(fmpz_poly, product);
    fmpz_poly_mul(product, &q[0], &q[1 + k]);
    fmpz_poly_mul(minus, &q[1 + i], &q[1 + j]);
    fmpz_poly_add(plus, minus, product);
    fmpz_poly_sub(minus, minus, product);
    fmpz_poly_scalar_mul_2exp(plus, plus, 1);
    fmpz_poly_scalar_mul_2exp(minus, minus, 1);
}

/* How often, at most `most`, is p divisible by 2? */
static ulong halvings(const fmpz_poly_t p, ulong most) {
    for (slong k = 0; k < fmpz_poly_length(p) && most > 0; k++) {
        const fmpz *coefficient = p->coeffs + k;
        ulong own = fmpz_is_zero(coefficient) ? most : fmpz_val2(coefficient);
        most = FLINT_MIN(most, own);
    }
    return most;
}

/* Divide N and w by their common factor, which is 1, 2 or 4, since the numbers of the quaternion
 * have no common factor (proofs/maps.md C91). */
static void divide_fours(common_map *out) {
    ulong twos = halvings(out->w, 2);
    int entries = out->dimension * out->dimension;
    for (int k = 0; k < entries; k++)
        twos = halvings(&out->linear[k], twos);
    if (twos == 0)
        return;
    fmpz_poly_scalar_tdiv_2exp(out->w, out->w, twos);
    for (int k = 0; k < entries; k++)
        fmpz_poly_scalar_tdiv_2exp(&out->linear[k], &out->linear[k], twos);
}

graze_status quaternion_rotation(common_map *out, graze_context *context, const json *where,
                                 fmpz_poly_struct q[4], const fmpq_t lo, const fmpq_t hi) {
    calculation c = {context, GRAZE_OK};
    c.status = divide_numbers(context, where, q, lo, hi);
    if (c.status != GRAZE_OK)
        return c.status;
    set_diagonal(out, q);
    for (int i = 0; i < (out->dimension == 3 ? 3 : 1); i++)
        set_pair(out, q, i);
    divide_fours(out);
    polynomial_check(&c, out->w);
    for (int k = 0; k < out->dimension * out->dimension; k++)
        polynomial_check(&c, &out->linear[k]);
    return c.status;
}
