/* Flats by parameters that are coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

void flat_init(flat *f, int dimension) {
    f->dimension = f->count = dimension;
    f->origin = _fmpq_vec_init(12);
    for (int i = 0; i < 3; i++) {
        f->axis[i] = i;
        f->direction[i] = f->origin + 3 + 3 * i;
        fmpq_one(f->direction[i] + i);
    }
}

void flat_set(flat *to, const flat *from) {
    to->dimension = from->dimension;
    to->count = from->count;
    for (int i = 0; i < 3; i++) {
        to->axis[i] = from->axis[i];
        vector_set(to->direction[i], from->direction[i], 3);
    }
    vector_set(to->origin, from->origin, 3);
}

void flat_clear(flat *f) {
    _fmpq_vec_clear(f->origin, 12);
}

void flat_point(fmpq *out, const flat *f, const fmpq *s) {
    for (int i = 0; i < f->dimension; i++) {
        fmpq_set(out + i, f->origin + i);
        for (int j = 0; j < f->count; j++)
            fmpq_addmul(out + i, f->direction[j] + i, s + j);
    }
}

void flat_coordinates(fmpq_mpoly_struct *const *out, const flat *f, const fmpq_mpoly_ctx_t ring) {
    IN_RING(fmpq_mpoly, term, ring);
    for (int i = 0; i < f->dimension; i++) {
        fmpq_mpoly_set_fmpq(out[i], f->origin + i, ring);
        for (int j = 0; j < f->count; j++) {
            fmpq_mpoly_gen(term, j, ring);
            fmpq_mpoly_scalar_mul_fmpq(term, term, f->direction[j] + i, ring);
            fmpq_mpoly_add(out[i], out[i], term, ring);
        }
    }
}

/* The equation gives s_pivot = -(constant + sum h_j s_j) / h_pivot; the other parameters remain. */
void flat_cut(flat *f, const fmpq_mpoly_t linear, const fmpq_mpoly_ctx_t ring) {
    LOCAL_VEC(fmpq, h, 5);
    fmpq *constant = h + 3, *size = h + 4;
    for (int j = 0; j <= 3; j++)
        fmpq_mpoly_get_coeff_fmpq_ui(h + j, linear, (ulong[]){j == 0, j == 1, j == 2}, ring);
    int pivot = vector_widest(size, h, f->count), to = 0;
    fmpq_div(constant, constant, h + pivot);
    for (int i = 0; i < 3; i++)
        fmpq_submul(f->origin + i, constant, f->direction[pivot] + i);
    for (int j = 0; j < f->count; j++) {
        if (j == pivot)
            continue;
        fmpq_div(h + j, h + j, h + pivot);
        for (int i = 0; i < 3; i++)
            fmpq_submul(f->direction[j] + i, h + j, f->direction[pivot] + i);
    }
    for (int j = 0; j < f->count; j++) {
        if (j == pivot)
            continue;
        fmpq *swapped = f->direction[to];
        f->direction[to] = f->direction[j];
        f->direction[j] = swapped;
        f->axis[to++] = f->axis[j];
    }
    f->count--;
}
