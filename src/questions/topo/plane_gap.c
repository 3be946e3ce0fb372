/* Forms of half germs in the charts of a plane's directions, and heights between leading terms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * At x the leading terms have the height Q(x)^(1/m), of order 1 + 1/m in |x|, so a term with a
 * larger m is the larger one. A gap of order m lies between terms of order m; terms of smaller
 * orders count as 0.
 */
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "base/number/sign.h"
#include "questions/topo/cover.h"

void half_germ_init(half_germ *half) {
    fmpq_poly_init(half->form);
    fmpq_poly_init(half->reach);
    fmpq_poly_init(half->turn);
    half->has_reach = half->has_turn = 0;
}

void half_germ_clear(half_germ *half) {
    fmpq_poly_clear(half->form);
    fmpq_poly_clear(half->reach);
    fmpq_poly_clear(half->turn);
}

void half_in_chart(fmpz_poly_t out, const fmpq_poly_t form, slong degree, direction_chart chart) {
    LOCAL(fmpq_poly, p);
    fmpq_poly_set(p, form);
    if (chart.swapped)
        fmpq_poly_reverse(p, p, degree + 1);
    fmpq_poly_get_numerator(out, p);
    if (chart.opposite && degree % 2 == 1)
        fmpz_poly_neg(out, out);
}

graze_status half_is_valid(int *out, const half_germ *half, graze_context *context,
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
    for (int k = 0; k < 3; k++)
        fmpz_clear(gap->along + k);
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

graze_status gap_set(plane_gap *gap, const open_plane *h, graze_context *context,
                     const half_germ *item, size_t count, direction_chart chart, const fmpq_t b) {
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
