/* A point is decided by one sample in each gap between the curves on the sides of a square.
 *
 * Shifts curves to a point, splits them into parts, and bounds the square's size by their events.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A polynomial g with g(0, 0) = c not 0 has no zero where its other terms sum to less than |c| in
 * absolute value. For parts through the origin every event is a root of a polynomial in one
 * variable: a leading coefficient, a discriminant, a resultant, or the part on a diagonal
 * (proofs/topology.md C48).
 *
 * Within the square the curves through the point cut each quarter between the diagonals into
 * sectors. A sector is connected and misses the closed sweep's boundary, so it lies in the interior
 * or in the exterior; every smaller square meets the same sectors (proofs/topology.md C49).
 */
#include "questions/topo/eliminate.h"

#include "base/context/scope.h"
#include "base/number/isolate.h"

/* Invariant (proofs/topology.md C48), with P at the origin and r = 2^-places: in the square |x|,
 * |y| <= r the curves of the list that this was made of have no zeros but those of `through`. The
 * polynomials of `through` are squarefree, pairwise coprime and vanish at the origin. For 0 < |x|
 * <= r their real roots in y are simple and distinct, their number does not depend on |x|, and none
 * is x or -x unless it is so for all x. All of this holds with x and y exchanged too. */
typedef struct near_curves {
    curve_list through;
    ulong places;
} near_curves;

static void near_curves_init(near_curves *n) {
    curve_list_init(&n->through);
    n->places = 0;
}

static void near_curves_clear(near_curves *n) {
    curve_list_clear(&n->through);
}

/* Raise the number of places until, on [-r, r], a term of degree `degree` with a coefficient of
 * `bits` bits is below 1 / `terms` of a constant of `constant` bits: (bits - constant + 1 + log2
 * terms) / degree places suffice. */
static void places_for_term(ulong *places, ulong constant, ulong bits, ulong degree, ulong terms) {
    ulong needed = bits + 1 + FLINT_BIT_COUNT(terms);
    if (needed > constant)
        *places = FLINT_MAX(*places, (needed - constant + degree - 1) / degree);
}

void places_below_roots(ulong *places, const fmpz_poly_t p) {
    slong zeros = 0, length = fmpz_poly_length(p);
    while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, zeros)))
        zeros++;
    ulong constant = fmpz_bits(fmpz_poly_get_coeff_ptr(p, zeros));
    for (slong k = zeros + 1; k < length; k++)
        if (!fmpz_is_zero(fmpz_poly_get_coeff_ptr(p, k)))
            places_for_term(places, constant, fmpz_bits(fmpz_poly_get_coeff_ptr(p, k)),
                            (ulong)(k - zeros), (ulong)length);
}

/* Has a polynomial no constant term? A constant term would be its last one. */
static int passes_origin(const fmpz_mpoly_t g, const fmpz_mpoly_ctx_t ring) {
    ulong e[RING_VARIABLES];
    fmpz_mpoly_get_term_exp_ui(e, g, fmpz_mpoly_length(g, ring) - 1, ring);
    return e[0] + e[1] > 0;
}

/* State of making the parts and the square. */
typedef struct near_maker {
    near_curves *n;
    int refused;
    graze_context *context;
} near_maker;

/* Refuse a square that is smaller than the limit allows. */
static void look_at_limit(near_maker *m) {
    m->refused |= m->n->places > m->context->limits[GRAZE_LIMIT_BITS];
}

/* Shrink the square until p, not zero, has no root in [-r, r] but 0. */
static void stay_below_roots(near_maker *m, const fmpz_poly_t p) {
    places_below_roots(&m->n->places, p);
    look_at_limit(m);
}

/* Shrink the square until a curve that is not 0 at the origin misses it. */
static void stay_clear_of(near_maker *m, const fmpz_mpoly_t g) {
    const fmpz_mpoly_ctx_struct *ring = m->n->through.ring;
    slong length = fmpz_mpoly_length(g, ring);
    LOCAL(fmpz, c);
    fmpz_mpoly_get_term_coeff_fmpz(c, g, length - 1, ring); /* the constant is the last one */
    ulong constant = fmpz_bits(c);
    for (slong k = 0; k < length - 1; k++) {
        ulong e[RING_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, g, k, ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, g, k, ring);
        places_for_term(&m->n->places, constant, fmpz_bits(c), e[0] + e[1], (ulong)length);
    }
    look_at_limit(m);
}

/* Shrink the square below the common zeros of two curves. */
static graze_status stay_below_event(near_maker *m, const sliced_curve *a, const sliced_curve *b) {
    LOCAL(fmpz_poly, event);
    TRY(eliminate(event, m->context, a, b));
    if (fmpz_poly_is_zero(event))
        return context_fail(m->context, GRAZE_EINTERNAL,
                            "parts of curves of a sweep have a factor in common; expected "
                            "squarefree parts without one");
    stay_below_roots(m, event);
    return GRAZE_OK;
}

/* Shrink the square below the events of a curve alone: roots of its leading coefficient, which is
 * the whole curve if the curve does not depend on the variable, and common zeros with its
 * derivative. */
static graze_status stay_below_turns(near_maker *m, const sliced_curve *a) {
    stay_below_roots(m, a->coefficient + a->degree);
    if (a->degree < 2 || m->refused)
        return GRAZE_OK;
    ZEROED(sliced_curve, derivative);
    sliced_init_derivative(&derivative, a);
    return stay_below_event(m, a, &derivative);
}

/* Shrink the square below the events of curve k alone and with the curves before it, as polynomials
 * in `variable`. */
static graze_status stay_below_meetings(near_maker *m, size_t k, int variable) {
    const curve_list *c = &m->n->through;
    HELD(sliced_curve, a, &c->item[k], variable, c->ring);
    TRY(stay_below_turns(m, &a));
    for (size_t j = 0; j < k && a.degree > 0 && !m->refused; j++) {
        HELD(sliced_curve, b, &c->item[j], variable, c->ring);
        if (b.degree > 0)
            TRY(stay_below_event(m, &a, &b));
    }
    return GRAZE_OK;
}

static void stay_below_corners(near_maker *m, size_t k) {
    const curve_list *c = &m->n->through;
    LOCAL(fmpz_poly, p);
    LOCAL_VEC(fmpz_poly, image, RING_VARIABLES);
    fmpz_poly_struct *const images[] = {image + RING_X, image + RING_Y};
    fmpz_poly_set_coeff_si(image + RING_X, 1, 1);
    for (slong slope = 1; slope >= -1; slope -= 2) { /* both diagonals */
        fmpz_poly_set_coeff_si(image + RING_Y, 1, slope);
        (void)fmpz_mpoly_compose_fmpz_poly(p, &c->item[k], images,
                                           c->ring); /* it fails only for huge exponents */
        if (!fmpz_poly_is_zero(p))
            stay_below_roots(m, p);
    }
}

/* Split the curves through the point into parts and keep those that pass it, in coordinates about
 * the point; shrink the square until it misses all other curves and parts. */
static graze_status take_curves(near_maker *m, curve_list *parts, const curve_list *all,
                                const fmpq *point) {
    IN_RING(fmpz_mpoly, g, all->ring);
    for (size_t k = 0; k < all->count && !m->refused; k++) {
        TRY(shift_curve(g, m->context, &all->item[k], point, all->ring));
        if (passes_origin(g, all->ring))
            TRY(coprime_add(parts, &m->refused, m->context, &all->item[k]));
        else
            stay_clear_of(m, g);
    }
    for (size_t k = 0; k < parts->count && !m->refused; k++) {
        TRY(shift_curve(g, m->context, &parts->item[k], point, all->ring));
        if (passes_origin(g, all->ring))
            TRY(curves_append(&m->n->through, m->context, g));
        else
            stay_clear_of(m, g);
    }
    return GRAZE_OK;
}

/* Find the parts and the square for a list of curves and a point of 2 rationals; *refused is 1 if r
 * needs more than `bits` places (the context's limit), or coprime_add refuses. */
static graze_status near_make(near_curves *n, int *refused, graze_context *context,
                              const curve_list *all, const fmpq *point) {
    near_maker m = {n, 0, context};
    HELD(curve_list, parts);
    TRY(take_curves(&m, &parts, all, point));
    for (size_t k = 0; k < n->through.count && !m.refused; k++) {
        stay_below_corners(&m, k);
        for (int variable = 0; variable < 2 && !m.refused; variable++)
            TRY(stay_below_meetings(&m, k, variable));
    }
    *refused = m.refused;
    return GRAZE_OK;
}

/* Restrict one curve to a side of the square, times a power of 2. */
static void curve_on_side(fmpz_poly_t out, const fmpz_mpoly_t g, const near_curves *n, int axis,
                          int negative) {
    ulong degree = (ulong)fmpz_mpoly_degree_si(g, axis, n->through.ring);
    LOCAL_VEC(fmpz, c, 2);
    fmpz *sum = c + 1;
    fmpz_poly_zero(out);
    for (slong k = 0; k < fmpz_mpoly_length(g, n->through.ring); k++) {
        ulong e[RING_VARIABLES];
        fmpz_mpoly_get_term_exp_ui(e, g, k, n->through.ring);
        fmpz_mpoly_get_term_coeff_fmpz(c, g, k, n->through.ring);
        fmpz_mul_2exp(c, c, n->places * (degree - e[axis]));
        fmpz_poly_get_coeff_fmpz(sum, out, (slong)e[1 - axis]);
        (negative && e[axis] % 2 == 1 ? fmpz_sub : fmpz_add)(sum, sum, c);
        fmpz_poly_set_coeff_fmpz(out, (slong)e[1 - axis], sum);
    }
}

/* The product of the curves `through` on a side of the square, times a power of 2, as a polynomial
 * in the coordinate along the side. The side is on the line x = r or, with `negative`, x = -r; with
 * `axis` 1 on y = r or y = -r. */
static void near_side(fmpz_poly_t out, const near_curves *n, int axis, int negative) {
    LOCAL(fmpz_poly, one);
    fmpz_poly_set_ui(out, 1);
    for (size_t k = 0; k < n->through.count; k++) {
        curve_on_side(one, &n->through.item[k], n, axis, negative);
        fmpz_poly_mul(out, out, one);
    }
}

typedef struct square_maker {
    topo_finding *out;
    graze_context *context;
    const graze_scene *scene;
    const plane_view *view;
    const fmpq *point;
    graze_topo_level level;
    near_curves *near;
    int axis, negative; /* the current side */
} square_maker;

/* Classify the point of the current side at the coordinate `along`; a point that is out proves the
 * boundary, and the square is kept. */
static graze_status sample_at(square_maker *m, const fmpq_t along) {
    topo_finding *out = m->out;
    int beyond = 0;
    LOCAL_VEC(fmpq, sample, 2);
    fmpq_set_si(sample + m->axis, m->negative ? -1 : 1, 1);
    fmpq_div_2exp(sample + m->axis, sample + m->axis, m->near->places);
    fmpq_set(sample + (1 - m->axis), along);
    for (int k = 0; k < 2; k++)
        fmpq_add(sample + k, sample + k, m->point + k);
    view_point(out->witness, m->view, sample);
    TRY(beyond_closed(&beyond, m->context, m->scene, out->witness));
    if (!beyond)
        return GRAZE_OK;
    finding_set(out, GRAZE_TOPO_BOUNDARY, m->level);
    out->has_witness = 1;
    fmpq_one(&out->reach);
    fmpq_div_2exp(&out->reach, &out->reach, m->near->places);
    for (int k = 0; k < 2; k++)
        _fmpz_vec_set(out->along[k], m->view->along[k], m->view->dimension);
    return GRAZE_OK;
}

/* Sample the gap between two numbers unless they are equal: a root may be at a corner, an end of
 * the side. */
static graze_status sample_gap(square_maker *m, algebraic *low, algebraic *high) {
    int sign = 0;
    TRY(algebraic_compare(&sign, m->context, low, high));
    if (sign == 0)
        return GRAZE_OK;
    LOCAL(fmpq, along);
    TRY(algebraic_between(along, m->context, low, high));
    return sample_at(m, along);
}

static graze_status sample_side(square_maker *m) {
    LOCAL(fmpz_poly, product);
    HELD(dyadic_interval, side);
    dyadic_interval_set_si(&side, -1, 1);
    side.exponent = m->near->places;
    HELD(algebraic_list, roots);
    HELD(algebraic, low);
    HELD(algebraic, high);
    algebraic_set_dyadic(&low, side.low, side.exponent);
    algebraic_set_dyadic(&high, side.high, side.exponent);
    near_side(product, m->near, m->axis, m->negative);
    TRY(algebraic_roots(&roots, m->context, product, &side));
    for (size_t k = 0; k <= roots.count && !m->out->has_witness; k++)
        TRY(sample_gap(m, k ? &roots.item[k - 1] : &low, k < roots.count ? &roots.item[k] : &high));
    return GRAZE_OK;
}

graze_status square_decide(topo_finding *out, graze_context *context, const graze_scene *scene,
                           const curve_list *curves, const plane_view *view, const fmpq *point,
                           graze_topo_level level) {
    int refused = 0;
    HELD(near_curves, near);
    square_maker m = {.out = out,
                      .context = context,
                      .scene = scene,
                      .view = view,
                      .point = point,
                      .level = level,
                      .near = &near};
    TRY(near_make(&near, &refused, context, curves, point));
    if (refused) {
        finding_undecided(
            out, "a curve passes nearer, or has more digits, than the limit `bits` allows");
        return GRAZE_OK;
    }
    for (int side = 0; side < 4 && !out->has_witness; side++) {
        m.axis = side / 2;
        m.negative = side % 2;
        TRY(sample_side(&m));
    }
    if (!out->has_witness && (view->dimension == 2 || level == GRAZE_LEVEL_SECTION))
        finding_set(out, GRAZE_TOPO_INTERIOR, level);
    return GRAZE_OK;
}
