/* Determinants and inverses of affine maps whose entries are rational functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "input/motion/affine.h"

/* out = p q - r s */
static void minor(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t p, const fmpz_poly_q_t q,
                  const fmpz_poly_q_t r, const fmpz_poly_q_t s) {
    LOCAL(fmpz_poly_q, other);
    quotient_mul(c, other, r, s);
    quotient_mul(c, out, p, q);
    quotient_sub(c, out, out, other);
}

/* The cofactor of entry (i, j) of the linear part. Taking rows and columns cyclically gives a 3x3
 * cofactor its sign. */
static void cofactor(calculation *c, fmpz_poly_q_t out, const affine *a, int i, int j) {
    if (a->dimension == 2) {
        fmpz_poly_q_set(out, affine_get(a, 1 - i, 1 - j));
        if (i != j)
            fmpz_poly_q_neg(out, out);
        return;
    }
    int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    minor(c, out, affine_get(a, i1, j1), affine_get(a, i2, j2), affine_get(a, i1, j2),
          affine_get(a, i2, j1));
}

void affine_determinant(calculation *c, fmpz_poly_q_t out, const affine *a) {
    LOCAL(fmpz_poly_q, product);
    fmpz_poly_q_zero(out);
    for (int j = 0; j < a->dimension; j++) {
        cofactor(c, product, a, 0, j);
        quotient_mul(c, product, product, affine_get(a, 0, j));
        quotient_add(c, out, out, product);
    }
}

/* Invert the linear part. If it is orthogonal, as for every rigid motion, its transpose is the
 * inverse. */
static void invert_linear(calculation *c, affine *out, const affine *a, int orthogonal) {
    int d = a->dimension;
    LOCAL(fmpz_poly_q, determinant);
    if (!orthogonal)
        affine_determinant(c, determinant, a);
    for (int k = 0; k < d * d; k++) {
        fmpz_poly_q_struct *entry = affine_at(out, k / d, k % d);
        if (orthogonal) {
            fmpz_poly_q_set(entry, affine_get(a, k % d, k / d));
        } else {
            cofactor(c, entry, a, k % d, k / d);
            quotient_div(c, entry, entry, determinant);
        }
    }
}

/* Set the shift in row i of the inverse: minus row i of the inverse's linear part times the shift
 * of a, over the product of the common denominators of both, reduced once. */
static void shift_back(calculation *c, affine *out, const affine *a, int i) {
    int d = a->dimension;
    fmpz_poly_q_struct *shift = affine_at(out, i, d);
    LOCAL(fmpz_poly, row);
    LOCAL(fmpz_poly, column);
    LOCAL(fmpz_poly, left);
    LOCAL(fmpz_poly, right);
    fmpz_poly_one(row);
    fmpz_poly_one(column);
    for (int j = 0; j < d; j++) {
        polynomial_widen(row, fmpz_poly_q_denref(affine_get(out, i, j)));
        polynomial_widen(column, fmpz_poly_q_denref(affine_get(a, j, d)));
    }
    fmpz_poly_q_zero(shift);
    for (int j = 0; j < d; j++) {
        quotient_over(left, affine_get(out, i, j), row);
        quotient_over(right, affine_get(a, j, d), column);
        fmpz_poly_mul(left, left, right);
        fmpz_poly_sub(fmpz_poly_q_numref(shift), fmpz_poly_q_numref(shift), left);
    }
    fmpz_poly_mul(fmpz_poly_q_denref(shift), row, column);
    quotient_reduce(shift);
    quotient_check(c, shift);
}

void affine_inverse(calculation *c, affine *out, const affine *a, int orthogonal) {
    out->dimension = a->dimension;
    invert_linear(c, out, a, orthogonal);
    for (int i = 0; i < a->dimension && c->status == GRAZE_OK; i++)
        shift_back(c, out, a, i);
}
