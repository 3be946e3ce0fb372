/* Boxes that hold the nodes of a curved solid, by its primitives.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A coordinate of the solid is a linear form g in the node's frame. In its direction a disk of
 * radius R with normal a reaches R sqrt(|g|^2 - (g . a)^2 / |a|^2) from its centre, and the
 * Minkowski sum of the disk with a ball of radius r reaches r |g| further.
 */
#include "input/csg/csg_reader.h"

#include "base/context/scope.h"

/* Binary places of the bound of an irrational root. */
enum { ROOT_BITS = 24 };

void csg_upper_root(fmpq_t out, const fmpq_t value) {
    LOCAL_VEC(fmpz, n, 2);
    fmpz *rest = n + 1;
    fmpz_mul(n, fmpq_numref(value), fmpq_denref(value));
    fmpz_set(fmpq_denref(out), fmpq_denref(value));
    fmpz_sqrtrem(fmpq_numref(out), rest, n);
    if (!fmpz_is_zero(rest)) {
        fmpz_mul_2exp(n, n, 2 * ROOT_BITS);
        fmpz_mul_2exp(fmpq_denref(out), fmpq_denref(out), ROOT_BITS);
        fmpz_sqrt(fmpq_numref(out), n);
        fmpz_add_ui(fmpq_numref(out), fmpq_numref(out), 1);
    }
    fmpq_canonicalise(out);
}

/* How far the Minkowski sum of a disk and a ball reaches in the direction of a form. */
static void round_reach(fmpq_t out, const fmpq *form, const fmpq *axis, const fmpq_t ball,
                        const fmpq_t disk, int d) {
    LOCAL_VEC(fmpq, v, 3);
    _fmpq_vec_dot(v, form, form, d);
    csg_upper_root(out, v);
    fmpq_mul(out, out, ball);
    if (!fmpq_is_zero(disk)) {
        _fmpq_vec_dot(v + 1, form, axis, d);
        _fmpq_vec_dot(v + 2, axis, axis, d);
        fmpq_mul(v + 1, v + 1, v + 1);
        fmpq_div(v + 1, v + 1, v + 2);
        fmpq_sub(v, v, v + 1);
        fmpq_mul(v, v, disk);
        csg_upper_root(v + 1, v);
        fmpq_add(out, out, v + 1);
    }
}

void csg_box_hold(csg_box *box, int i, const fmpq_t low, const fmpq_t high) {
    if (!box->dimension || fmpq_cmp(low, &box->low[i]) < 0)
        fmpq_set(&box->low[i], low);
    if (!box->dimension || fmpq_cmp(high, &box->high[i]) > 0)
        fmpq_set(&box->high[i], high);
}

void csg_bound_round(csg_reader *r, const fmpq *point, const fmpq *axis, const fmpq_t ball,
                     const fmpq_t disk) {
    int d = r->dimension;
    LOCAL_VEC(fmpq, v, 3);
    fmpq *middle = v, *size = v + 1;
    for (int i = 0; i < d; i++) {
        const fmpq *form = fmpq_mat_entry(r->place, i, 0);
        _fmpq_vec_dot(middle, form, point, d);
        fmpq_add(middle, middle, form + d);
        round_reach(size, form, axis, ball, disk, d);
        fmpq_add(v + 2, middle, size);
        fmpq_sub(middle, middle, size);
        csg_box_hold(&r->box, i, middle, v + 2);
    }
    r->box.dimension = d;
}

void csg_bound_corners(csg_reader *r, const fmpq *low, const fmpq *high) {
    int d = r->dimension;
    LOCAL_VEC(fmpq, corner, d);
    LOCAL(fmpq, zero);
    for (int k = 0; k < 1 << d; k++) {
        for (int i = 0; i < d; i++)
            fmpq_set(corner + i, (k >> i & 1 ? high : low) + i);
        csg_bound_round(r, corner, NULL, zero, zero);
    }
}

void csg_bound_union(csg_box *box, const csg_box *other) {
    for (int i = 0; i < box->dimension && other->dimension; i++)
        csg_box_hold(box, i, &other->low[i], &other->high[i]);
    box->dimension = other->dimension ? box->dimension : 0;
}

void csg_bound_intersection(csg_box *box, const csg_box *other) {
    int d = other->dimension, meet = d > 0;
    for (int i = 0; i < d && meet && box->dimension; i++)
        meet = fmpq_cmp(&box->low[i], &other->high[i]) < 0 &&
               fmpq_cmp(&other->low[i], &box->high[i]) < 0;
    for (int i = 0; i < d && meet; i++) {
        if (!box->dimension || fmpq_cmp(&other->low[i], &box->low[i]) > 0)
            fmpq_set(&box->low[i], &other->low[i]);
        if (!box->dimension || fmpq_cmp(&other->high[i], &box->high[i]) < 0)
            fmpq_set(&box->high[i], &other->high[i]);
    }
    box->dimension = box->dimension ? box->dimension : d;
}
