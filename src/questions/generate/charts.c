/* Finds common zeros by factors and by remainders of division.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/array.h"
#include "base/context/scope.h"

/* Parameters of flats are drawn as multiples of 1/256 of the box's sides; lines through a zero of a
 * quadric have directions with components from -16 to 16. */
enum { PARTS = 256, REACH = 16 };

void charts_clear(charts *list) {
    for (size_t k = 0; k < list->count; k++) {
        flat_clear(&list->item[k].place);
        quadratic_clear(&list->item[k].curve);
    }
    free(list->item);
}

static graze_status append_chart(charts *list, const flat *place, const quadratic *curve) {
    TRY(LIST_GROW(list->context, list, "rational points of surfaces"));
    chart *to = &list->item[list->count++];
    *to = (chart){.bent = curve != NULL, .mark = list->mark};
    flat_init(&to->place, place->dimension);
    flat_set(&to->place, place);
    quadratic_init(&to->curve);
    if (curve)
        quadratic_set(&to->curve, curve);
    return GRAZE_OK;
}

/* Add the point where a quadratic polynomial and its gradient are zero, if there is one. */
static graze_status add_singular(charts *list, const flat *place, quadratic *q) {
    HELD(flat, point, place->dimension);
    if (quadratic_center(q) && fmpq_is_zero(q->value)) {
        flat_point(point.origin, place, q->start);
        point.count = 0;
        TRY(append_chart(list, &point, NULL));
        list->item[list->count - 1].isolated = 1;
    }
    return GRAZE_OK;
}

/* Add the zeros of one factor. A linear factor adds a flat. A quadratic one adds a quadric if a
 * zero with a gradient is found on it, else its singular point if it has one. A factor of higher
 * degree adds nothing.
 */
static graze_status add_factor_zeros(charts *list, const flat *place, const fmpq_mpoly_t factor) {
    slong degree = fmpq_mpoly_total_degree_si(factor, list->ring);
    if (degree == 1) {
        HELD(flat, part, place->dimension);
        flat_set(&part, place);
        flat_cut(&part, factor, list->ring);
        TRY(append_chart(list, &part, NULL));
    } else if (degree == 2 && place->count > 1) {
        HELD(quadratic, q);
        quadratic_read(&q, factor, place->count, list->ring);
        if (quadratic_find_zero(&q))
            TRY(append_chart(list, place, &q));
        else
            TRY(add_singular(list, place, &q));
    }
    return context_poll(list->context);
}

static graze_status add_zeros(charts *list, const flat *place, const fmpq_mpoly_t p) {
    IN_RING(fmpq_mpoly_factor, parts, list->ring);
    if (!fmpq_mpoly_is_zero(p, list->ring) && fmpq_mpoly_factor(parts, p, list->ring))
        for (slong k = 0; k < parts->num; k++)
            TRY(add_factor_zeros(list, place, parts->poly + k));
    return GRAZE_OK;
}

graze_status charts_add_section(charts *list, const flat *place, const fmpq_mpoly_t p) {
    IN_RING(fmpq_mpoly, x, list->ring);
    IN_RING(fmpq_mpoly, y, list->ring);
    IN_RING(fmpq_mpoly, z, list->ring);
    IN_RING(fmpq_mpoly, rest, list->ring);
    fmpq_mpoly_struct *at[3] = {x, y, z};
    flat_coordinates(at, place, list->ring);
    if (fmpq_mpoly_compose_fmpq_mpoly(rest, p, at, list->ring, list->ring))
        TRY(add_zeros(list, place, rest));
    return GRAZE_OK;
}

/* Add the zeros of p on the plane where a linear polynomial is zero. */
static graze_status add_plane_section(charts *list, const fmpq_mpoly_t linear,
                                      const fmpq_mpoly_t p) {
    HELD(flat, part, list->dimension);
    flat_cut(&part, linear, list->ring);
    return charts_add_section(list, &part, p);
}

/* Add the zeros of `low` where a linear factor of the remainder of `high` divided by `low` is zero.
 */
static graze_status add_remainder(charts *list, const fmpq_mpoly_t high, const fmpq_mpoly_t low) {
    IN_RING(fmpq_mpoly, quotient, list->ring);
    IN_RING(fmpq_mpoly, rest, list->ring);
    IN_RING(fmpq_mpoly_factor, parts, list->ring);
    fmpq_mpoly_divrem(quotient, rest, high, low, list->ring);
    if (!fmpq_mpoly_is_zero(rest, list->ring) && fmpq_mpoly_factor(parts, rest, list->ring))
        for (slong k = 0; k < parts->num; k++)
            if (fmpq_mpoly_total_degree_si(parts->poly + k, list->ring) == 1)
                TRY(add_plane_section(list, parts->poly + k, low));
    return GRAZE_OK;
}

/* Add common zeros of two irreducible polynomials, if one of them is linear or the remainder of
 * dividing one by the other has a linear factor. */
static graze_status add_pair(charts *list, const fmpq_mpoly_t p, const fmpq_mpoly_t q) {
    slong of_p = fmpq_mpoly_total_degree_si(p, list->ring);
    slong of_q = fmpq_mpoly_total_degree_si(q, list->ring);
    size_t before = list->count;
    if (of_p == 1)
        return add_plane_section(list, p, q);
    if (of_q == 1)
        return add_plane_section(list, q, p);
    TRY(of_p >= of_q ? add_remainder(list, p, q) : GRAZE_OK);
    if (of_p <= of_q && list->count == before)
        TRY(add_remainder(list, q, p));
    return GRAZE_OK;
}

graze_status charts_add_common(charts *list, const fmpq_mpoly_t p, const fmpq_mpoly_t q) {
    IN_RING(fmpq_mpoly_factor, parts, list->ring);
    if (!fmpq_mpoly_is_zero(q, list->ring) && fmpq_mpoly_factor(parts, q, list->ring))
        for (slong k = 0; k < parts->num; k++)
            TRY(add_pair(list, p, parts->poly + k));
    return GRAZE_OK;
}

graze_status charts_add_singular(charts *list, const fmpq_mpoly_t p) {
    HELD(quadratic, q);
    quadratic_read(&q, p, list->dimension, list->ring);
    HELD(flat, space, list->dimension);
    return add_singular(list, &space, &q);
}

/* A power of two that is at most the length of a side and more than a quarter of it. */
static void side_size(fmpq_t out, const fmpq_t low, const fmpq_t high) {
    fmpq_sub(out, high, low);
    slong bits = (slong)fmpz_bits(fmpq_numref(out)) - (slong)fmpz_bits(fmpq_denref(out)) - 1;
    fmpq_one(out);
    rational_shift(out, bits);
}

int chart_draw(fmpq *point, const chart *from, random_stream *r, const csg_box *in) {
    int n = from->place.count, made = 1;
    size_t kind = random_below(r, 4);
    LOCAL_VEC(fmpq, s, 6);
    fmpq *v = s + 3;
    for (int j = 0; j < n; j++) {
        int axis = from->place.axis[j];
        if (from->bent) {
            side_size(v + j, in->low + axis, in->high + axis);
            /* by kind 0, points with short coordinates are found too */
            slong reach = kind == 0 ? 1 : REACH;
            fmpq_mul_si(v + j, v + j, (slong)random_below(r, (size_t)(2 * reach + 1)) - reach);
        } else {
            fmpq_sub(v + j, in->high + axis, in->low + axis);
            fmpq_set_si(s + j, (slong)random_below(r, PARTS + 1), PARTS);
            fmpq_mul(s + j, s + j, v + j);
            fmpq_add(s + j, s + j, in->low + axis);
        }
    }
    if (from->bent)
        made = quadratic_other_zero(s, &from->curve, v);
    flat_point(point, &from->place, s);
    return made;
}
