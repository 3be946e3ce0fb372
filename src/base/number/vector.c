/* Vectors of rationals.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/vector.h"

#include "base/context/scope.h"

void vector_add(fmpq *out, const fmpq *a, const fmpq *b, int dimension) {
    for (int k = 0; k < dimension; k++)
        fmpq_add(out + k, a + k, b + k);
}

void vector_sub(fmpq *out, const fmpq *a, const fmpq *b, int dimension) {
    for (int k = 0; k < dimension; k++)
        fmpq_sub(out + k, a + k, b + k);
}

void vector_middle(fmpq *out, const fmpq *a, const fmpq *b, int dimension) {
    vector_add(out, a, b, dimension);
    for (int k = 0; k < dimension; k++)
        fmpq_div_2exp(out + k, out + k, 1);
}

void vector_between(fmpq *out, const fmpq *a, const fmpq *b, const fmpq_t part, int dimension) {
    LOCAL(fmpq, step);
    for (int i = 0; i < dimension; i++) {
        fmpq_sub(step, b + i, a + i);
        fmpq_mul(step, step, part);
        fmpq_add(out + i, a + i, step);
    }
}

void vector_zero(fmpq *out, const fmpq *p, const fmpq *q, const fmpq_t a, const fmpq_t b,
                 int dimension) {
    LOCAL(fmpq, part);
    fmpq_sub(part, a, b);
    fmpq_div(part, a, part);
    vector_between(out, p, q, part, dimension);
}

void vector_dot_integers(fmpq_t out, const fmpz *a, const fmpq *b, int dimension) {
    LOCAL(fmpq, term);
    fmpq_zero(out);
    for (int i = 0; i < dimension; i++) {
        fmpq_mul_fmpz(term, b + i, a + i);
        fmpq_add(out, out, term);
    }
}

int vector_is_zero(const fmpq *a, int dimension) {
    int i = 0;
    while (i < dimension && fmpq_is_zero(a + i))
        i++;
    return i == dimension;
}

int vector_widest(fmpq_t size, const fmpq *a, int dimension) {
    int widest = 0;
    LOCAL(fmpq, here);
    fmpq_zero(size);
    for (int i = 0; i < dimension; i++) {
        fmpq_abs(here, a + i);
        if (fmpq_cmp(here, size) <= 0)
            continue;
        fmpq_swap(here, size);
        widest = i;
    }
    return widest;
}

void vector_cross(fmpq *out, const fmpq *a, const fmpq *b) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        fmpq_mul(out + k, a + i, b + j);
        fmpq_submul(out + k, a + j, b + i);
    }
}

void integers_cross(fmpz *out, const fmpz *a, const fmpz *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        fmpz_mul(out + i, a + j, b + k);
        fmpz_submul(out + i, a + k, b + j);
    }
}

void vector_image(fmpq *out, const fmpq_mat_t map, const fmpq *point, int dimension) {
    for (int i = 0; i < dimension; i++) {
        fmpq_set(out + i, fmpq_mat_entry(map, i, dimension));
        for (int j = 0; j < dimension; j++)
            fmpq_addmul(out + i, fmpq_mat_entry(map, i, j), point + j);
    }
}

int vector_compare(const fmpq *a, const fmpq *b, int dimension) {
    int order = 0;
    for (int i = 0; i < dimension && order == 0; i++)
        order = fmpq_cmp(a + i, b + i);
    return order;
}

void vector_set(fmpq *out, const fmpq *a, int dimension) {
    for (int i = 0; i < dimension; i++)
        fmpq_set(out + i, a + i);
}

void cross_integers(fmpz_t out, const fmpz *p, const fmpz *q, const fmpz *r, int i, int j) {
    LOCAL(fmpz, a);
    LOCAL(fmpz, b);
    fmpz_sub(a, q + i, p + i);
    fmpz_sub(b, r + j, p + j);
    fmpz_mul(out, a, b);
    fmpz_sub(a, q + j, p + j);
    fmpz_sub(b, r + i, p + i);
    fmpz_submul(out, a, b);
}

/* Computes with integers over one common denominator. */
void cross_rationals(fmpq_t out, const fmpq *p, const fmpq *q, const fmpq *r, int i, int j) {
    const fmpq borrowed[] = {p[i], p[j], q[i], q[j], r[i], r[j]};
    LOCAL_VEC(fmpz, at, 8);
    fmpz *common = at + 6, *product = at + 7;
    _fmpq_vec_get_fmpz_vec_fmpz(at, common, borrowed, 6);
    cross_integers(product, at, at + 2, at + 4, 0, 1);
    fmpz_mul(common, common, common);
    fmpq_set_fmpz_frac(out, product, common);
}

int vector_collinear(const fmpq *a, const fmpq *b, const fmpq *c) {
    int zero = 1;
    LOCAL(fmpq, area);
    for (int i = 0; i < 3 && zero; i++) {
        cross_rationals(area, a, b, c, i, (i + 1) % 3);
        zero = fmpq_is_zero(area);
    }
    return zero;
}
