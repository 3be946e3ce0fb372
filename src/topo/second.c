/* Germs below and above a plane as quadratic forms on it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * About the point a place is x + z N, x in the plane across N. A germ below covers z < zeta(x) up
 * to terms of third order, one above z > zeta(x). Where at each x some germ below has a larger zeta
 * than some germ above, they cover all of the plane's directions.
 */
#include "topo/second.h"

#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include "context/array.h"
#include "number/isolate.h"
#include "number/order.h"
#include "number/sign.h"
#include "topo/directions.h"
#include "topo/signs.h"

/* zeta(a h + b k) = form[0] a^2 + form[1] a b + form[2] b^2 in a basis h, k of the plane. */
typedef struct half_germ {
    int above;
    fmpq form[3];
} half_germ;

typedef struct second_maker {
    graze_context *context;
    const fmpq *point;
    const fmpz *normal;
    fmpz *gap;
    fmpz basis[2][3];
    size_t count, capacity;
    half_germ *item;
} second_maker;

/* A plane of a cone, carried to the places about the point: value + r . place, in powers of the
 * time that has passed. */
typedef struct plane_ways {
    fmpq value[3]; /* the first is 0 */
    fmpq normal[2][3];
} plane_ways;

static void ways_clear(plane_ways *w) {
    for (int i = 0; i < 3; i++) {
        fmpq_clear(w->value + i);
        fmpq_clear(w->normal[0] + i);
        fmpq_clear(w->normal[1] + i);
    }
}

/* The constant of plane j of a cone: its form vanishes at the cone's point. */
static void constant_of_plane(fmpq_t out, const local_cone *cone, size_t j) {
    fmpz_t at;
    fmpz_init(at);
    _fmpz_vec_dot(at, cone->normal + 3 * j, cone->at, 3);
    fmpz_neg(at, at);
    fmpq_set_fmpz_frac(out, at, cone->at + 3);
    fmpz_clear(at);
}

/* Expand plane j of a germ at its time. */
static void ways_init(plane_ways *w, const germ *g, size_t j, const fmpq *point) {
    static const fmpz axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    fmpz_poly_t p;
    fmpq_poly_t sum, part, later;
    fmpq_t c;
    fmpz_poly_init(p);
    fmpq_poly_init(sum);
    fmpq_poly_init(part);
    fmpq_poly_init(later);
    fmpq_init(c);
    for (int i = 0; i < 3; i++) {
        fmpq_init(w->value + i);
        fmpq_init(w->normal[0] + i);
        fmpq_init(w->normal[1] + i);
    }
    fmpq_poly_set_coeff_fmpq(later, 0, &g->time);
    fmpq_poly_set_coeff_si(later, 1, 1);
    constant_of_plane(c, &g->cone, j);
    fmpq_poly_set_fmpz_poly(sum, g->map->weight);
    fmpq_poly_scalar_mul_fmpq(sum, sum, c);
    fmpz_poly_zero(p);
    for (int row = 0; row < 3; row++)
        fmpz_poly_scalar_addmul_fmpz(p, &g->map->entry[row * 4 + 3], g->cone.normal + 3 * j + row);
    fmpq_poly_set_fmpz_poly(part, p);
    fmpq_poly_add(sum, sum, part);
    for (int i = 0; i < 3; i++) {
        signs_pull_back(p, g->map, g->cone.normal + 3 * j, axis[i]);
        fmpq_poly_set_fmpz_poly(part, p);
        fmpq_poly_compose(part, part, later);
        for (int k = 0; k < 2; k++)
            fmpq_poly_get_coeff_fmpq(w->normal[k] + i, part, k);
        fmpq_poly_set_fmpz_poly(part, p);
        fmpq_poly_scalar_mul_fmpq(part, part, point + i);
        fmpq_poly_add(sum, sum, part);
    }
    fmpq_poly_compose(sum, sum, later);
    for (int k = 0; k < 3; k++)
        fmpq_poly_get_coeff_fmpq(w->value + k, sum, k);
    fmpz_poly_clear(p);
    fmpq_poly_clear(sum);
    fmpq_poly_clear(part);
    fmpq_poly_clear(later);
    fmpq_clear(c);
}

static void value_on(fmpq_t out, const fmpq *a, const fmpz *b) {
    fmpq_t part;
    fmpq_init(part);
    fmpq_zero(out);
    for (int i = 0; i < 3; i++) {
        fmpq_mul_fmpz(part, a + i, b + i);
        fmpq_add(out, out, part);
    }
    fmpq_clear(part);
}

/* out += factor a b, for linear forms a, b on the plane by their values at its basis. */
static void add_product(fmpq *out, const fmpq_t factor, const fmpq *a, const fmpq *b) {
    fmpq_t part;
    fmpq_init(part);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            fmpq_mul(part, a + i, b + j);
            fmpq_mul(part, part, factor);
            fmpq_add(out + i + j, out + i + j, part);
        }
    fmpq_clear(part);
}

/* A facet along the plane that is touched by an inner contact of second order: (r1 x)^2 / (4 v2 r0
 * N); else 0. */
static void form_of_facet(fmpq *form, const second_maker *m, const germ *g) {
    plane_ways w;
    fmpq linear[2] = {{0, 1}, {0, 1}};
    fmpq_t factor;
    ways_init(&w, g, 0, m->point);
    fmpq_init(factor);
    if (g->side_count == 2 && g->side[0].order == 2) {
        for (int i = 0; i < 2; i++)
            value_on(linear + i, w.normal[1], m->basis[i]);
        value_on(factor, w.normal[0], m->normal);
        fmpq_mul(factor, factor, w.value + 2);
        fmpq_mul_2exp(factor, factor, 2);
        fmpq_inv(factor, factor);
        add_product(form, factor, linear, linear);
    }
    for (int i = 0; i < 2; i++)
        fmpq_clear(linear + i);
    fmpq_clear(factor);
    ways_clear(&w);
}

/* out = a p + b q, n of each. */
static void combine_ways(fmpq *out, const fmpq_t a, const fmpq *p, const fmpq_t b, const fmpq *q,
                         slong n) {
    fmpq_t part;
    fmpq_init(part);
    for (slong i = 0; i < n; i++) {
        fmpq_mul(part, a, p + i);
        fmpq_mul(out + i, b, q + i);
        fmpq_add(out + i, out + i, part);
    }
    fmpq_clear(part);
}

/* An edge: the combination of two of its planes from which the time drops out to first order. 0 if
 * its tangent plane is another one. */
static int form_of_edge(fmpq *form, const second_maker *m, const germ *g, size_t other) {
    plane_ways w[2], both;
    fmpq linear[4] = {{0, 1}, {0, 1}, {0, 1}, {0, 1}}; /* of the time, and of the combination */
    fmpq_t a, factor;
    fmpz *across = _fmpz_vec_init(3);
    fmpq_init(a);
    fmpq_init(factor);
    ways_init(&w[0], g, 0, m->point);
    ways_init(&w[1], g, other, m->point);
    ways_init(&both, g, 0, m->point);
    fmpq_neg(a, w[0].value + 1);
    combine_ways(both.value, w[1].value + 1, w[0].value, a, w[1].value, 3);
    for (int k = 0; k < 2; k++)
        combine_ways(both.normal[k], w[1].value + 1, w[0].normal[k], a, w[1].normal[k], 3);
    direction_of_rationals(across, both.normal[0], 3);
    int lies = directions_parallel(across, m->normal);
    if (lies) {
        const plane_ways *p = fmpq_is_zero(w[0].value + 1) ? &w[1] : &w[0];
        for (int i = 0; i < 2; i++) {
            value_on(linear + i, p->normal[0], m->basis[i]);
            fmpq_div(linear + i, linear + i, p->value + 1);
            fmpq_neg(linear + i, linear + i);
            value_on(linear + 2 + i, both.normal[1], m->basis[i]);
        }
        value_on(factor, both.normal[0], m->normal);
        fmpq_inv(factor, factor);
        fmpq_neg(factor, factor);
        add_product(form, factor, linear, linear + 2);
        fmpq_mul(factor, factor, both.value + 2);
        add_product(form, factor, linear, linear);
    }
    for (int i = 0; i < 4; i++)
        fmpq_clear(linear + i);
    fmpq_clear(a);
    fmpq_clear(factor);
    _fmpz_vec_clear(across, 3);
    ways_clear(&w[0]);
    ways_clear(&w[1]);
    ways_clear(&both);
    return lies;
}

/* The form of a germ if it has one. */
static int form_of_germ(fmpq *form, const second_maker *m, const germ *g) {
    int cell = cone_cell_dimension(&g->cone);
    size_t other = 1;
    fmpz *across = _fmpz_vec_init(3);
    int has = 0;
    if (g->root || !g->has_time)
        cell = 0;
    if (cell == 2) {
        for (int column = 0; column < 3; column++)
            for (int row = 0; row < 3; row++)
                fmpz_addmul(across + column, g->to_body + 3 * row + column, g->cone.normal + row);
        has = directions_parallel(across, m->normal);
        if (has)
            form_of_facet(form, m, g);
    }
    if (cell == 1 && g->side_count == 2 && g->side[0].order == 1) {
        while (directions_parallel(g->cone.normal, g->cone.normal + 3 * other))
            other++;
        has = form_of_edge(form, m, g, other);
    }
    _fmpz_vec_clear(across, 3);
    return has;
}

/* Keep what a germ covers below the plane (sign -1), or above it: at an edge, whose leading
 * direction lies in the plane, some direction on that side is in the cone's interior. */
static graze_status add_half(second_maker *m, germ *g, int sign) {
    graze_state state = GRAZE_STATE_O;
    fmpq form[3] = {{0, 1}, {0, 1}, {0, 1}};
    fmpz *u = _fmpz_vec_init(3);
    graze_status status = GRAZE_OK;
    for (int i = 0; i < 3; i++) {
        _fmpz_vec_dot(u + i, g->to_body + 3 * i, m->normal, 3);
        fmpz_mul_si(u + i, u + i, sign);
    }
    int has = form_of_germ(form, m, g), on_edge = has && cone_cell_dimension(&g->cone) == 1,
        covers = 0;
    if (on_edge)
        status = cone_meets_line(&covers, &g->cone, m->context, u, g->side[0].e);
    else if (has)
        status = cone_state(&state, &g->cone, m->context, u);
    covers = covers || state == GRAZE_STATE_I;
    if (!status && covers)
        status = array_grow(m->context, &m->item, &m->capacity, m->count + 1, sizeof *m->item,
                            "the contacts of a point");
    if (!status && covers) {
        half_germ *half = &m->item[m->count++];
        half->above = sign > 0;
        for (int i = 0; i < 3; i++) {
            fmpq_init(half->form + i);
            fmpq_swap(half->form + i, form + i);
        }
    }
    for (int i = 0; i < 3; i++)
        fmpq_clear(form + i);
    _fmpz_vec_clear(u, 3);
    return status;
}

/* The excess of a germ below over one above at a h + b k, as an integer polynomial: of b with a =
 * 1, or of a with b = 1. */
static void excess(fmpz_poly_t out, const half_germ *below, const half_germ *above, int swapped) {
    fmpq *difference = _fmpq_vec_init(3);
    fmpz *c = _fmpz_vec_init(4);
    for (int i = 0; i < 3; i++)
        fmpq_sub(difference + (swapped ? 2 - i : i), below->form + i, above->form + i);
    _fmpq_vec_get_fmpz_vec_fmpz(c, c + 3, difference, 3);
    fmpz_poly_zero(out);
    for (int i = 0; i < 3; i++)
        fmpz_poly_set_coeff_fmpz(out, i, c + i);
    _fmpq_vec_clear(difference, 3);
    _fmpz_vec_clear(c, 4);
}

/* The largest sign that an excess has at a number; -1 if there are none. */
static graze_status largest_sign_at(int *out, const second_maker *m, int swapped, algebraic *at) {
    graze_status status = GRAZE_OK;
    fmpz_poly_t p;
    fmpz_poly_init(p);
    *out = -1;
    for (size_t i = 0; i < m->count && !status && *out < 1; i++)
        for (size_t j = 0; j < m->count && !status && *out < 1; j++) {
            int sign = 0;
            if (m->item[i].above || !m->item[j].above)
                continue;
            excess(p, &m->item[i], &m->item[j], swapped);
            status = algebraic_sign_at(&sign, m->context, p, at);
            *out = FLINT_MAX(*out, sign);
        }
    fmpz_poly_clear(p);
    return status;
}

/* The direction h + s k, or s h + k. */
static void set_gap(const second_maker *m, int swapped, const fmpq_t s) {
    _fmpz_vec_scalar_mul_fmpz(m->gap, m->basis[swapped], 3, fmpq_denref(s));
    _fmpz_vec_scalar_addmul_fmpz(m->gap, m->basis[!swapped], 3, fmpq_numref(s));
}

/* Look at one number; between two roots a gap is kept. */
static graze_status look_at_slope(int *out, const second_maker *m, int swapped, algebraic *at,
                                  int between) {
    int sign = 0;
    graze_status status = largest_sign_at(&sign, m, swapped, at);
    if (!status && sign < 0 && between)
        set_gap(m, swapped, at->value);
    *out = *out && sign > 0;
    return status;
}

/* At the roots of all excesses in [-1, 1], at both ends, and between all of these. */
static graze_status look_at_slopes(int *out, const second_maker *m, int swapped,
                                   algebraic_list *roots) {
    algebraic last, next, middle;
    fmpq_t between;
    fmpq_init(between);
    algebraic_init(&last);
    algebraic_init(&next);
    algebraic_init(&middle);
    fmpq_set_si(between, -1, 1);
    algebraic_set_rational(&last, between);
    graze_status status = look_at_slope(out, m, swapped, &last, 0);
    for (size_t k = 0; k <= roots->count && !status; k++) {
        int order = 0;
        fmpq_one(between);
        if (k < roots->count)
            algebraic_set(&next, &roots->item[k]);
        else
            algebraic_set_rational(&next, between);
        status = algebraic_compare(&order, m->context, &last, &next);
        if (status || order == 0)
            continue;
        status = algebraic_between(between, m->context, &last, &next);
        algebraic_set_rational(&middle, between);
        if (!status)
            status = look_at_slope(out, m, swapped, &middle, 1);
        if (!status)
            status = look_at_slope(out, m, swapped, &next, 0);
        algebraic_set(&last, &next);
    }
    algebraic_clear(&last);
    algebraic_clear(&next);
    algebraic_clear(&middle);
    fmpq_clear(between);
    return status;
}

/* All directions of the plane that are nearer to one vector of its basis than to the other. */
static graze_status look_at_quarter(int *out, const second_maker *m, int swapped) {
    fmpz_poly_t p, product;
    dyadic_interval range;
    algebraic_list roots;
    fmpz_poly_init(p);
    fmpz_poly_init(product);
    fmpz_poly_set_ui(product, 1);
    dyadic_interval_init(&range);
    dyadic_interval_set_si(&range, -1, 1);
    algebraic_list_init(&roots);
    for (size_t i = 0; i < m->count; i++)
        for (size_t j = 0; j < m->count; j++) {
            if (m->item[i].above || !m->item[j].above)
                continue;
            excess(p, &m->item[i], &m->item[j], swapped);
            if (!fmpz_poly_is_zero(p))
                fmpz_poly_mul(product, product, p);
        }
    graze_status status = algebraic_roots(&roots, m->context, product, &range);
    if (!status)
        status = look_at_slopes(out, m, swapped, &roots);
    fmpz_poly_clear(p);
    fmpz_poly_clear(product);
    dyadic_interval_clear(&range);
    algebraic_list_clear(&roots);
    return status;
}

/* Two directions that span the plane across the normal. */
static void set_basis(second_maker *m) {
    int k = 0;
    fmpz *axis = _fmpz_vec_init(3);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 3; j++)
            fmpz_init(m->basis[i] + j);
    while (fmpz_is_zero(m->normal + k))
        k++;
    fmpz_one(axis + (k + 1) % 3);
    directions_cross(m->basis[0], m->normal, axis);
    directions_cross(m->basis[1], m->normal, m->basis[0]);
    _fmpz_vec_clear(axis, 3);
}

graze_status second_covers(int *out, fmpz *gap, germ_list *list, graze_context *context,
                           const fmpq *point, const fmpz *normal) {
    second_maker m = {.context = context, .point = point, .normal = normal, .gap = gap};
    graze_status status = GRAZE_OK;
    set_basis(&m);
    for (size_t k = 0; k < list->count && !status; k++)
        for (int sign = -1; sign < 2 && !status; sign += 2)
            status = add_half(&m, &list->item[k], sign);
    *out = 1;
    for (int swapped = 0; swapped < 2 && !status; swapped++)
        status = look_at_quarter(out, &m, swapped);
    *out = *out && !status;
    for (size_t k = 0; k < m.count; k++)
        for (int i = 0; i < 3; i++)
            fmpq_clear(m.item[k].form + i);
    free(m.item);
    for (int i = 0; i < 6; i++)
        fmpz_clear(m.basis[i / 3] + i % 3);
    return status;
}
