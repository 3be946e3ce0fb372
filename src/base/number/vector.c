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

void vector_cross(fmpq *out, const fmpq *a, const fmpq *b) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        fmpq_mul(out + k, a + i, b + j);
        fmpq_submul(out + k, a + j, b + i);
    }
}
