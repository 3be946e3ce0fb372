/* Half-spaces that cut the nodes of a curved solid, and the boxes that they leave.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The members of an intersection count within its half-spaces alone, wherever they are read
 * (proofs/curved.md C102). A cylinder or a cone without an end has one where a half-space cuts it
 * off: form . y is least at the rim of the disk at height h, where it is a linear function of h.
 */
#include "input/csg/csg_reader.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Take the work with these numbers from what is left; returns 0 if that is less. */
static int spend_cut(csg_reader *r, const fmpq *number, int count) {
    unsigned long most = 0;
    for (int k = 0; k < count; k++) {
        unsigned long bits =
            fmpz_bits(fmpq_numref(number + k)) + fmpz_bits(fmpq_denref(number + k));
        most = bits > most ? bits : most;
    }
    unsigned long words = most / FLINT_BITS + 1;
    r->cut_work = words * words < r->cut_work ? r->cut_work - words * words : 0;
    return r->cut_work > 0;
}

void csg_add_cut(csg_reader *r, const fmpq *normal, const fmpq_t offset) {
    int d = r->dimension;
    if (r->cuts == CSG_CUTS_MOST || !spend_cut(r, r->place->entries, (d + 1) * (d + 1)))
        return;
    LOCAL(fmpq_mat, form, 1, d + 1);
    LOCAL(fmpq_mat, inverse, d + 1, d + 1);
    vector_set(fmpq_mat_entry(form, 0, 0), normal, d);
    fmpq_neg(fmpq_mat_entry(form, 0, d), offset);
    fmpq_mat_inv(inverse, r->place);
    fmpq_mat_mul(form, form, inverse);
    vector_set(r->cut + 4 * r->cuts++, fmpq_mat_entry(form, 0, 0), d + 1);
}

/* Bound the heights along the axis at which the primitive comes into a half-space, `form` in the
 * frame of the node: by `out` from above if `upward`, else from below. Returns 0 if there is no
 * bound. */
static int bound_heights(fmpq_t out, const csg_shaft *body, const fmpq *form, int upward) {
    LOCAL_VEC(fmpq, v, 4);
    fmpq *along = v, *part = v + 1, *side = v + 2, *rim = v + 3;
    _fmpq_vec_dot(along, form, body->axis, 3);
    _fmpq_vec_dot(part, form, form, 3);
    fmpq_mul(part, part, body->length2);
    fmpq_submul(part, along, along); /* |axis|^2 times the square of the form's part normal to it */
    if (!body->is_cone)
        fmpq_div(part, part, body->length2);
    csg_upper_root(rim, part);
    fmpq_mul(rim, rim, body->size);
    _fmpq_vec_dot(side, form, body->point, 3);
    fmpq_add(side, side, form + 3);
    fmpq_sub(body->is_cone ? along : side, body->is_cone ? along : side, rim);
    if (fmpq_sgn(along) != (upward ? 1 : -1))
        return 0;
    fmpq_neg(side, side);
    fmpq_div(out, side, along);
    return 1;
}

int csg_cut_height(fmpq_t out, csg_reader *r, const csg_shaft *body, int upward) {
    int d = r->dimension, found = 0;
    LOCAL(fmpq, height);
    LOCAL(fmpq_mat, form, 1, d + 1);
    for (int k = 0; k < r->cuts && spend_cut(r, r->cut + 4 * k, d + 1); k++) {
        vector_set(fmpq_mat_entry(form, 0, 0), r->cut + 4 * k, d + 1);
        fmpq_mat_mul(form, form, r->place);
        if (!spend_cut(r, fmpq_mat_entry(form, 0, 0), d + 1) ||
            !bound_heights(height, body, fmpq_mat_entry(form, 0, 0), upward))
            continue;
        int order = found ? fmpq_cmp(height, out) : 0;
        if (!found || (upward ? order < 0 : order > 0))
            fmpq_set(out, height);
        found = 1;
    }
    return found;
}

/* Sides of a box that are known: bit 2 i of the low one of coordinate i, bit 2 i + 1 of the high
 * one. */
static unsigned side_bit(int i, int high) {
    return 1u << (2 * i + high);
}

/* Move the side of coordinate i that a half-space bounds, if the others bound its other terms. The
 * side stays where the box would become empty, as the node then is, or the number too long. Returns
 * 1 if it moved. */
static int move_side(csg_box *box, unsigned *known, csg_reader *r, const fmpq *form, int i) {
    LOCAL(fmpq, bound);
    fmpq_set(bound, form + r->dimension);
    for (int j = 0; j < r->dimension; j++) {
        int high = fmpq_sgn(form + j) < 0;
        if (j == i || fmpq_is_zero(form + j))
            continue;
        if (!(*known & side_bit(j, high)))
            return 0;
        fmpq_addmul(bound, form + j, high ? &box->high[j] : &box->low[j]);
    }
    fmpq_div(bound, bound, form + i);
    fmpq_neg(bound, bound);
    int high = fmpq_sgn(form + i) > 0;
    fmpq *side = high ? &box->high[i] : &box->low[i], *other = high ? &box->low[i] : &box->high[i];
    int sign = high ? 1 : -1;
    if ((*known & side_bit(i, high) && sign * fmpq_cmp(bound, side) >= 0) ||
        (*known & side_bit(i, !high) && sign * fmpq_cmp(bound, other) <= 0) ||
        csg_is_long(r->context, bound) || !spend_cut(r, bound, 1))
        return 0;
    fmpq_set(side, bound);
    *known |= side_bit(i, high);
    return 1;
}

void csg_cut_box(csg_reader *r, int first) {
    int d = r->dimension, moved = 1;
    unsigned all = (1u << 2 * d) - 1, known = r->box.dimension ? all : 0;
    for (int round = 0; round < d && moved; round++) {
        moved = 0;
        for (int k = first; k < r->cuts; k++)
            for (int i = 0; i < d && r->cut_work; i++)
                if (!fmpq_is_zero(r->cut + 4 * k + i))
                    moved |= move_side(&r->box, &known, r, r->cut + 4 * k, i);
    }
    r->box.dimension = known == all ? d : 0;
}
