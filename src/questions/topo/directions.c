/* Directions: vectors of integers up to a factor. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/directions.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>

void directions_cross(fmpz *out, const fmpz *a, const fmpz *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        fmpz_mul(out + i, a + j, b + k);
        fmpz_submul(out + i, a + k, b + j);
    }
}

int directions_parallel(const fmpz *a, const fmpz *b) {
    fmpz *cross = _fmpz_vec_init(3);
    directions_cross(cross, a, b);
    int parallel = _fmpz_vec_is_zero(cross, 3);
    _fmpz_vec_clear(cross, 3);
    return parallel;
}

void directions_basis(fmpz *h, fmpz *k, const fmpz *v) {
    int i = 0;
    fmpz *axis = _fmpz_vec_init(3);
    while (fmpz_is_zero(v + i))
        i++;
    fmpz_one(axis + (i + 1) % 3);
    directions_cross(h, v, axis);
    directions_cross(k, v, h);
    _fmpz_vec_clear(axis, 3);
}

void direction_reduce(fmpz *v, slong n) {
    fmpz_t content;
    fmpz_init(content);
    _fmpz_vec_content(content, v, n);
    if (!fmpz_is_zero(content))
        _fmpz_vec_scalar_divexact_fmpz(v, v, n, content);
    fmpz_clear(content);
}

void direction_of_rationals(fmpz *out, const fmpq *x, slong n) {
    fmpz_t common;
    fmpz_init(common);
    _fmpq_vec_get_fmpz_vec_fmpz(out, common, x, n);
    direction_reduce(out, n);
    fmpz_clear(common);
}
