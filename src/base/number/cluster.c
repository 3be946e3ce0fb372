/* Isolates the roots in short intervals that hold several roots, or seem to: by Descartes' rule on
 * coefficients known to as few places as suffice, and by leaps to a short part about the middle of
 * a cluster. After a leap that succeeds the next one gains twice as many binary places, after one
 * that fails half as many (proofs/separation.md C41 to C43). The signs at the ends of an interval
 * are kept with it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/cluster.h"

#include <limits.h>
#include "base/context/scope.h"
#include "base/number/local.h"
#include "base/number/refine.h"

/* SHARPNESS: bits by which the largest coefficient exceeds the error, beyond those of the degree.
 * FIRST_PRECISION: binary places to begin with. LEAST_GAIN: gain of the least leap, to half the
 * width. */
enum { SHARPNESS = 8, FIRST_PRECISION = 32, LEAST_GAIN = 2 };

/* An open interval that is still to be searched, or, with width 0, a point that is a root. */
typedef struct pending {
    local_interval where;
    int low_sign, high_sign;
    ulong gain, precision;
} pending;

/* The polynomial carried to [0, 1], and a stack whose top is the leftmost interval. */
typedef struct cluster {
    const root_search *search;
    fmpz_poly_t unit;
    pending *stack;
    size_t count, capacity;
} cluster;

/* Set `out` to 2^(e n) p((low + (high - low) v) / 2^e), in powers of v. */
static void carry_to_unit(fmpz_poly_t out, const fmpz_poly_t p, const dyadic_interval *whole) {
    slong n = fmpz_poly_degree(p);
    LOCAL(fmpz, width);
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 1);
    fmpz_sub(width, whole->high, whole->low);
    fmpz_poly_set(out, p);
    for (slong i = 0; i <= n; i++)
        fmpz_mul_2exp(out->coeffs + i, out->coeffs + i, whole->exponent * (ulong)(n - i));
    fmpz_poly_taylor_shift(out, out, whole->low);
    for (slong i = 0; i <= n; i++) {
        fmpz_mul(out->coeffs + i, out->coeffs + i, power);
        fmpz_mul(power, power, width);
    }
}

/* Carry an interval from [0, 1] back to the polynomial's own variable. */
static void carry_back(dyadic_interval *out, const cluster *c, const local_interval *x) {
    const dyadic_interval *whole = c->search->whole;
    LOCAL(fmpz, width);
    LOCAL(fmpz, high);
    fmpz_sub(width, whole->high, whole->low);
    local_interval_high(high, x);
    fmpz_mul_2exp(out->low, whole->low, x->places);
    fmpz_set(out->high, out->low);
    fmpz_addmul(out->low, width, x->low);
    fmpz_addmul(out->high, width, high);
    out->exponent = whole->exponent + x->places;
}

/* Push an entry on the stack; the caller sets all its members. */
static pending *push_pending(cluster *c) {
    if (c->count == c->capacity) {
        size_t capacity = c->capacity ? 2 * c->capacity : 8;
        c->stack = flint_realloc(c->stack, capacity * sizeof *c->stack);
        for (size_t k = c->capacity; k < capacity; k++)
            local_interval_init(&c->stack[k].where);
        c->capacity = capacity;
    }
    return &c->stack[c->count++];
}

/* Compute the coefficients on an interval to the places at which the largest exceeds the error by
 * SHARPNESS bits and those of the degree. */
static graze_status sharp_form(local_form *form, const cluster *c, pending *at) {
    graze_status status;
    for (;; at->precision *= 2) {
        status = local_form_set(form, c->search->context, c->unit, &at->where, at->precision);
        if (status != GRAZE_OK ||
            local_form_is_sharp(form, SHARPNESS + FLINT_BIT_COUNT(form->degree)))
            return status;
    }
}

/* Whether the coefficients show that there is no root between low and high, integers in units of
 * 2^-places of `precise`. An empty interval has none. */
static graze_status has_no_root(int *none, local_form *form, const cluster *c, const fmpz_t low,
                                const fmpz_t high, int low_sign, int high_sign,
                                const pending *precise) {
    graze_status status = GRAZE_OK;
    *none = 1;
    HELD(local_interval, x);
    fmpz_set(x.low, low);
    fmpz_sub(x.width, high, low);
    x.places = precise->where.places;
    if (!fmpz_is_zero(x.width)) {
        status = local_form_set(form, c->search->context, c->unit, &x, precise->precision);
        *none = status == GRAZE_OK && local_form_variations(form, low_sign, high_sign) == 0;
    }
    return status;
}

/* Cut the interval into 2^gain equal parts and take the two beside the guessed middle of the
 * cluster, or, if the guess is an end of the interval, the one part there. */
static void guess_part(pending *part, const local_form *form, const pending *at, slong order) {
    LOCAL(fmpz, end);
    part->where.places = at->where.places + at->gain;
    local_form_center(part->where.low, form, order, at->gain);
    fmpz_add_ui(end, part->where.low, 1);
    if (fmpz_sgn(part->where.low) > 0)
        fmpz_sub_ui(part->where.low, part->where.low, 1);
    if (fmpz_bits(end) > at->gain && fmpz_val2(end) != at->gain)
        fmpz_sub_ui(end, end, 1);
    fmpz_sub(part->where.width, end, part->where.low);
    fmpz_mul(part->where.width, part->where.width, at->where.width);
    fmpz_mul(part->where.low, part->where.low, at->where.width);
    fmpz_mul_2exp(end, at->where.low, at->gain);
    fmpz_add(part->where.low, part->where.low, end);
}

/* Whether all roots in the interval lie in the part, and no end of the part is a root unless it is
 * an end of the interval. Sets the signs at the part's ends. */
static graze_status part_has_all(int *all, local_form *form, const cluster *c, pending *part,
                                 const pending *at) {
    graze_status status = GRAZE_OK;
    LOCAL(fmpz, low);
    LOCAL(fmpz, high);
    LOCAL(fmpz, part_high);
    fmpz_mul_2exp(low, at->where.low, at->gain);
    local_interval_high(high, &at->where);
    fmpz_mul_2exp(high, high, at->gain);
    local_interval_high(part_high, &part->where);
    int own_low = fmpz_equal(low, part->where.low), own_high = fmpz_equal(high, part_high);
    part->low_sign =
        own_low ? at->low_sign : dyadic_sign(c->unit, part->where.low, part->where.places);
    part->high_sign =
        own_high ? at->high_sign : dyadic_sign(c->unit, part_high, part->where.places);
    *all = (own_low || part->low_sign != 0) && (own_high || part->high_sign != 0);
    if (*all)
        status =
            has_no_root(all, form, c, low, part->where.low, at->low_sign, part->low_sign, part);
    if (*all)
        status = has_no_root(all, form, c, part_high, high, part->high_sign, at->high_sign, part);
    return status;
}

/* Try to replace the interval by a part that has all its roots. A cluster of v roots, two of them
 * perhaps ends of the interval, has its middle near the one root of the derivative of order v - 1.
 * Near this middle p is about 2^(v gain) times smaller, so that v gain more places are needed. */
static graze_status leap(int *done, const cluster *c, pending *at, slong variations) {
    slong n = fmpz_poly_degree(c->unit);
    slong v = variations + (at->low_sign == 0) + (at->high_sign == 0);
    v = FLINT_MIN(v, n);
    pending part = {.gain = 2 * at->gain};
    HELD(local_form, form, n);
    local_interval_init(&part.where);
    part.precision =
        at->precision + (ulong)v * (at->gain + FLINT_BIT_COUNT(n) + 2) + at->gain + SHARPNESS;
    graze_status status =
        local_form_set(&form, c->search->context, c->unit, &at->where, part.precision);
    *done = 0;
    if (status == GRAZE_OK) {
        guess_part(&part, &form, at, v - 1);
        status = part_has_all(done, &form, c, &part, at);
    }
    if (*done) {
        local_interval_set(&at->where, &part.where);
        at->low_sign = part.low_sign;
        at->high_sign = part.high_sign;
        at->precision = part.precision;
    }
    at->gain = *done ? 2 * at->gain : FLINT_MAX(at->gain / 2, LEAST_GAIN);
    local_interval_clear(&part.where);
    return status;
}

/* Replace the interval on top of the stack by its halves and, if it is a root, the point between
 * them.
 */
static void halve_pending(cluster *c) {
    pending *top = &c->stack[c->count - 1];
    LOCAL(fmpz, middle);
    fmpz_mul_2exp(top->where.low, top->where.low, 1);
    top->where.places++;
    fmpz_add(middle, top->where.low, top->where.width);
    int sign = dyadic_sign(c->unit, middle, top->where.places), low_sign = top->low_sign;
    size_t right = c->count - 1;
    for (int k = 0; k < 1 + (sign == 0); k++) {
        pending *added = push_pending(c);
        const pending *from = &c->stack[right];
        local_interval_set(&added->where, &from->where);
        added->gain = from->gain;
        added->precision = from->precision;
        added->low_sign = low_sign;
        added->high_sign = sign;
    }
    fmpz_set(c->stack[right].where.low, middle);
    c->stack[right].low_sign = sign;
    if (sign == 0) {
        fmpz_set(c->stack[right + 1].where.low, middle);
        fmpz_zero(c->stack[right + 1].where.width);
    }
}

/* Binary places that the ends of intervals may have beyond those of the whole one. */
static ulong places_allowed(const cluster *c) {
    const graze_context *context = c->search->context;
    ulong most = context ? context->limits[GRAZE_LIMIT_BITS] : ULONG_MAX / 4;
    return most > c->search->whole->exponent ? most - c->search->whole->exponent : 0;
}

/* Shorten or halve the interval on top of the stack, in which there may be roots. */
static graze_status search_further(cluster *c, slong variations) {
    pending *top = &c->stack[c->count - 1];
    ulong places = top->where.places, allowed = places_allowed(c);
    int done = 0;
    if (places >= allowed)
        return algebraic_bits_limit(c->search->context);
    while (top->gain > LEAST_GAIN && top->gain > allowed - places)
        top->gain /= 2;
    if (top->gain <= allowed - places)
        TRY(leap(&done, c, top, variations));
    if (!done)
        halve_pending(c);
    return GRAZE_OK;
}

/* Append the root of the interval on top of the stack and pop it, or search it further. */
static graze_status step(cluster *c, local_form *form) {
    pending *top = &c->stack[c->count - 1];
    slong variations = 0;
    int is_point = fmpz_is_zero(top->where.width), known;
    if (!is_point) {
        TRY(sharp_form(form, c, top));
        variations = local_form_variations(form, top->low_sign, top->high_sign);
    }
    known = variations == 0 || (variations == 1 && top->low_sign && top->high_sign);
    if (!known)
        return search_further(c, variations);
    HELD(dyadic_interval, found);
    carry_back(&found, c, &top->where);
    if (is_point)
        algebraic_set_dyadic(algebraic_list_append(c->search->list), found.low, found.exponent);
    else if (variations == 1)
        root_search_append(c->search, &found, top->low_sign);
    c->count--;
    return GRAZE_OK;
}

/* Push the first interval, one of 2^places equal parts of the whole one. */
static void push_first(cluster *c, const dyadic_interval *interval, int low_sign, int high_sign) {
    const dyadic_interval *whole = c->search->whole;
    pending *first = push_pending(c);
    LOCAL(fmpz, width);
    fmpz_sub(width, whole->high, whole->low);
    first->where.places = interval->exponent - whole->exponent;
    fmpz_mul_2exp(first->where.low, whole->low, first->where.places);
    fmpz_sub(first->where.low, interval->low, first->where.low);
    fmpz_divexact(first->where.low, first->where.low, width);
    fmpz_one(first->where.width);
    first->low_sign = low_sign;
    first->high_sign = high_sign;
    first->gain = LEAST_GAIN;
    first->precision = FIRST_PRECISION;
}

void root_search_append(const root_search *s, const dyadic_interval *interval, int low_sign) {
    algebraic *x = algebraic_list_append(s->list);
    fmpz_poly_set(x->poly, s->poly);
    dyadic_interval_set(&x->where, interval);
    x->low_sign = low_sign;
}

graze_status root_search_cluster(const root_search *s, const dyadic_interval *interval,
                                 int low_sign, int high_sign) {
    cluster c = {.search = s};
    graze_status status = GRAZE_OK;
    fmpz_poly_init(c.unit);
    HELD(local_form, form, fmpz_poly_degree(s->poly));
    carry_to_unit(c.unit, s->poly, s->whole);
    push_first(&c, interval, low_sign, high_sign);
    while (c.count > 0 && status == GRAZE_OK)
        status = step(&c, &form);
    for (size_t k = 0; k < c.capacity; k++)
        local_interval_clear(&c.stack[k].where);
    flint_free(c.stack);
    fmpz_poly_clear(c.unit);
    return status;
}
