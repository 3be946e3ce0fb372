/* Directions: vectors of integers up to a factor; their spans.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/topo/near.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

int directions_parallel(const fmpz *a, const fmpz *b) {
    LOCAL_VEC(fmpz, cross, 3);
    integers_cross(cross, a, b);
    return _fmpz_vec_is_zero(cross, 3);
}

void germ_normal_about(fmpz *out, const germ *g, const fmpz *normal) {
    int d = g->cone.dimension;
    _fmpz_vec_zero(out, d);
    for (int row = 0; row < d; row++)
        _fmpz_vec_scalar_addmul_fmpz(out, g->to_body + row * d, d, normal + row);
}

void directions_basis(fmpz *h, fmpz *k, const fmpz *v) {
    int i = 0;
    LOCAL_VEC(fmpz, axis, 3);
    while (fmpz_is_zero(v + i))
        i++;
    fmpz_one(axis + (i + 1) % 3);
    integers_cross(h, v, axis);
    integers_cross(k, v, h);
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

/* Subtract from v, d + 1 entries, the multiple of b that leaves its product with b's normal, by the
 * first `count` entries, 0. */
static void drop_part(fmpq *v, const fmpq *b, int d, int count, int changed) {
    LOCAL_VEC(fmpq, part, 2);
    fmpq *length = part + 1;
    _fmpq_vec_dot(part, v, b, count);
    _fmpq_vec_dot(length, b, b, d);
    fmpq_div(part, part, length);
    for (int i = 0; i < changed; i++)
        fmpq_submul(v + i, b + i, part);
}

void plane_stack_add(plane_stack *p, fmpq *x, const fmpz *form) {
    int d = p->dimension, rank = p->rank;
    fmpq *made = p->form + rank * (d + 1);
    if (rank == d)
        return;
    _fmpq_vec_set_fmpz_vec(made, form, d + 1);
    for (int k = 0; k < rank; k++)
        drop_part(made, p->form + k * (d + 1), d, d, d + 1);
    if (vector_is_zero(made, d))
        return;
    drop_part(x, made, d, d + 1, d);
    p->rank++;
}

void direction_span_add(direction_span *s, const fmpz *v) {
    fmpz *cross = s->basis + 6;
    LOCAL(fmpz, volume);
    if (s->rank == 0 && !_fmpz_vec_is_zero(v, 3)) {
        _fmpz_vec_set(s->basis, v, 3);
        s->rank = 1;
    } else if (s->rank == 1 && !directions_parallel(s->basis, v)) {
        _fmpz_vec_set(s->basis + 3, v, 3);
        integers_cross(cross, s->basis, v);
        s->rank = 2;
    } else if (s->rank == 2) {
        _fmpz_vec_dot(volume, cross, v, 3);
        s->rank += !fmpz_is_zero(volume);
    }
}
