/* Isolates the roots in short intervals that hold several roots, or seem to: by Descartes' rule on
 * Bernstein coefficients known to as few places as suffice (from Taylor coefficients at the lower
 * end by repeated division, rounded down at every step), and by leaps to a short part about the
 * middle of a cluster. After a leap that succeeds the next one gains twice as many binary places,
 * after one that fails half as many (proofs/separation.md C41 to C43). The signs at the ends of an
 * interval are kept with it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/number/cluster.h"

#include <limits.h>
#include "base/context/scope.h"
#include "base/number/bernstein.h"

/* SHARPNESS: bits by which the largest coefficient exceeds the error, beyond those of the degree.
 * FIRST_PRECISION: binary places to begin with. LEAST_GAIN: gain of the least leap, to half the
 * width. */
enum { SHARPNESS = 8, FIRST_PRECISION = 32, LEAST_GAIN = 2 };

/* An open interval of [0, 1] that is still to be searched, or, with width 0, a point that is a
 * root. For degree n the width is at most 1 / (2 (n + 1)). */
typedef struct pending {
    dyadic_interval where;
    int low_sign, high_sign;
    ulong gain, precision;
} pending;

/* b[0] ... b[degree], each within `error` of one positive number times a Bernstein coefficient. */
typedef struct local_form {
    slong degree;
    fmpz *b;
    fmpz_t error;
} local_form;

static void local_form_init(local_form *form, slong degree) {
    form->degree = degree;
    form->b = _fmpz_vec_init(degree + 1);
    fmpz_init(form->error);
}

static void local_form_clear(local_form *form) {
    _fmpz_vec_clear(form->b, form->degree + 1);
    fmpz_clear(form->error);
}

/* The index of the last Taylor coefficient that matters: the terms behind it add up to less than
 * one unit of the precision (C41). */
static slong last_term(const fmpz_poly_t q, const dyadic_interval *x, ulong precision) {
    LOCAL(fmpz, width);
    fmpz_sub(width, x->high, x->low);
    ulong narrow = x->exponent - fmpz_bits(width); /* the width is less than 2^-narrow */
    slong n = fmpz_poly_degree(q);
    ulong size = (ulong)FLINT_ABS(fmpz_poly_max_bits(q)) + FLINT_BIT_COUNT(n + 1);
    ulong step = narrow - FLINT_BIT_COUNT(n), terms = (precision + size + 1) / step + 1;
    return terms < (ulong)n ? (slong)terms : n;
}

/* s[0] ... s[last] become 2^precision times Taylor coefficients at the lower end: in round k, s[n]
 * ... s[k] are the values of Horner's scheme for the quotient that round k - 1 has left. */
static graze_status taylor(fmpz *s, graze_context *context, slong n, slong last,
                           const dyadic_interval *x) {
    LOCAL(fmpz, product);
    for (slong k = 0; k <= last; k++)
        for (slong i = n - 1; i >= k; i--) {
            fmpz_mul(product, s + i + 1, x->low);
            TRY(context_work(context, fmpz_size(product) * (fmpz_size(x->low) + 1)));
            fmpz_fdiv_q_2exp(product, product, x->exponent);
            fmpz_add(s + i, s + i, product);
        }
    return GRAZE_OK;
}

/* s[i] becomes the i-th difference of the first i + 1 Bernstein coefficients, which all get the
 * factor `common`. */
static void take_differences(fmpz *s, slong n, slong last, const dyadic_interval *x,
                             const fmpz_t common) {
    LOCAL(fmpz, width);
    fmpz_sub(width, x->high, x->low);
    LOCAL(fmpz, power);
    fmpz_set_ui(power, 1);
    LOCAL(fmpz, binomial);
    fmpz_set_ui(binomial, 1);
    LOCAL(fmpz, factor);
    for (slong i = 0; i <= last; i++) {
        fmpz_mul(s + i, s + i, power);
        fmpz_fdiv_q_2exp(s + i, s + i, x->exponent * (ulong)i);
        fmpz_divexact(factor, common, binomial);
        fmpz_mul(s + i, s + i, factor);
        fmpz_mul(power, power, width);
        fmpz_mul_ui(binomial, binomial, (ulong)(n - i));
        fmpz_divexact_ui(binomial, binomial, (ulong)(i + 1));
    }
}

/* Set a form to the coefficients on an interval of q, which has the form's degree, multiplied by at
 * least 2^precision; `error` depends on the degree alone. By C41 rounding costs 2 (n + 1) units in
 * the Taylor coefficients and at most n + 1 with the powers of the width, and the terms left out
 * cost one. */
static graze_status local_form_set(local_form *form, graze_context *context, const fmpz_poly_t q,
                                   const dyadic_interval *x, ulong precision) {
    slong n = form->degree;
    slong last = last_term(q, x, precision);
    LOCAL_VEC(fmpz, s, n + 1);
    LOCAL(fmpz, common);
    _fmpz_vec_scalar_mul_2exp(s, q->coeffs, n + 1, precision);
    TRY(taylor(s, context, n, last, x));
    common_binomial(common, n);
    take_differences(s, n, last, x, common);
    for (slong j = 0; j <= n; j++) {
        fmpz_set(form->b + j, s);
        for (slong i = 0; i < last; i++)
            fmpz_add(s + i, s + i, s + i + 1);
    }
    fmpz_mul_ui(form->error, common, 3 * (ulong)n + 4);
    return GRAZE_OK;
}

/* The most sign changes that the exact coefficients can have, zeros left out; `first` and `last`
 * are the exact signs of the first and the last one. best[s] is the most changes with which the
 * signs so far can end in - (s = 0) or + (s = 1). A coefficient whose sign is not known may have
 * either sign; if it is zero, the count does not change. */
static slong local_form_variations(const local_form *form, int first, int last) {
    slong n = form->degree, never = -(n + 2), best[2] = {never, never};
    int any = 0;
    for (slong j = 0; j <= n; j++) {
        int end = j == 0 || j == n, sign = j == 0 ? first : last;
        if (!end)
            sign = fmpz_cmpabs(form->b + j, form->error) > 0 ? fmpz_sgn(form->b + j) : 0;
        if (end && sign == 0)
            continue;
        slong minus = any ? FLINT_MAX(best[0], best[1] + 1) : 0;
        slong plus = any ? FLINT_MAX(best[1], best[0] + 1) : 0;
        best[0] = sign > 0 ? never : minus;
        best[1] = sign < 0 ? never : plus;
        any = 1;
    }
    return any ? FLINT_MAX(best[0], best[1]) : 0;
}

/* Guess the middle of a cluster: of the points 0 ... 2^gain that divide the interval into equal
 * parts, the one nearest to the root of the linear function with the end values of the derivative
 * of order `order` < degree. */
static void local_form_center(fmpz_t out, const local_form *form, slong order, ulong gain) {
    slong n = form->degree;
    LOCAL_VEC(fmpz, d, n + 1);
    LOCAL(fmpz, down);
    _fmpz_vec_set(d, form->b, n + 1);
    for (slong k = 0; k < order; k++)
        for (slong j = 0; j < n - k; j++)
            fmpz_sub(d + j, d + j + 1, d + j);
    fmpz_sub(down, d, d + n - order);
    fmpz_mul_2exp(out, d, gain + 1);
    fmpz_add(out, out, down);
    fmpz_mul_2exp(down, down, 1);
    if (fmpz_is_zero(down))
        fmpz_zero(out);
    else
        fmpz_fdiv_q(out, out, down);
    fmpz_one_2exp(d, gain);
    if (fmpz_sgn(out) < 0)
        fmpz_zero(out);
    else if (fmpz_cmp(out, d) > 0)
        fmpz_set(out, d);
}

/* The polynomial carried to [0, 1], and a stack whose top is the leftmost interval. */
typedef struct cluster {
    const root_search *search;
    fmpz_poly_t unit;
    pending *stack;
    size_t count, capacity;
} cluster;

/* Carry an interval from [0, 1] back to the polynomial's own variable. */
static void carry_back(dyadic_interval *out, const cluster *c, const dyadic_interval *x) {
    const dyadic_interval *whole = c->search->whole;
    LOCAL(fmpz, width);
    fmpz_sub(width, whole->high, whole->low);
    fmpz_mul_2exp(out->low, whole->low, x->exponent);
    fmpz_set(out->high, out->low);
    fmpz_addmul(out->low, width, x->low);
    fmpz_addmul(out->high, width, x->high);
    out->exponent = whole->exponent + x->exponent;
}

/* Push an entry with the signs, gain and precision of `like`; the caller sets its interval. */
static dyadic_interval *push_pending(cluster *c, pending like) {
    if (c->count == c->capacity) {
        size_t capacity = c->capacity ? 2 * c->capacity : 8;
        c->stack = flint_realloc(c->stack, capacity * sizeof *c->stack);
        for (size_t k = c->capacity; k < capacity; k++)
            dyadic_interval_init(&c->stack[k].where);
        c->capacity = capacity;
    }
    like.where = c->stack[c->count].where;
    c->stack[c->count] = like;
    return &c->stack[c->count++].where;
}

/* Compute the coefficients on an interval to the places at which, by bit lengths, the largest
 * exceeds the error by SHARPNESS bits and those of the degree. */
static graze_status sharp_form(local_form *form, const cluster *c, pending *at) {
    ulong more = SHARPNESS + FLINT_BIT_COUNT(form->degree);
    for (;; at->precision *= 2) {
        TRY(local_form_set(form, c->search->context, c->unit, &at->where, at->precision));
        slong bits = FLINT_ABS(_fmpz_vec_max_bits(form->b, form->degree + 1));
        if ((ulong)bits > fmpz_bits(form->error) + more)
            return GRAZE_OK;
    }
}

/* Whether the coefficients show that there is no root between low and high, integers in units of
 * 2^-exponent of `precise`. An empty interval has none. */
static graze_status has_no_root(int *none, local_form *form, const cluster *c, const fmpz_t low,
                                const fmpz_t high, int low_sign, int high_sign,
                                const pending *precise) {
    HELD(dyadic_interval, x);
    fmpz_set(x.low, low);
    fmpz_set(x.high, high);
    x.exponent = precise->where.exponent;
    *none = fmpz_equal(low, high);
    if (*none)
        return GRAZE_OK;
    TRY(local_form_set(form, c->search->context, c->unit, &x, precise->precision));
    *none = local_form_variations(form, low_sign, high_sign) == 0;
    return GRAZE_OK;
}

/* Cut the interval into 2^gain equal parts and take the two beside the guessed middle of the
 * cluster, or, if the guess is an end of the interval, the one part there. */
static void guess_part(dyadic_interval *part, const local_form *form, const pending *at,
                       slong order) {
    LOCAL(fmpz, unit);
    part->exponent = at->where.exponent + at->gain;
    local_form_center(part->low, form, order, at->gain);
    fmpz_add_ui(part->high, part->low, 1);
    if (fmpz_sgn(part->low) > 0)
        fmpz_sub_ui(part->low, part->low, 1);
    if (fmpz_bits(part->high) > at->gain && fmpz_val2(part->high) != at->gain)
        fmpz_sub_ui(part->high, part->high, 1);
    fmpz_sub(unit, at->where.high, at->where.low);
    fmpz_mul(part->low, part->low, unit);
    fmpz_mul(part->high, part->high, unit);
    fmpz_mul_2exp(unit, at->where.low, at->gain);
    fmpz_add(part->low, part->low, unit);
    fmpz_add(part->high, part->high, unit);
}

/* Whether all roots in the interval lie in the part, and no end of the part is a root unless it is
 * an end of the interval. Sets the signs at the part's ends. */
static graze_status part_has_all(int *all, local_form *form, const cluster *c, pending *part,
                                 const pending *at) {
    const dyadic_interval *x = &part->where;
    LOCAL(fmpz, low);
    LOCAL(fmpz, high);
    fmpz_mul_2exp(low, at->where.low, at->gain);
    fmpz_mul_2exp(high, at->where.high, at->gain);
    int own_low = fmpz_equal(low, x->low), own_high = fmpz_equal(high, x->high);
    part->low_sign = own_low ? at->low_sign : dyadic_sign(c->unit, x->low, x->exponent);
    part->high_sign = own_high ? at->high_sign : dyadic_sign(c->unit, x->high, x->exponent);
    *all = (own_low || part->low_sign != 0) && (own_high || part->high_sign != 0);
    if (*all)
        TRY(has_no_root(all, form, c, low, x->low, at->low_sign, part->low_sign, part));
    if (*all)
        TRY(has_no_root(all, form, c, x->high, high, part->high_sign, at->high_sign, part));
    return GRAZE_OK;
}

static void pending_clear(pending *p) {
    dyadic_interval_clear(&p->where);
}

/* Try to replace the interval by a part that has all its roots. A cluster of v roots, two of them
 * perhaps ends of the interval, has its middle near the one root of the derivative of order v - 1.
 * Near this middle p is about 2^(v gain) times smaller, so that v gain more places are needed. */
static graze_status leap(int *done, const cluster *c, pending *at, slong variations) {
    slong n = fmpz_poly_degree(c->unit);
    slong v = variations + (at->low_sign == 0) + (at->high_sign == 0);
    v = FLINT_MIN(v, n);
    ZEROED(pending, part);
    HELD(local_form, form, n);
    part.precision =
        at->precision + (ulong)v * (at->gain + FLINT_BIT_COUNT(n) + 2) + at->gain + SHARPNESS;
    TRY(local_form_set(&form, c->search->context, c->unit, &at->where, part.precision));
    guess_part(&part.where, &form, at, v - 1);
    TRY(part_has_all(done, &form, c, &part, at));
    part.gain = *done ? 2 * at->gain : FLINT_MAX(at->gain / 2, LEAST_GAIN);
    at->gain = part.gain;
    if (*done) {
        pending last = *at;
        *at = part;
        part = last;
    }
    return GRAZE_OK;
}

/* Replace the interval on top of the stack by its halves and, if it is a root, the point between
 * them.
 */
static void halve_pending(cluster *c) {
    pending *right = &c->stack[c->count - 1], left = *right;
    HELD(dyadic_interval, half);
    dyadic_interval_halves(&half, &right->where, &right->where);
    left.high_sign = right->low_sign = dyadic_sign(c->unit, half.high, half.exponent);
    if (left.high_sign == 0) {
        dyadic_interval *point = push_pending(c, left);
        dyadic_interval_set(point, &half);
        fmpz_set(point->low, half.high);
    }
    dyadic_interval_swap(push_pending(c, left), &half);
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
    ulong places = top->where.exponent, allowed = places_allowed(c);
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
    int is_point = fmpz_equal(top->where.low, top->where.high), known;
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

/* Push the first interval, one of 2^exponent equal parts of the whole one. */
static void push_first(cluster *c, const dyadic_interval *interval, int low_sign, int high_sign) {
    const dyadic_interval *whole = c->search->whole;
    const pending first = {.low_sign = low_sign,
                           .high_sign = high_sign,
                           .gain = LEAST_GAIN,
                           .precision = FIRST_PRECISION};
    dyadic_interval *x = push_pending(c, first);
    LOCAL(fmpz, width);
    fmpz_sub(width, whole->high, whole->low);
    x->exponent = interval->exponent - whole->exponent;
    fmpz_mul_2exp(x->low, whole->low, x->exponent);
    fmpz_sub(x->low, interval->low, x->low);
    fmpz_divexact(x->low, x->low, width);
    fmpz_add_ui(x->high, x->low, 1);
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
    dyadic_pull(c.unit, s->poly, s->whole);
    push_first(&c, interval, low_sign, high_sign);
    while (c.count > 0 && status == GRAZE_OK)
        status = step(&c, &form);
    for (size_t k = 0; k < c.capacity; k++)
        pending_clear(&c.stack[k]);
    flint_free(c.stack);
    fmpz_poly_clear(c.unit);
    return status;
}
