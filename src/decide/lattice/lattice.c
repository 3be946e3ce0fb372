/* Points of a grid. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/lattice/lattice.h"

#include "base/context/scope.h"

/* With q the common denominator of low and high and n points: the unit is q (n - 1). */
static void make_axis(lattice *l, int k, const fmpq *low, const fmpq *high) {
    LOCAL(fmpz, common);
    fmpz_lcm(common, fmpq_denref(low), fmpq_denref(high));
    fmpz_divexact(l->start + k, common, fmpq_denref(low));
    fmpz_mul(l->start + k, l->start + k, fmpq_numref(low));
    fmpz_divexact(l->step + k, common, fmpq_denref(high));
    fmpz_mul(l->step + k, l->step + k, fmpq_numref(high));
    fmpz_sub(l->step + k, l->step + k, l->start + k);
    fmpz_mul_ui(l->start + k, l->start + k, l->size[k] - 1);
    fmpz_mul_ui(l->unit + k, common, l->size[k] - 1);
}

void lattice_make(lattice *out, int dimension, const size_t *size, const fmpq *low,
                  const fmpq *high) {
    *out = (lattice){.dimension = dimension, .size = {1, 1, 1}, .count = 1};
    for (int k = 0; k < dimension; k++) {
        out->size[k] = size[k];
        out->count *= size[k];
        make_axis(out, k, low + k, high + k);
    }
}

void lattice_clear(lattice *l) {
    _fmpz_vec_zero(l->start, 3);
    _fmpz_vec_zero(l->step, 3);
    _fmpz_vec_zero(l->unit, 3);
}

void lattice_coordinate(fmpq_t out, const lattice *l, int k, size_t i) {
    fmpz_mul_ui(fmpq_numref(out), l->step + k, i);
    fmpz_add(fmpq_numref(out), fmpq_numref(out), l->start + k);
    fmpz_set(fmpq_denref(out), l->unit + k);
    fmpq_canonicalise(out);
}

void lattice_place(size_t place[3], const lattice *l, size_t index) {
    for (int k = 0; k < 3; k++) {
        place[k] = index % l->size[k];
        index /= l->size[k];
    }
}
