/* Directions: vectors of integers up to a factor. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/topo.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "questions/topo/cover.h"

void directions_cross(fmpz *out, const fmpz *a, const fmpz *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        fmpz_mul(out + i, a + j, b + k);
        fmpz_submul(out + i, a + k, b + j);
    }
}

int directions_parallel(const fmpz *a, const fmpz *b) {
    LOCAL_VEC(fmpz, cross, 3);
    directions_cross(cross, a, b);
    return _fmpz_vec_is_zero(cross, 3);
}

void directions_basis(fmpz *h, fmpz *k, const fmpz *v) {
    int i = 0;
    LOCAL_VEC(fmpz, axis, 3);
    while (fmpz_is_zero(v + i))
        i++;
    fmpz_one(axis + (i + 1) % 3);
    directions_cross(h, v, axis);
    directions_cross(k, v, h);
}

void direction_reduce(fmpz *v, slong n) {
    LOCAL(fmpz, content);
    _fmpz_vec_content(content, v, n);
    if (!fmpz_is_zero(content))
        _fmpz_vec_scalar_divexact_fmpz(v, v, n, content);
}

void direction_of_rationals(fmpz *out, const fmpq *x, slong n) {
    LOCAL(fmpz, common);
    _fmpq_vec_get_fmpz_vec_fmpz(out, common, x, n);
    direction_reduce(out, n);
}
