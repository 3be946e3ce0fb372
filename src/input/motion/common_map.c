/* Affine maps over two common denominators, and the point maps of such a map and of its inverse.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/affine.h"

#include "base/context/scope.h"

void common_map_init(common_map *m) {
    for (int k = 0; k < 9; k++)
        fmpz_poly_init(&m->linear[k]);
    for (int k = 0; k < 3; k++)
        fmpz_poly_init(&m->shift[k]);
    fmpz_poly_init(m->w);
    fmpz_poly_init(m->v);
}

void common_map_clear(common_map *m) {
    for (int k = 0; k < 9; k++)
        fmpz_poly_clear(&m->linear[k]);
    for (int k = 0; k < 3; k++)
        fmpz_poly_clear(&m->shift[k]);
    fmpz_poly_clear(m->w);
    fmpz_poly_clear(m->v);
}

fmpz_poly_struct *common_map_linear(common_map *m, int i, int j) {
    return &m->linear[i * m->dimension + j];
}

/* common = lcm(common, the denominator of entry (i, j)) */
static void widen_by_entry(calculation *c, fmpz_poly_t common, const affine *a, int i, int j) {
    if (c->status == GRAZE_OK) {
        polynomial_widen(common, fmpz_poly_q_denref(affine_get(a, i, j)));
        polynomial_check(c, common);
    }
}

static void make_positive(fmpz_poly_t p) {
    if (fmpz_sgn(fmpz_poly_get_coeff_ptr(p, 0)) < 0)
        fmpz_poly_neg(p, p);
}

void common_map_from_affine(calculation *c, common_map *out, const affine *a) {
    int d = out->dimension = a->dimension;
    fmpz_poly_one(out->w);
    fmpz_poly_one(out->v);
    for (int i = 0; i < d; i++) {
        for (int j = 0; j < d; j++)
            widen_by_entry(c, out->w, a, i, j);
        widen_by_entry(c, out->v, a, i, d);
    }
    make_positive(out->w);
    make_positive(out->v);
    for (int i = 0; i < d && c->status == GRAZE_OK; i++) {
        for (int j = 0; j < d; j++)
            quotient_over(&out->linear[i * d + j], affine_get(a, i, j), out->w);
        quotient_over(&out->shift[i], affine_get(a, i, d), out->v);
    }
}

void common_map_to_affine(calculation *c, affine *out, const common_map *m) {
    int d = out->dimension = m->dimension;
    for (int k = 0; k < d * (d + 1) && c->status == GRAZE_OK; k++) {
        int i = k / (d + 1), j = k % (d + 1);
        fmpz_poly_q_struct *entry = affine_at(out, i, j);
        fmpz_poly_set(fmpz_poly_q_numref(entry), j < d ? &m->linear[i * d + j] : &m->shift[i]);
        fmpz_poly_set(fmpz_poly_q_denref(entry), j < d ? m->w : m->v);
        quotient_reduce(entry);
        quotient_check(c, entry);
    }
}

/* sum = column i of N times column j of N, or times the shift where j is d */
static void columns_product(fmpz_poly_t sum, fmpz_poly_t term, const common_map *m, int i, int j) {
    int d = m->dimension;
    fmpz_poly_zero(sum);
    for (int k = 0; k < d; k++) {
        const fmpz_poly_struct *left = &m->linear[k * d + i];
        const fmpz_poly_struct *right = j < d ? &m->linear[k * d + j] : &m->shift[k];
        fmpz_poly_mul(term, left, right);
        fmpz_poly_add(sum, sum, term);
    }
}

int common_map_is_orthogonal(calculation *c, const common_map *m) {
    int d = m->dimension, holds = c->status == GRAZE_OK;
    LOCAL(fmpz_poly, square);
    LOCAL(fmpz_poly, sum);
    LOCAL(fmpz_poly, term);
    if (holds)
        fmpz_poly_sqr(square, m->w);
    for (int i = 0; i < d && holds; i++) {
        for (int j = 0; j <= i && holds; j++) {
            columns_product(sum, term, m, i, j);
            holds = i == j ? fmpz_poly_equal(sum, square) : fmpz_poly_is_zero(sum);
        }
    }
    return holds;
}

/* Set the weight and the linear part of a point map to w, and N or its transpose, times `factor`.
 */
static void scale_linear(calculation *c, point_map *out, const common_map *m, int transposed,
                         const fmpz_poly_t factor) {
    int d = m->dimension;
    fmpz_poly_mul(out->weight, m->w, factor);
    polynomial_check(c, out->weight);
    for (int k = 0; k < d * d && c->status == GRAZE_OK; k++) {
        int i = k / d, j = k % d;
        fmpz_poly_struct *entry = &out->entry[i * (d + 1) + j];
        fmpz_poly_mul(entry, &m->linear[transposed ? j * d + i : k], factor);
        polynomial_check(c, entry);
    }
}

/* The least common multiple of w and v is the least weight (proofs/maps.md C90). */
void common_map_forward(calculation *c, point_map *out, const common_map *m) {
    int d = m->dimension;
    LOCAL(fmpz_poly, weight);
    LOCAL(fmpz_poly, factor);
    fmpz_poly_set(weight, m->w);
    polynomial_widen(weight, m->v);
    make_positive(weight);
    polynomial_divide(factor, weight, m->w);
    scale_linear(c, out, m, 0, factor);
    polynomial_divide(factor, weight, m->v);
    for (int i = 0; i < d && c->status == GRAZE_OK; i++) {
        fmpz_poly_mul(&out->entry[i * (d + 1) + d], &m->shift[i], factor);
        polynomial_check(c, &out->entry[i * (d + 1) + d]);
    }
}

/* The point map is (N^T v, -N^T B) / (w v), reduced by the common factor of v and N^T B
 * (proofs/maps.md C90). */
void common_map_backward(calculation *c, point_map *out, const common_map *m) {
    int d = m->dimension;
    LOCAL(fmpz_poly, common);
    LOCAL(fmpz_poly, term);
    fmpz_poly_set(common, m->v);
    for (int i = 0; i < d; i++) {
        columns_product(&out->entry[i * (d + 1) + d], term, m, i, d);
        polynomial_narrow(common, &out->entry[i * (d + 1) + d]);
    }
    make_positive(common);
    for (int i = 0; i < d; i++) {
        fmpz_poly_struct *shift = &out->entry[i * (d + 1) + d];
        polynomial_divide(shift, shift, common);
        fmpz_poly_neg(shift, shift);
        polynomial_check(c, shift);
    }
    polynomial_divide(term, m->v, common);
    scale_linear(c, out, m, 1, term);
}
