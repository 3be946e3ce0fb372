/* Affine maps of E^d whose entries are rational functions of one parameter u.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "input/motion/affine.h"

void affine_init(affine *a, int dimension) {
    a->dimension = dimension;
    for (int k = 0; k < AFFINE_ENTRIES; k++)
        fmpz_poly_q_init(a->entry[k]);
    affine_identity(a);
}

void affine_clear(affine *a) {
    for (int k = 0; k < AFFINE_ENTRIES; k++)
        fmpz_poly_q_clear(a->entry[k]);
}

fmpz_poly_q_struct *affine_at(affine *a, int i, int j) {
    return a->entry[i * (a->dimension + 1) + j];
}

const fmpz_poly_q_struct *affine_get(const affine *a, int i, int j) {
    return a->entry[i * (a->dimension + 1) + j];
}

void affine_identity(affine *a) {
    for (int i = 0; i < a->dimension; i++)
        for (int j = 0; j <= a->dimension; j++)
            fmpz_poly_q_set_si(affine_at(a, i, j), i == j);
}

void affine_set(affine *a, const affine *b) {
    a->dimension = b->dimension;
    for (int k = 0; k < AFFINE_ENTRIES; k++)
        fmpz_poly_q_set(a->entry[k], b->entry[k]);
}

int affine_equal(const affine *a, const affine *b) {
    for (int k = 0; k < a->dimension * (a->dimension + 1); k++)
        if (!fmpz_poly_q_equal(a->entry[k], b->entry[k]))
            return 0;
    return a->dimension == b->dimension;
}

static int is_polynomial(const affine *a) {
    for (int k = 0; k < a->dimension * (a->dimension + 1); k++)
        if (fmpz_poly_degree(fmpz_poly_q_denref(a->entry[k])) > 0)
            return 0;
    return 1;
}

static const fmpz *constant_denominator(const fmpz_poly_q_struct *entry) {
    return fmpz_poly_get_coeff_ptr(fmpz_poly_q_denref(entry), 0);
}

/* Set `out` to row i of a times column j of b, over the product of the common denominators of row
 * and column, reduced once. */
static void multiply_line(calculation *c, fmpz_poly_q_struct *out, const affine *a, int i,
                          const fmpz_t row, const affine *b, int j, const fmpz_t column) {
    int d = a->dimension;
    LOCAL_VEC(fmpz, factor, 2);
    fmpz *other = factor + 1;
    LOCAL(fmpz_poly, term);
    fmpz_poly_struct *sum = fmpz_poly_q_numref(out);
    fmpz_poly_zero(sum);
    for (int k = 0; k < d + (j == d); k++) {
        const fmpz_poly_q_struct *left = affine_get(a, i, k);
        fmpz_divexact(factor, row, constant_denominator(left));
        if (k < d) {
            fmpz_divexact(other, column, constant_denominator(affine_get(b, k, j)));
            fmpz_poly_mul(term, fmpz_poly_q_numref(left), fmpz_poly_q_numref(affine_get(b, k, j)));
            fmpz_mul(factor, factor, other);
        } else {
            fmpz_poly_set(term, fmpz_poly_q_numref(left));
            fmpz_mul(factor, factor, column);
        }
        fmpz_poly_scalar_mul_fmpz(term, term, factor);
        fmpz_poly_add(sum, sum, term);
    }
    fmpz_mul(factor, row, column);
    fmpz_poly_set_fmpz(fmpz_poly_q_denref(out), factor);
    quotient_reduce(out);
    quotient_check(c, out);
}

/* If every denominator is a constant, most greatest common divisors need not be computed. */
static void multiply_polynomials(calculation *c, affine *out, const affine *a, const affine *b) {
    int d = a->dimension;
    fmpz_t column[4];
    LOCAL(fmpz, row);
    for (int j = 0; j <= d; j++) {
        fmpz_init_set_ui(column[j], 1);
        for (int k = 0; k < d; k++)
            fmpz_lcm(column[j], column[j], constant_denominator(affine_get(b, k, j)));
    }
    for (int i = 0; i < d; i++) {
        fmpz_one(row);
        for (int k = 0; k <= d; k++)
            fmpz_lcm(row, row, constant_denominator(affine_get(a, i, k)));
        for (int j = 0; j <= d && c->status == GRAZE_OK; j++)
            multiply_line(c, affine_at(out, i, j), a, i, row, b, j, column[j]);
    }
    for (int j = 0; j <= d; j++)
        fmpz_clear(column[j]);
}

static void multiply_quotients(calculation *c, affine *out, const affine *a, const affine *b) {
    int d = a->dimension;
    LOCAL(fmpz_poly_q, product);
    for (int i = 0; i < d; i++) {
        for (int j = 0; j <= d; j++) {
            fmpz_poly_q_struct *sum = affine_at(out, i, j);
            fmpz_poly_q_zero(sum);
            for (int k = 0; k < d; k++) {
                quotient_mul(c, product, affine_get(a, i, k), affine_get(b, k, j));
                quotient_add(c, sum, sum, product);
            }
            if (j == d)
                quotient_add(c, sum, sum, affine_get(a, i, d));
        }
    }
}

void affine_multiply(calculation *c, affine *out, const affine *a, const affine *b) {
    HELD(affine, result, a->dimension);
    (is_polynomial(a) && is_polynomial(b) ? multiply_polynomials : multiply_quotients)(c, &result,
                                                                                       a, b);
    affine_set(out, &result);
}

void affine_about(calculation *c, affine *a, fmpz_poly_q_t *center) {
    int d = a->dimension;
    LOCAL(fmpz_poly_q, product);
    for (int i = 0; i < d; i++) {
        fmpz_poly_q_struct *shift = affine_at(a, i, d);
        quotient_add(c, shift, shift, center[i]);
        for (int j = 0; j < d; j++) {
            quotient_mul(c, product, affine_get(a, i, j), center[j]);
            quotient_sub(c, shift, shift, product);
        }
    }
}

void affine_substitute(calculation *c, affine *out, const affine *a, const fmpq_t low,
                       const fmpq_t high) {
    LOCAL(fmpz_poly_q, line);
    quotient_set_line(line, low, high);
    out->dimension = a->dimension;
    for (int k = 0; k < a->dimension * (a->dimension + 1); k++)
        quotient_substitute(c, out->entry[k], a->entry[k], line);
}

void affine_at_time(affine *out, const affine *a, const fmpq_t u) {
    LOCAL(fmpq, value);
    out->dimension = a->dimension;
    for (int k = 0; k < a->dimension * (a->dimension + 1); k++) {
        quotient_at(value, a->entry[k], u);
        quotient_set_rational(out->entry[k], value);
    }
}

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
