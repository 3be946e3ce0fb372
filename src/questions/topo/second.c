/* Do the halves of germs below and above a plane cover all of its directions?
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Write a place near the point as x + z N, with x in the plane across N. A half germ of order m
 * with the form Q covers z < Q(x)^(1/m) below the plane, z > Q(x)^(1/m) above it, up to smaller
 * terms (cover.h). The plane's directions are covered if at each x the leading term of some germ
 * below exceeds the leading term of some germ above.
 *
 * At x the leading terms have the height Q(x)^(1/m), of order 1 + 1/m in |x|, so a term with a
 * larger m is the larger one. A gap of order m lies between terms of order m; terms of smaller
 * orders count as 0.
 */
#include "questions/topo/near.h"

#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/isolate.h"

/* A chart of the directions of the plane with the basis h, k: the parameter b in [-1, 1] stands
 * for h + b k, with `swapped` for b h + k; with `opposite` for the negative of these. Four charts
 * cover the plane's directions. */
typedef struct direction_chart {
    int swapped, opposite;
} direction_chart;

static void half_germ_init(half_germ *half) {
    fmpq_poly_init(half->form);
    fmpq_poly_init(half->reach);
    fmpq_poly_init(half->turn);
    half->has_reach = half->has_turn = 0;
}

static void half_germ_clear(half_germ *half) {
    fmpq_poly_clear(half->form);
    fmpq_poly_clear(half->reach);
    fmpq_poly_clear(half->turn);
}

/* Write a form of this degree, at h + b k, in a chart, as a polynomial in b times a positive
 * number.
 */
static void half_in_chart(fmpz_poly_t out, const fmpq_poly_t form, slong degree,
                          direction_chart chart) {
    LOCAL(fmpq_poly, p);
    fmpq_poly_set(p, form);
    if (chart.swapped)
        fmpq_poly_reverse(p, p, degree + 1);
    fmpq_poly_get_numerator(out, p);
    if (chart.opposite && degree % 2 == 1)
        fmpz_poly_neg(out, out);
}

/* Is the germ's form valid at a parameter of the chart? */
static graze_status half_is_valid(int *out, const half_germ *half, graze_context *context,
                                  direction_chart chart, algebraic *at) {
    int sign = 0;
    LOCAL(fmpz_poly, p);
    *out = 1;
    if (half->has_reach) {
        half_in_chart(p, half->reach, 1, chart);
        TRY(algebraic_sign_at(&sign, context, p, at));
        *out = sign > 0;
    }
    if (half->has_turn && *out) {
        half_in_chart(p, half->turn, 1, chart);
        TRY(algebraic_sign_at(&sign, context, p, at));
        *out = sign >= 0;
    }
    return GRAZE_OK;
}

void plane_gap_init(plane_gap *gap) {
    *gap = (plane_gap){.lift = {0, 1}};
}

void plane_gap_clear(plane_gap *gap) {
    fmpq_clear(&gap->lift);
    _fmpz_vec_zero(gap->along, 3);
}

/* Evaluate the form of a germ at the direction of the gap. */
static void height_at(fmpq_t out, const half_germ *g, direction_chart chart, const fmpq_t b) {
    LOCAL(fmpq, scale);
    LOCAL(fmpq_poly, form);
    fmpq_poly_set(form, g->form);
    if (chart.swapped)
        fmpq_poly_reverse(form, form, g->order + 2);
    fmpq_poly_evaluate_fmpq(out, form, b);
    fmpz_set(fmpq_numref(scale), fmpq_denref(b));
    fmpq_pow_si(scale, scale, g->order + 1);
    fmpq_mul(out, out, scale);
    if (chart.opposite && g->order % 2 == 0)
        fmpq_neg(out, out);
}

/* The m-th powers of the leading terms in one direction: the largest of the germs below the plane
 * and the least of those above, if there are any. Germs of smaller orders count as 0, germs of
 * larger orders are left out. */
typedef struct height_range {
    int has_low, has_high;
    fmpq *low, *high;
} height_range;

static void take_height(height_range *r, int above, const fmpq_t height) {
    int *has = above ? &r->has_high : &r->has_low;
    fmpq *kept = above ? r->high : r->low;
    if (!*has || fmpq_cmp(height, kept) * (above ? -1 : 1) > 0)
        fmpq_set(kept, height);
    *has = 1;
}

static graze_status find_range(height_range *r, graze_context *context, slong order,
                               const half_germ *item, size_t count, direction_chart chart,
                               const fmpq_t b) {
    LOCAL(fmpq, height);
    HELD(algebraic, at);
    algebraic_set_rational(&at, b);
    r->has_low = r->has_high = 0;
    for (size_t k = 0; k < count; k++) {
        int valid = 0;
        if (item[k].order <= order)
            TRY(half_is_valid(&valid, &item[k], context, chart, &at));
        if (!valid)
            continue;
        fmpq_zero(height);
        if (item[k].order == order)
            height_at(height, &item[k], chart, b);
        take_height(r, item[k].above, height);
    }
    return GRAZE_OK;
}

/* Complete a range that lacks an end: the range gets the length 1 plus the absolute value of its
 * other end; without any end it becomes [0, 1]. */
static void close_range(height_range *r) {
    LOCAL(fmpq, length);
    if (!r->has_low && !r->has_high)
        fmpq_zero(r->low);
    fmpq_abs(length, r->has_high ? r->high : r->low);
    fmpq_add_si(length, length, 1);
    if (!r->has_high)
        fmpq_add(r->high, r->low, length);
    else if (!r->has_low)
        fmpq_sub(r->low, r->high, length);
}

/* Find a dyadic number k / 2^places whose signed power of this order lies between two numbers;
 * returns 0 if there is none. */
static int find_dyadic(fmpq_t out, slong order, const fmpq_t low, const fmpq_t high, ulong places) {
    int found = 0;
    LOCAL(fmpz, root);
    LOCAL(fmpq, power);
    fmpq_mul_2exp(power, low, places * (ulong)order);
    fmpz_tdiv_q(root, fmpq_numref(power), fmpq_denref(power));
    fmpz_abs(root, root);
    fmpz_root(root, root, order);
    if (fmpq_sgn(low) < 0)
        fmpz_neg(root, root);
    fmpz_sub_ui(root, root, 2);
    for (int k = 0; k < 5 && !found; k++) {
        fmpz_add_ui(root, root, 1);
        fmpq_set_fmpz(out, root);
        fmpq_div_2exp(out, out, places);
        signed_power(power, out, order);
        found = fmpq_cmp(low, power) < 0 && fmpq_cmp(power, high) < 0;
    }
    return found;
}

/* Set the lift so that its signed power lies in the middle half of the range. */
static void set_lift(fmpq_t out, slong order, height_range *r) {
    ulong places = 0;
    LOCAL(fmpq, quarter);
    fmpq_sub(quarter, r->high, r->low);
    fmpq_div_2exp(quarter, quarter, 2);
    fmpq_add(r->low, r->low, quarter);
    fmpq_sub(r->high, r->high, quarter);
    while (!find_dyadic(out, order, r->low, r->high, places))
        places++;
}

/* The largest order of a germ that is less than a bound; 0 if there is none. */
static slong next_order(const half_germ *item, size_t count, slong bound) {
    slong order = 0;
    for (size_t k = 0; k < count; k++)
        if (item[k].order < bound)
            order = FLINT_MAX(order, item[k].order);
    return order;
}

/* Set a gap in the direction that b is in the chart; `along` is that direction times b's
 * denominator. The order is 0 if the leading terms leave no room. The valid leading terms of the
 * germs are consistent: each `above` term is at least each `below` term. */
static graze_status gap_set(plane_gap *gap, const open_plane *h, graze_context *context,
                            const half_germ *item, size_t count, direction_chart chart,
                            const fmpq_t b) {
    LOCAL_VEC(fmpq, ends, 2);
    height_range r = {.low = ends, .high = ends + 1};
    _fmpz_vec_scalar_mul_fmpz(gap->along, h->basis[chart.swapped], 3, fmpq_denref(b));
    _fmpz_vec_scalar_addmul_fmpz(gap->along, h->basis[!chart.swapped], 3, fmpq_numref(b));
    if (chart.opposite)
        _fmpz_vec_neg(gap->along, gap->along, 3);
    gap->order = 0;
    slong order = FLINT_MAX(next_order(item, count, WORD_MAX), 1);
    for (; order > 0 && !gap->order; order = next_order(item, count, order)) {
        TRY(find_range(&r, context, order, item, count, chart, b));
        close_range(&r);
        if (fmpq_cmp(r.low, r.high) < 0)
            gap->order = order;
    }
    if (gap->order)
        set_lift(&gap->lift, gap->order, &r);
    return GRAZE_OK;
}

typedef struct second_maker {
    graze_context *context;
    open_plane plane;
    plane_gap *gap;
    direction_chart chart; /* the current one */
    size_t count, capacity;
    half_germ *item;
} second_maker;

static void second_maker_clear(second_maker *m) {
    for (size_t k = 0; k < m->count; k++)
        half_germ_clear(&m->item[k]);
    free(m->item);
}

/* Append the half of a germ below the plane (sign -1) or above the plane (sign 1), if this way
 * proves a cover.
 */
static graze_status add_half(second_maker *m, germ *g, int sign, int way) {
    int covers = 0;
    TRY(LIST_GROW(m->context, m, "the contacts of a point"));
    half_germ *half = &m->item[m->count++];
    half_germ_init(half);
    TRY(half_of_germ(&covers, half, &m->plane, m->context, g, sign, way));
    if (!covers)
        half_germ_clear(&m->item[--m->count]);
    return GRAZE_OK;
}

/* A polynomial in the chart's parameter with the sign of the leading term of `below` minus that of
 * `above`: the form of the larger order, or the difference of forms of equal order. */
static void excess(fmpz_poly_t out, const half_germ *below, const half_germ *above,
                   direction_chart chart) {
    slong order = FLINT_MAX(below->order, above->order);
    LOCAL(fmpq_poly, difference);
    if (below->order == order)
        fmpq_poly_set(difference, below->form);
    if (above->order == order)
        fmpq_poly_sub(difference, difference, above->form);
    half_in_chart(out, difference, order + 1, chart);
}

/* The sign of the excess of germ i over germ j at a parameter; -1 if one of them is not valid
 * there. */
static graze_status excess_at(int *out, const second_maker *m, size_t i, size_t j, algebraic *at) {
    int valid[2] = {1, 1};
    *out = -1;
    TRY(half_is_valid(&valid[0], &m->item[i], m->context, m->chart, at));
    if (valid[0])
        TRY(half_is_valid(&valid[1], &m->item[j], m->context, m->chart, at));
    if (!valid[0] || !valid[1])
        return GRAZE_OK;
    LOCAL(fmpz_poly, p);
    excess(p, &m->item[i], &m->item[j], m->chart);
    return algebraic_sign_at(out, m->context, p, at);
}

/* The largest sign of all excesses at a parameter; -1 if there are none. */
static graze_status largest_sign_at(int *out, const second_maker *m, algebraic *at) {
    *out = -1;
    for (size_t i = 0; i < m->count && *out < 1; i++)
        for (size_t j = 0; j < m->count && *out < 1; j++) {
            int sign = -1;
            if (!m->item[i].above && m->item[j].above)
                TRY(excess_at(&sign, m, i, j, at));
            *out = FLINT_MAX(*out, sign);
        }
    return GRAZE_OK;
}

/* Clear `*out` unless the largest sign of the excesses at a parameter, `*sign`, is positive. */
static graze_status look_at_slope(int *out, int *sign, const second_maker *m, algebraic *at) {
    TRY(largest_sign_at(sign, m, at));
    *out = *out && *sign > 0;
    return GRAZE_OK;
}

/* Look at a parameter at which a sign may change. A gap may lie in this parameter's direction
 * alone, so a rational parameter is tried for the gap, although equal leading terms need not leave
 * one. */
static graze_status look_at_end(int *out, const second_maker *m, algebraic *at) {
    int sign = 0;
    TRY(look_at_slope(out, &sign, m, at));
    if (sign <= 0 && !m->gap->order && algebraic_is_rational(at))
        TRY(gap_set(m->gap, &m->plane, m->context, m->item, m->count, m->chart, at->value));
    return GRAZE_OK;
}

/* Set the gap at a parameter between two, a third of the way from `low` to a simple number: a
 * direction with larger numbers is seldom parallel to facets and edges. */
static graze_status keep_gap(const second_maker *m, const fmpq_t low, algebraic *high) {
    LOCAL(fmpq, b);
    HELD(algebraic, first);
    algebraic_set_rational(&first, low);
    TRY(algebraic_between(b, m->context, &first, high));
    fmpq_sub(b, b, low);
    fmpq_div_fmpz(b, b, &(fmpz){3});
    fmpq_add(b, b, low);
    return gap_set(m->gap, &m->plane, m->context, m->item, m->count, m->chart, b);
}

/* Look between two successive parameters, and at the second one. */
static graze_status look_from_to(int *out, const second_maker *m, algebraic *from, algebraic *to) {
    int sign = 0;
    HELD(algebraic, middle);
    TRY(algebraic_between(middle.value, m->context, from, to));
    TRY(look_at_slope(out, &sign, m, &middle));
    if (sign < 0 || (sign == 0 && !m->gap->order))
        TRY(keep_gap(m, middle.value, to));
    return look_at_end(out, m, to);
}

/* Look at the roots of all excesses in [-1, 1], at both ends, and between each two successive ones.
 */
static graze_status look_at_slopes(int *out, const second_maker *m, algebraic_list *roots) {
    int order = 0;
    HELD(algebraic, last);
    HELD(algebraic, next);
    algebraic_set_dyadic(&last, &(fmpz){-1}, 0);
    TRY(look_at_end(out, m, &last));
    for (size_t k = 0; k <= roots->count; k++) {
        if (k < roots->count)
            algebraic_set(&next, &roots->item[k]);
        else
            algebraic_set_dyadic(&next, &(fmpz){1}, 0);
        TRY(algebraic_compare(&order, m->context, &last, &next));
        if (order == 0)
            continue;
        TRY(look_from_to(out, m, &last, &next));
        algebraic_set(&last, &next);
    }
    return GRAZE_OK;
}

/* Multiply the product by a polynomial unless that is 0. */
static void add_factor(fmpz_poly_t product, const fmpz_poly_t p) {
    if (!fmpz_poly_is_zero(p))
        fmpz_poly_mul(product, product, p);
}

/* The product of all excesses in the chart and of all forms `reach` and `turn`: between its roots
 * no excess changes sign and no germ becomes valid or invalid. */
static void product_of_signs(fmpz_poly_t product, const second_maker *m) {
    LOCAL(fmpz_poly, p);
    fmpz_poly_set_ui(product, 1);
    for (size_t i = 0; i < m->count; i++) {
        const half_germ *half = &m->item[i];
        for (size_t j = 0; j < m->count; j++) {
            if (half->above || !m->item[j].above)
                continue;
            excess(p, half, &m->item[j], m->chart);
            add_factor(product, p);
        }
        half_in_chart(p, half->reach, 1, m->chart);
        if (half->has_reach)
            add_factor(product, p);
        half_in_chart(p, half->turn, 1, m->chart);
        if (half->has_turn)
            add_factor(product, p);
    }
}

/* Look at all directions of the current chart. */
static graze_status look_at_chart(int *out, const second_maker *m) {
    LOCAL(fmpz_poly, product);
    HELD(dyadic_interval, range);
    dyadic_interval_set_si(&range, -1, 1);
    HELD(algebraic_list, roots);
    product_of_signs(product, m);
    TRY(algebraic_roots(&roots, m->context, product, &range));
    return look_at_slopes(out, m, &roots);
}

graze_status second_covers(int *out, plane_gap *gap, germ_list *list, graze_context *context,
                           const fmpq *point, const fmpz *normal) {
    LOCAL_VEC(fmpz, basis, 6);
    ZEROED(second_maker, m);
    m.context = context;
    m.plane = (open_plane){point, normal, {basis, basis + 3}};
    m.gap = gap;
    directions_basis(basis, basis + 3, normal);
    for (size_t k = 0; k < list->count; k++)
        for (int how = 0; how < 2 * HALF_WAYS; how++)
            TRY(add_half(&m, &list->item[k], how % 2 ? 1 : -1, how / 2));
    *out = 1;
    for (int k = 0; k < 4; k++) {
        m.chart = (direction_chart){k % 2, k / 2};
        TRY(look_at_chart(out, &m));
    }
    return GRAZE_OK;
}
