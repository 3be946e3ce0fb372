/* Vectors of rationals.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/vector.h"

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

int vector_is_zero(const fmpq *a, int dimension) {
    int zero = 1;
    for (int i = 0; i < dimension && zero; i++)
        zero = fmpq_is_zero(a + i);
    return zero;
}

void vector_cross(fmpq *out, const fmpq *a, const fmpq *b) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        fmpq_mul(out + k, a + i, b + j);
        fmpq_submul(out + k, a + j, b + i);
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
