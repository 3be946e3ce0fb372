/* Signs along directions of the lowest forms of members that may be singular.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A direction is (x, y, 1), in the plane (x, 1), or opposite to one. Over an interval of x in which
 * no leading coefficient, discriminant or resultant by y has a root, the roots in y of all forms
 * are continuous and distinct; so one x in each interval and one y in each gap are enough (C129).
 */
#include <flint/fmpq_mpoly.h>
#include <flint/fmpz_mpoly.h>
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "decide/curved/arrangement.h"

enum { X, Y, VARIABLES, PARTS = CSG_FREE_MOST * CSG_DEGREE + VARIABLES };

/* An irrational time is narrowed to this number of binary places to find `near`. */
enum { PLACES = 32 };

typedef struct apex {
    sign_germ *g;
    fmpq_mpoly_ctx_t ring; /* of x, y */
    fmpq *near;            /* the germ's time if it is rational, else a rational time near it */
    int count;
    fmpz_mpoly_struct part[PARTS]; /* irreducible, distinct: the factors of forms */
    unsigned homogeneous, odd;     /* homogeneous members; members whose lowest degree is odd */
    pattern_set shown;             /* patterns of the homogeneous members */
    fmpq *direction;               /* the last coordinate is 1 */
} apex;

static int power_sum(const taylor *t, size_t term) {
    return t->power[term][0] + t->power[term][1] + t->power[term][2];
}

/* FLINT refuses polynomials whose powers are too great; these have low ones. */
static void expect_done(const apex *a, int done) {
    moment_field *f = a->g->f;
    if (!done && f->status == GRAZE_OK)
        f->status = context_fail(f->context, GRAZE_EINTERNAL, "a form of low degree is refused");
}

/* Keep the factors of a form that are not kept yet. */
static void keep_parts(apex *a, const fmpz_mpoly_t form) {
    const fmpz_mpoly_ctx_struct *ring = a->ring->zctx;
    moment_field *f = a->g->f;
    IN_RING(fmpz_mpoly_factor, factors, ring);
    expect_done(a, fmpz_mpoly_factor(factors, form, ring));
    for (slong k = 0; k < factors->num && f->status == GRAZE_OK; k++) {
        int known = 0;
        for (int i = 0; i < a->count && !known; i++)
            known = fmpz_mpoly_equal(&a->part[i], factors->poly + k, ring);
        if (known)
            continue;
        fmpz_mpoly_init(&a->part[a->count], ring);
        fmpz_mpoly_set(&a->part[a->count++], factors->poly + k, ring);
    }
}

/* Factor a member's lowest form, the last coordinate set to 1, and add the factors to the parts
 * that cut directions. The form of a homogeneous member is rational up to a factor. The form of
 * any other member is taken at the time `near`; on a gap x and y are added instead of its factors.
 */
static void read_member(apex *a, const taylor *t) {
    const int fixed = taylor_order(t) == t->degree;
    IN_RING(fmpq_mpoly, form, a->ring);
    LOCAL(fmpq, at);
    for (size_t k = 0; k < t->count; k++) {
        const ulong power[VARIABLES] = {t->power[k][0], t->dimension == 3 ? t->power[k][1] : 0};
        if (power_sum(t, k) != taylor_order(t))
            continue;
        fmpq_poly_evaluate_fmpq(at, t->coefficient + k, a->near);
        fmpq_mpoly_push_term_fmpq_ui(form, at, power, a->ring);
    }
    fmpq_mpoly_sort_terms(form, a->ring);
    fmpq_mpoly_reduce(form, a->ring);
    int everywhere = fixed || !fmpq_poly_is_zero(a->g->f->modulus);
    for (int i = 0; i < VARIABLES && !everywhere; i++) {
        fmpq_mpoly_gen(form, i, a->ring);
        keep_parts(a, form->zpoly);
    }
    if (everywhere)
        keep_parts(a, form->zpoly);
}

/* The sign of a member's lowest form along the direction. */
static int sign_of_lowest_form(const apex *a, const taylor *t) {
    LOCAL(fmpq, factor);
    LOCAL(fmpq, power);
    LOCAL(fmpq_poly, sum);
    LOCAL(fmpq_poly, term);
    for (size_t k = 0; k < t->count; k++) {
        if (power_sum(t, k) != taylor_order(t))
            continue;
        fmpq_one(factor);
        for (int i = 0; i < t->dimension; i++) {
            fmpq_pow_si(power, a->direction + i, t->power[k][i]);
            fmpq_mul(factor, factor, power);
        }
        fmpq_poly_scalar_mul_fmpq(term, t->coefficient + k, factor);
        fmpq_poly_add(sum, sum, term);
    }
    return field_sign(a->g->f, sum);
}

/* Add the patterns of signs along the direction and its opposite: of homogeneous members to
 * `shown`, and of all to the germ's `seen` if no form is 0 there. */
static void look_both_ways(apex *a) {
    unsigned negative = 0, flat = 0;
    for (int k = 0; k < a->g->count; k++) {
        int sign = sign_of_lowest_form(a, &a->g->member[k]);
        negative |= (unsigned)(sign < 0) << k;
        flat |= (unsigned)(sign == 0) << k;
    }
    for (int way = 0; way < 2; way++, negative ^= a->odd) {
        pattern_add(&a->shown, negative & a->homogeneous);
        if (!flat)
            pattern_add(&a->g->seen, negative);
    }
}

/* Roots of polynomials, and a bound beyond all of them. */
typedef struct cuts {
    algebraic_list root;
    fmpz_t bound;
} cuts;

static void cuts_init(cuts *to) {
    algebraic_list_init(&to->root);
    fmpz_init(to->bound);
}

static void cuts_clear(cuts *to) {
    algebraic_list_clear(&to->root);
    fmpz_clear(to->bound);
}

/* Add all real roots of a polynomial in one variable. */
static void cut_at_roots(cuts *to, const apex *a, const fmpz_mpoly_t p, int variable) {
    moment_field *f = a->g->f;
    LOCAL(fmpz_poly, q);
    HELD(dyadic_interval, all);
    expect_done(a, fmpz_mpoly_get_fmpz_poly(q, p, variable, a->ring->zctx));
    if (f->status == GRAZE_OK && fmpz_poly_degree(q) > 0) {
        fmpz_poly_bound_roots(all.high, q);
        fmpz_add_ui(all.high, all.high, 1);
        fmpz_neg(all.low, all.high);
        if (fmpz_cmp(all.high, to->bound) > 0)
            fmpz_set(to->bound, all.high);
        f->status = algebraic_roots(&to->root, f->context, q, &all);
    }
}

static void walk_line(apex *a);

/* Take a rational number in each gap between the roots, and beyond them, as a coordinate of the
 * direction, and go on with each. */
static void walk_gaps(apex *a, cuts *at, int variable) {
    moment_field *f = a->g->f;
    fmpz_add_ui(at->bound, at->bound, 1);
    for (int end = 0; end < 2; end++, fmpz_neg(at->bound, at->bound))
        algebraic_set_dyadic(algebraic_list_append(&at->root), at->bound, 0);
    size_t n = at->root.count;
    FREED(algebraic *, order, malloc(n * sizeof(algebraic *)));
    if (!order) {
        f->status = context_fail(f->context, GRAZE_ESYSTEM, "out of memory for %zu directions", n);
        return;
    }
    for (size_t k = 0; k < n; k++)
        order[k] = &at->root.item[k];
    f->status = algebraic_sort_once(order, &n, f->context, NULL, NULL);
    for (size_t k = 0; k + 1 < n && f->status == GRAZE_OK; k++) {
        f->status = algebraic_between(a->direction + variable, f->context, order[k], order[k + 1]);
        if (f->status == GRAZE_OK)
            variable + 2 < a->g->dimension ? walk_line(a) : look_both_ways(a);
    }
}

/* Walk the directions with the x that is set: cut y at the roots of all parts at this x. */
static void walk_line(apex *a) {
    const fmpz_mpoly_ctx_struct *ring = a->ring->zctx;
    IN_RING(fmpq_mpoly, form, a->ring);
    HELD(cuts, in_y);
    for (int k = 0; k < a->count && a->g->f->status == GRAZE_OK; k++) {
        fmpq_one(form->content);
        fmpz_mpoly_set(form->zpoly, &a->part[k], ring);
        expect_done(a, fmpq_mpoly_evaluate_one_fmpq(form, form, X, a->direction, a->ring));
        cut_at_roots(&in_y, a, form->zpoly, Y);
    }
    if (a->g->f->status == GRAZE_OK)
        walk_gaps(a, &in_y, Y);
}

/* Cut x where the roots in y of one form, or of two, meet or go to infinity. */
static void cut_by_parts(cuts *in_x, apex *a, int i, int k) {
    const fmpz_mpoly_ctx_struct *ring = a->ring->zctx;
    moment_field *f = a->g->f;
    IN_RING(fmpz_mpoly, cut, ring);
    ulong words = (ulong)labs(fmpz_mpoly_max_bits(&a->part[k])) / FLINT_BITS + 1;
    f->status = context_work(f->context, 100 * words * words);
    if (f->status == GRAZE_OK)
        expect_done(a, i < k ? fmpz_mpoly_resultant(cut, &a->part[i], &a->part[k], Y, ring)
                             : fmpz_mpoly_discriminant(cut, &a->part[k], Y, ring));
    if (f->status == GRAZE_OK)
        cut_at_roots(in_x, a, cut, X);
}

/* Cut x at the roots of a part's leading coefficient by y; a part without y is that coefficient. */
static void cut_by_leading_term(cuts *in_x, apex *a, int k) {
    const fmpz_mpoly_ctx_struct *ring = a->ring->zctx;
    const slong variable = Y;
    const ulong degree = (ulong)fmpz_mpoly_degree_si(&a->part[k], Y, ring);
    IN_RING(fmpz_mpoly, lead, ring);
    fmpz_mpoly_get_coeff_vars_ui(lead, &a->part[k], &variable, &degree, 1, ring);
    cut_at_roots(in_x, a, lead, X);
}

static void walk_directions(apex *a) {
    HELD(cuts, in_x);
    for (int k = 0; k < a->count && a->g->f->status == GRAZE_OK; k++) {
        cut_by_leading_term(&in_x, a, k);
        for (int i = 0; i <= k && a->g->f->status == GRAZE_OK; i++)
            if (fmpz_mpoly_degree_si(&a->part[i], Y, a->ring->zctx) > 0 &&
                fmpz_mpoly_degree_si(&a->part[k], Y, a->ring->zctx) > 0)
                cut_by_parts(&in_x, a, i, k);
    }
    if (a->g->f->status == GRAZE_OK)
        walk_gaps(a, &in_x, X);
}

/* If a member's lowest form is quadratic and definite, exclude its other sign (C99). */
static void exclude_by_definite_form(sign_germ *g, int k) {
    const taylor *t = &g->member[k];
    LOCAL_VEC(fmpq_poly, h, 12); /* a matrix: twice the form; and a product of its rows */
    for (size_t n = 0; n < t->count; n++)
        for (int i = 0; i < g->dimension && power_sum(t, n) == 2; i++)
            for (int j = 0; j < g->dimension; j++)
                if (t->power[n][i] && t->power[n][j] && (i != j || t->power[n][i] == 2))
                    fmpq_poly_scalar_mul_si(h + 3 * i + j, t->coefficient + n, i == j ? 2 : 1);
    int sign = field_sign(g->f, h);
    unsigned bit = 1u << k;
    if (g->dimension == 2)
        fmpq_poly_set(h + 8, h);
    field_cross(h + 9, g->f, h, h + 3);
    field_dot(h, g->f, h + 6, h + 9, 3);
    if (sign && field_sign(g->f, h + 11) > 0 && field_sign(g->f, h) == sign)
        germ_exclude(g, bit, sign > 0 ? bit : 0);
}

/* Set `near`. */
static void read_time(apex *a) {
    moment_field *f = a->g->f;
    ulong gain = FIRST_GAIN;
    for (int step = 0; f->status == GRAZE_OK && !algebraic_is_rational(f->time) &&
                       f->time->where.exponent < PLACES;
         step++)
        f->status = algebraic_narrow(f->context, f->time, step, &gain);
    LOCAL(fmpq, high);
    algebraic_bounds(a->near, high, f->time);
}

static void read_members(apex *a) {
    sign_germ *g = a->g;
    for (int k = 0; k < g->count && g->f->status == GRAZE_OK; k++) {
        const taylor *t = &g->member[k];
        a->homogeneous |= (unsigned)(taylor_order(t) == t->degree) << k;
        a->odd |= (unsigned)(taylor_order(t) % 2) << k;
        read_member(a, t);
        if (taylor_order(t) == 2 && t->degree > 2)
            exclude_by_definite_form(g, k);
    }
}

void apex_ask(sign_germ *g) {
    LOCAL_VEC(fmpq, direction, 4);
    apex a = {.g = g, .near = direction + 3, .direction = direction};
    fmpq_mpoly_ctx_init(a.ring, VARIABLES, ORD_LEX);
    fmpq_one(a.direction + g->dimension - 1);
    read_time(&a);
    read_members(&a);
    if (g->f->status == GRAZE_OK)
        walk_directions(&a);
    for (unsigned s = 0; s < germ_patterns(g) && g->f->status == GRAZE_OK; s++)
        if (!pattern_has(&a.shown, s & a.homogeneous))
            pattern_add(&g->never, s);
    for (int k = 0; k < a.count; k++)
        fmpz_mpoly_clear(&a.part[k], a.ring->zctx);
    fmpq_mpoly_ctx_clear(a.ring);
}
