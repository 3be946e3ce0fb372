/* Coordinates in a plane, and the part of the plane in a box.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/panel.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "base/number/vector.h"

/* Divide a vector by the absolute value of its largest entry. */
static void divide_by_largest(fmpq *v) {
    LOCAL(fmpq, most);
    vector_widest(most, v, 3);
    for (int k = 0; k < 3; k++)
        fmpq_div(v + k, v + k, most);
}

/* Give a vector, whose largest entry has size 1, the length 1 as nearly as a double can. */
static void shorten(fmpq *v) {
    enum { BITS = 53 };
    LOCAL(fmpq, scale);
    _fmpq_vec_dot(scale, v, v, 3);
    fmpz_set_d(fmpq_numref(scale), ldexp(1 / sqrt(fmpq_get_d(scale)), BITS));
    fmpz_one(fmpq_denref(scale));
    fmpq_div_2exp(scale, scale, BITS);
    for (int k = 0; k < 3; k++)
        fmpq_mul(v + k, v + k, scale);
}

static void find_ways(section *s) {
    LOCAL_VEC(fmpq, normal, 3);
    vector_set(normal, s->normal, 3);
    divide_by_largest(normal);
    if (fmpq_is_zero(normal) && fmpq_is_zero(normal + 1)) {
        fmpq_one(s->way[0]);
    } else {
        fmpq_neg(s->way[0], normal + 1);
        fmpq_set(s->way[0] + 1, normal);
    }
    divide_by_largest(s->way[0]);
    vector_cross(s->way[1], normal, s->way[0]);
    divide_by_largest(s->way[1]);
    shorten(s->way[0]);
    shorten(s->way[1]);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            s->look.row[i][k] = fmpq_get_d(s->way[i] + k);
    cross3(s->unit, s->look.row[0], s->look.row[1]);
}

void section_make(section *out, const fmpq *normal, const fmpq_t place) {
    LOCAL(fmpq, square);
    fmpq *all = _fmpq_vec_init(13);
    *out = (section){all, all + 12, all + 3, {all + 6, all + 9}, {{{0}}}, {0}, 0};
    fmpq_set(out->place, place);
    vector_set(out->normal, normal, 3);
    _fmpq_vec_dot(square, normal, normal, 3);
    fmpq_div(square, place, square);
    for (int k = 0; k < 3; k++)
        fmpq_mul(out->origin + k, normal + k, square);
    find_ways(out);
    for (int k = 0; k < 3; k++)
        out->unit_height += out->unit[k] * fmpq_get_d(out->origin + k);
}

void section_clear(section *s) {
    if (s->normal)
        _fmpq_vec_clear(s->normal, 13);
    s->normal = NULL;
}

void section_point(fmpq *out, const section *s, const fmpq *uv) {
    for (int k = 0; k < 3; k++) {
        fmpq_set(out + k, s->origin + k);
        fmpq_addmul(out + k, s->way[0] + k, uv);
        fmpq_addmul(out + k, s->way[1] + k, uv + 1);
    }
}

/* normal . x - place */
static void height_of(fmpq_t out, const section *s, const fmpq *point) {
    _fmpq_vec_dot(out, s->normal, point, 3);
    fmpq_sub(out, out, s->place);
}

int section_holds(const section *s, const fmpq *point) {
    LOCAL(fmpq, height);
    height_of(height, s, point);
    return fmpq_is_zero(height);
}

/* Enlarge a rectangle until it holds a point of the plane; `first`: set it to the point. */
static void hold_point(fmpq *low, fmpq *high, int first, const section *s, const fmpq *point) {
    LOCAL_VEC(fmpq, value, 2);
    fmpq *square = value + 1;
    for (int i = 0; i < 2; i++) {
        _fmpq_vec_dot(value, s->way[i], point, 3);
        _fmpq_vec_dot(square, s->way[i], s->way[i], 3);
        fmpq_div(value, value, square);
        if (first || fmpq_cmp(value, low + i) < 0)
            fmpq_set(low + i, value);
        if (first || fmpq_cmp(value, high + i) > 0)
            fmpq_set(high + i, value);
    }
}

/* The point in which the line from a to b meets the plane; a and b are on different sides. */
static void meet_edge(fmpq *out, const section *s, const fmpq *a, const fmpq *b) {
    LOCAL(fmpq, from);
    LOCAL(fmpq, to);
    height_of(from, s, a);
    height_of(to, s, b);
    vector_zero(out, a, b, from, to, 3);
}

/* Enlarge an interval so that its ends are multiples of a power of two that is 2^-12 to 2^-13 of
 * its length; the ends become short numbers. */
static void round_extent(fmpq_t low, fmpq_t high) {
    enum { PARTS = 12 };
    LOCAL_VEC(fmpq, length, 2);
    fmpq *unit = length + 1;
    LOCAL(fmpz, whole);
    fmpq_sub(length, high, low);
    slong bits = (slong)fmpz_bits(fmpq_numref(length)) - (slong)fmpz_bits(fmpq_denref(length));
    fmpq_one(unit);
    rational_shift(unit, bits - PARTS);
    fmpq_div(length, low, unit);
    fmpz_fdiv_q(whole, fmpq_numref(length), fmpq_denref(length));
    fmpq_mul_fmpz(low, unit, whole);
    fmpq_div(length, high, unit);
    fmpz_cdiv_q(whole, fmpq_numref(length), fmpq_denref(length));
    fmpq_mul_fmpz(high, unit, whole);
}

int section_extent(fmpq *low, fmpq *high, const section *s, const fmpq *box_low,
                   const fmpq *box_high) {
    int found = 0;
    LOCAL_VEC(fmpq, corner, 24);
    LOCAL_VEC(fmpq, point, 3);
    int sign[8];
    LOCAL(fmpq, height);
    for (int c = 0; c < 8; c++) {
        for (int k = 0; k < 3; k++)
            fmpq_set(corner + 3 * c + k, (c >> k & 1 ? box_high : box_low) + k);
        height_of(height, s, corner + 3 * c);
        sign[c] = fmpq_sgn(height);
    }
    for (int c = 0; c < 8; c++)
        for (int k = 0; k < 3; k++) {
            int other = c | 1 << k;
            if (other == c || sign[c] * sign[other] >= 0)
                continue;
            meet_edge(point, s, corner + 3 * c, corner + 3 * other);
            hold_point(low, high, !found++, s, point);
        }
    for (int c = 0; c < 8; c++)
        if (sign[c] == 0)
            hold_point(low, high, !found++, s, corner + 3 * c);
    if (!found || fmpq_cmp(low, high) >= 0 || fmpq_cmp(low + 1, high + 1) >= 0)
        return 0;
    for (int i = 0; i < 2; i++)
        round_extent(low + i, high + i);
    return 1;
}

void section_equation(text *out, const section *s) {
    int first = 1;
    LOCAL(fmpq, size);
    for (int k = 0; k < 3; k++) {
        if (fmpq_is_zero(s->normal + k))
            continue;
        int negative = fmpq_sgn(s->normal + k) < 0;
        fmpq_abs(size, s->normal + k);
        text_put(out, first ? negative ? "-" : "" : negative ? " - " : " + ");
        if (!fmpq_is_one(size)) {
            text_rational(out, size);
            text_put(out, "*");
        }
        text_format(out, "%c", "xyz"[k]);
        first = 0;
    }
    text_put(out, " = ");
    text_rational(out, s->place);
}

/* Append three numbers, as decimals of four digits or exact. */
static void describe_vector(text *out, const fmpq *v, int exact) {
    int unused;
    for (int k = 0; k < 3; k++) {
        text_put(out, k ? exact ? " " : ", " : "");
        if (exact)
            text_rational(out, v + k);
        else
            text_owned(out, decimal_of_rational(&unused, v + k, 4));
    }
}

void section_describe(text *out, const section *s, int exact) {
    static const char *const between[2][4] = {
        {" · u from (", ") along (", "), v along (", ")"},
        {" data-origin=\"", "\" data-u=\"", "\" data-v=\"", "\""}};
    const fmpq *const vectors[3] = {s->origin, s->way[0], s->way[1]};
    for (int k = 0; k < 3; k++) {
        text_put(out, between[exact][k]);
        describe_vector(out, vectors[k], exact);
    }
    text_put(out, between[exact][3]);
}
