/* Curves moved to a point, factored, and the radius below all that happens to them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A polynomial g with g(0, 0) = c not 0 has no zero where the sum of its other terms stays below
 * |c| in absolute value. Of those through the origin every event is a root of a polynomial in one
 * variable: leading coefficient, discriminant, resultants, corners (proofs/topology.md C48).
 */
#include "topo/near.h"

#include <flint/fmpz_mpoly_factor.h>
#include "number/bernstein.h"
#include "topo/eliminate.h"

void near_init(near_curves *n) {
    curves_init(&n->through);
    n->places = 0;
}

void near_clear(near_curves *n) {
    curves_clear(&n->through);
}

/* The exponents of x and y in term k. */
static void exponents_of(ulong *out, const fmpz_mpoly_t g, slong k, const fmpz_mpoly_ctx_t ring) {
    ulong all[RING_VARIABLES];
    fmpz_mpoly_get_term_exp_ui(all, g, k, ring);
    out[0] = all[RING_X];
    out[1] = all[RING_Y];
}

/* The sum of a_(ij) 2^(places (total - i - j)) over the terms, absolute values but for i = j = 0,
 * which is taken off. */
static int is_clear_of(const fmpz_mpoly_t g, ulong places, const fmpz_mpoly_ctx_t ring) {
    slong total = fmpz_mpoly_total_degree_si(g, ring);
    fmpz_t rest, constant, term;
    fmpz_init(rest);
    fmpz_init(constant);
    fmpz_init(term);
    for (slong k = 0; k < fmpz_mpoly_length(g, ring); k++) {
        ulong e[2];
        exponents_of(e, g, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(term, g, k, ring);
        fmpz_abs(term, term);
        fmpz_mul_2exp(term, term, places * ((ulong)total - e[0] - e[1]));
        if (e[0] + e[1] == 0)
            fmpz_set(constant, term);
        else
            fmpz_add(rest, rest, term);
    }
    int is_clear = fmpz_cmp(constant, rest) > 0;
    fmpz_clear(rest);
    fmpz_clear(constant);
    fmpz_clear(term);
    return is_clear;
}

static int passes_origin(const fmpz_mpoly_t g, const fmpz_mpoly_ctx_t ring) {
    for (slong k = 0; k < fmpz_mpoly_length(g, ring); k++) {
        ulong e[2];
        exponents_of(e, g, k, ring);
        if (e[0] + e[1] == 0)
            return 0;
    }
    return 1;
}

/* 1 if p, with p(0) not 0, has no root in [-2^-places, 2^-places]: one sign of all Bernstein
 * coefficients (proofs/claims.md C23). */
static int is_free_of_roots(const fmpz_poly_t p, ulong places) {
    slong degree = fmpz_poly_degree(p);
    int sign = fmpz_sgn(fmpz_poly_get_coeff_ptr(p, 0)), same = 1;
    fmpz *b = _fmpz_vec_init(degree + 1);
    dyadic_interval around;
    dyadic_interval_init(&around);
    dyadic_interval_set_si(&around, -1, 1);
    around.exponent = places;
    bernstein_from_poly(b, p, degree, &around);
    for (slong k = 0; k <= degree; k++)
        same = same && fmpz_sgn(b + k) == sign;
    dyadic_interval_clear(&around);
    _fmpz_vec_clear(b, degree + 1);
    return same;
}

/* What the steps share. */
typedef struct near_maker {
    near_curves *n;
    int refused;
    graze_context *context;
} near_maker;

/* Make the square smaller; 0 at the limit. */
static int shrink(near_maker *m) {
    m->n->places += 1 + m->n->places / 8;
    m->refused |= m->n->places > m->context->limits[GRAZE_LIMIT_BITS];
    return !m->refused;
}

/* Make the square so small that p has no root in [-r, r] but 0. Destroys p; p not zero. */
static void stay_below_roots(near_maker *m, fmpz_poly_t p) {
    slong zeros = 0;
    while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, zeros)))
        zeros++;
    fmpz_poly_shift_right(p, p, zeros);
    while (!is_free_of_roots(p, m->n->places) && shrink(m))
        ;
}

/* Keep an irreducible curve, once, or stay clear of it. */
static graze_status take_factor(near_maker *m, const fmpz_mpoly_t factor) {
    curve_list *through = &m->n->through;
    if (!passes_origin(factor, through->ring)) {
        while (!is_clear_of(factor, m->n->places, through->ring) && shrink(m))
            ;
        return GRAZE_OK;
    }
    fmpz_mpoly_t opposite;
    fmpz_mpoly_init(opposite, through->ring);
    fmpz_mpoly_neg(opposite, factor, through->ring);
    int known = 0;
    for (size_t k = 0; k < through->count; k++)
        known = known || fmpz_mpoly_equal(&through->item[k], factor, through->ring) ||
                fmpz_mpoly_equal(&through->item[k], opposite, through->ring);
    fmpz_mpoly_clear(opposite, through->ring);
    return known ? GRAZE_OK : curves_append(through, m->context, factor);
}

/* A curve in coordinates about the point. */
static graze_status take_curve(near_maker *m, const fmpz_mpoly_t curve) {
    const fmpz_mpoly_ctx_struct *ring = m->n->through.ring;
    if (!passes_origin(curve, ring))
        return take_factor(m, curve);
    fmpz_mpoly_factor_t factors;
    fmpz_mpoly_factor_init(factors, ring);
    graze_status status = GRAZE_OK;
    if (!fmpz_mpoly_factor(factors, curve, ring))
        status = context_fail(m->context, GRAZE_EINTERNAL, "a curve of a sweep is not factored");
    for (slong k = 0; k < fmpz_mpoly_factor_length(factors, ring) && !status; k++)
        status = take_factor(m, factors->poly + k);
    fmpz_mpoly_factor_clear(factors, ring);
    return status;
}

/* x + P_x, y + P_y and t, into which curves are carried. */
typedef struct shift_to_point {
    fmpq_mpoly_ctx_t ring;
    fmpq_mpoly_t image[RING_VARIABLES], from, to;
} shift_to_point;

static void shift_init(shift_to_point *s, const fmpq *point) {
    fmpq_mpoly_ctx_init(s->ring, RING_VARIABLES, ORD_LEX);
    fmpq_mpoly_init(s->from, s->ring);
    fmpq_mpoly_init(s->to, s->ring);
    for (int v = 0; v < RING_VARIABLES; v++) {
        fmpq_mpoly_init(s->image[v], s->ring);
        fmpq_mpoly_gen(s->image[v], v, s->ring);
    }
    fmpq_mpoly_add_fmpq(s->image[RING_X], s->image[RING_X], point, s->ring);
    fmpq_mpoly_add_fmpq(s->image[RING_Y], s->image[RING_Y], point + 1, s->ring);
}

static void shift_clear(shift_to_point *s) {
    for (int v = 0; v < RING_VARIABLES; v++)
        fmpq_mpoly_clear(s->image[v], s->ring);
    fmpq_mpoly_clear(s->from, s->ring);
    fmpq_mpoly_clear(s->to, s->ring);
    fmpq_mpoly_ctx_clear(s->ring);
}

/* The curve about the point in s->to->zpoly, primitive. */
static graze_status shift_curve(shift_to_point *s, graze_context *context, const fmpz_mpoly_t curve,
                                const fmpz_mpoly_ctx_t ring) {
    fmpq_mpoly_struct *image[] = {s->image[RING_X], s->image[RING_Y], s->image[RING_T]};
    fmpq_one(s->from->content);
    fmpz_mpoly_set(s->from->zpoly, curve, ring);
    fmpq_mpoly_reduce(s->from, s->ring);
    if (!fmpq_mpoly_compose_fmpq_mpoly(s->to, s->from, image, s->ring, s->ring))
        return context_fail(context, GRAZE_EINTERNAL, "a curve of a sweep is not moved");
    return GRAZE_OK;
}

/* g(x, x), or g(x, -x). */
static void on_diagonal(fmpz_poly_t out, const fmpz_mpoly_t g, int falling,
                        const fmpz_mpoly_ctx_t ring) {
    fmpz_t c, sum;
    fmpz_init(c);
    fmpz_init(sum);
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(g, ring); k++) {
        ulong e[2];
        exponents_of(e, g, k, ring);
        slong power = (slong)(e[0] + e[1]);
        fmpz_mpoly_get_term_coeff_fmpz(c, g, k, ring);
        fmpz_poly_get_coeff_fmpz(sum, out, power);
        if (falling && e[1] % 2 == 1)
            fmpz_sub(sum, sum, c);
        else
            fmpz_add(sum, sum, c);
        fmpz_poly_set_coeff_fmpz(out, power, sum);
    }
    fmpz_clear(c);
    fmpz_clear(sum);
}

/* Stay clear of the events of curve a with itself, or with b. */
static graze_status stay_below_event(near_maker *m, const sliced_curve *a, const sliced_curve *b) {
    fmpz_poly_t event;
    fmpz_poly_init(event);
    graze_status status = eliminate(event, m->context, a, b);
    if (!status && fmpz_poly_is_zero(event))
        status = context_fail(m->context, GRAZE_EINTERNAL,
                              "irreducible curves of a sweep have a factor in common");
    else if (!status)
        stay_below_roots(m, event);
    fmpz_poly_clear(event);
    return status;
}

/* The events of curve k with itself and with those before it, as functions of `variable`. */
static graze_status stay_below_meetings(near_maker *m, size_t k, int variable) {
    const curve_list *c = &m->n->through;
    sliced_curve a, b;
    graze_status status = GRAZE_OK;
    sliced_init(&a, &c->item[k], variable, c);
    if (a.degree > 1)
        status = stay_below_event(m, &a, NULL);
    for (size_t j = 0; j < k && a.degree > 0 && !status && !m->refused; j++) {
        sliced_init(&b, &c->item[j], variable, c);
        if (b.degree > 0)
            status = stay_below_event(m, &a, &b);
        sliced_clear(&b);
    }
    if (a.degree > 0)
        stay_below_roots(m, a.coefficient + a.degree); /* the last use of it */
    sliced_clear(&a);
    return status;
}

static void stay_below_corners(near_maker *m, size_t k) {
    fmpz_poly_t p;
    fmpz_poly_init(p);
    for (int falling = 0; falling < 2; falling++) {
        on_diagonal(p, &m->n->through.item[k], falling, m->n->through.ring);
        if (!fmpz_poly_is_zero(p))
            stay_below_roots(m, p);
    }
    fmpz_poly_clear(p);
}

graze_status near_make(near_curves *n, int *refused, graze_context *context, const curve_list *all,
                       const fmpq *point) {
    near_maker m = {n, 0, context};
    graze_status status = GRAZE_OK;
    shift_to_point s;
    shift_init(&s, point);
    for (size_t k = 0; k < all->count && !status && !m.refused; k++) {
        status = shift_curve(&s, context, &all->item[k], all->ring);
        if (!status)
            status = take_curve(&m, s.to->zpoly);
        if (!status)
            status = context_poll(context);
    }
    shift_clear(&s);
    for (size_t k = 0; k < n->through.count && !status && !m.refused; k++) {
        stay_below_corners(&m, k);
        for (int variable = 0; variable < 2 && !status && !m.refused; variable++)
            status = stay_below_meetings(&m, k, variable);
    }
    *refused = m.refused;
    return status;
}

/* One curve on a side, times a power of 2. */
static void curve_on_side(fmpz_poly_t out, const fmpz_mpoly_t g, const near_curves *n, int axis,
                          int negative) {
    ulong degree = (ulong)fmpz_mpoly_degree_si(g, axis, n->through.ring);
    fmpz_t c, sum;
    fmpz_init(c);
    fmpz_init(sum);
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(g, n->through.ring); k++) {
        ulong e[2];
        exponents_of(e, g, k, n->through.ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, g, k, n->through.ring);
        fmpz_mul_2exp(c, c, n->places * (degree - e[axis]));
        fmpz_poly_get_coeff_fmpz(sum, out, (slong)e[1 - axis]);
        if (negative && e[axis] % 2 == 1)
            fmpz_sub(sum, sum, c);
        else
            fmpz_add(sum, sum, c);
        fmpz_poly_set_coeff_fmpz(out, (slong)e[1 - axis], sum);
    }
    fmpz_clear(c);
    fmpz_clear(sum);
}

void near_side(fmpz_poly_t out, const near_curves *n, int axis, int negative) {
    fmpz_poly_t one;
    fmpz_poly_init(one);
    fmpz_poly_set_ui(out, 1);
    for (size_t k = 0; k < n->through.count; k++) {
        curve_on_side(one, &n->through.item[k], n, axis, negative);
        fmpz_poly_mul(out, out, one);
    }
    fmpz_poly_clear(one);
}
