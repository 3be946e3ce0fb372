/* Heights between leading terms. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * At x the heights are Q(x)^(1/m) |x|^(1 + 1/m), so those of a larger m are the larger ones.
 * Between 0 and them there may be room, or both sides are of smaller orders.
 */
#include "topo/gap.h"

#include <flint/fmpz_vec.h>

void gap_init(plane_gap *gap) {
    fmpq_init(&gap->lift);
    for (int k = 0; k < 3; k++)
        fmpz_init(gap->along + k);
    gap->order = 0;
}

void gap_clear(plane_gap *gap) {
    fmpq_clear(&gap->lift);
    for (int k = 0; k < 3; k++)
        fmpz_clear(gap->along + k);
}

/* A form of degree m + 1 at den h + num k, for b = num / den, or at num h + den k. */
static void height_at(fmpq_t out, const half_germ *g, int swapped, const fmpq_t b) {
    fmpq_poly_t form;
    fmpq_t scale;
    fmpq_init(scale);
    fmpq_poly_init(form);
    fmpq_poly_set(form, g->form);
    if (swapped)
        fmpq_poly_reverse(form, form, g->order + 2);
    fmpq_poly_evaluate_fmpq(out, form, b);
    fmpz_set(fmpq_numref(scale), fmpq_denref(b));
    fmpq_pow_si(scale, scale, g->order + 1);
    fmpq_mul(out, out, scale);
    fmpq_poly_clear(form);
    fmpq_clear(scale);
}

/* Heights at one order, to its power: the largest below and the least above, as far as there are
 * any. Those of smaller orders are 0 here, those of larger ones far away. */
typedef struct height_range {
    int has_low, has_high;
    fmpq_t low, high;
} height_range;

static void take_height(height_range *r, int above, const fmpq_t height) {
    int *has = above ? &r->has_high : &r->has_low;
    fmpq *kept = above ? r->high : r->low;
    if (!*has || fmpq_cmp(height, kept) * (above ? -1 : 1) > 0)
        fmpq_set(kept, height);
    *has = 1;
}

static void find_range(height_range *r, slong order, const half_germ *item, size_t count,
                       int swapped, const fmpq_t b) {
    fmpq_t height;
    fmpq_init(height);
    r->has_low = r->has_high = 0;
    for (size_t k = 0; k < count; k++) {
        if (item[k].order > order)
            continue;
        fmpq_zero(height);
        if (item[k].order == order)
            height_at(height, &item[k], swapped, b);
        take_height(r, item[k].above, height);
    }
    fmpq_clear(height);
}

/* With one end alone, a range of the length of that, or of 1. */
static void close_range(height_range *r) {
    fmpq_t length;
    fmpq_init(length);
    fmpq_abs(length, r->has_low ? r->low : r->high);
    if (!r->has_low || !r->has_high)
        fmpq_add_si(length, length, 1);
    if (!r->has_low && r->has_high)
        fmpq_sub(r->low, r->high, length);
    else if (!r->has_high)
        fmpq_add(r->high, r->low, length);
    fmpq_clear(length);
}

/* Is a height with its power between two numbers found, k / 2^places with an integer k? */
static int find_dyadic(fmpq_t out, slong order, const fmpq_t low, const fmpq_t high, ulong places) {
    int found = 0;
    fmpz_t root;
    fmpq_t power;
    fmpz_init(root);
    fmpq_init(power);
    fmpq_mul_2exp(power, low, places * (ulong)order);
    fmpz_tdiv_q(root, fmpq_numref(power), fmpq_denref(power));
    fmpz_root(root, root, order);
    fmpz_sub_ui(root, root, 2);
    for (int k = 0; k < 5 && !found; k++) {
        fmpz_add_ui(root, root, 1);
        fmpq_set_fmpz(out, root);
        fmpq_div_2exp(out, out, places);
        fmpq_pow_si(power, out, order);
        found = fmpq_cmp(low, power) < 0 && fmpq_cmp(power, high) < 0;
    }
    fmpz_clear(root);
    fmpq_clear(power);
    return found;
}

/* In the middle half of the range. */
static void set_lift(fmpq_t out, slong order, height_range *r) {
    ulong places = 0;
    fmpq_t quarter;
    fmpq_init(quarter);
    fmpq_sub(quarter, r->high, r->low);
    fmpq_div_2exp(quarter, quarter, 2);
    fmpq_add(r->low, r->low, quarter);
    fmpq_sub(r->high, r->high, quarter);
    while (!find_dyadic(out, order, r->low, r->high, places))
        places++;
    fmpq_clear(quarter);
}

/* The largest order below a bound, or 0. */
static slong next_order(const half_germ *item, size_t count, slong bound) {
    slong order = 0;
    for (size_t k = 0; k < count; k++)
        if (item[k].order < bound)
            order = FLINT_MAX(order, item[k].order);
    return order;
}

void gap_set(plane_gap *gap, const open_plane *h, const half_germ *item, size_t count, int swapped,
             const fmpq_t b) {
    height_range r;
    fmpq_init(r.low);
    fmpq_init(r.high);
    _fmpz_vec_scalar_mul_fmpz(gap->along, h->basis[swapped], 3, fmpq_denref(b));
    _fmpz_vec_scalar_addmul_fmpz(gap->along, h->basis[!swapped], 3, fmpq_numref(b));
    gap->order = next_order(item, count, WORD_MAX);
    for (slong order = gap->order; order > 0; order = next_order(item, count, order)) {
        gap->order = order;
        find_range(&r, order, item, count, swapped, b);
        close_range(&r);
        if (fmpq_cmp(r.low, r.high) < 0)
            break;
        gap->order = 0;
    }
    if (gap->order)
        set_lift(&gap->lift, gap->order, &r);
    fmpq_clear(r.low);
    fmpq_clear(r.high);
}
