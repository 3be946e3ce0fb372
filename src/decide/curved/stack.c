/* Stacks over abscissas beside a point of the plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In the frame of the solid members have integer coefficients, so the lines may be rational though
 * the point is not. A window around the point has no zero on its horizontal sides, none but the
 * point on the vertical line through it, and in its width branches meet at the abscissa of the
 * point alone. Then the branches in the window are those that end in the point (C126).
 */
#include <flint/fmpz_mpoly.h>
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "decide/curved/walker.h"

/* Work of a resultant, as measured: PAIR_WORK times the sizes of both members, where a size is
 * (degree^2 + LEAST_SIZE) times the bits over SIZE_BITS. */
enum { PAIR_WORK = 8, LEAST_SIZE = 6, SIZE_BITS = 256 };

/* Binary places of the window's height at first; the width has FLATTEST times as many, for branches
 * as flat as y^4 = x. */
enum { FIRST_PLACES = 4, FLATTEST = CSG_DEGREE + 1 };

typedef struct stack {
    graze_context *context;
    const trajectory *c;
    algebraic *time;
    size_t count;
    ulong work;        /* work of a resultant of two members */
    candidate *member; /* only the surfaces' numbers are set */
    fmpz_mpoly_ctx_t ring;
    fmpz_mpoly_struct *curve;  /* the members, the horizontal sides, the vertical line */
    dyadic_interval window[2]; /* in x, in y */
    algebraic_list place[2];   /* x, y of the point, once they are found */
    expression e;              /* signs of the surfaces in the current sector */
    pullbacks at;              /* the members along a vertical line */
    int in, out;               /* the expression is true in some sector, false in some sector */
    graze_status status;
} stack;

/* Set side i of the window: five parts of 2^-places each, the point in the inner three. */
static void surround(stack *s, int i, ulong places) {
    fmpz *low = s->window[i].low, *high = s->window[i].high;
    LOCAL_VEC(fmpz, form, 6);
    fmpz *at = form + 3;
    ulong gain = FIRST_GAIN;
    LOCAL_VEC(fmpq, from, 2);
    fmpq *to = from + 1;
    LOCAL(fmpz_poly, gap);
    fmpz_one_2exp(form + i, places);
    fmpz_neg(form + i, form + i);
    for (int step = 0, inside = 0; !inside && !s->status; step++) {
        algebraic_bounds(from, to, s->time);
        trajectory_at(at, s->c, from);
        fmpz_mul_2exp(at + i, at + i, places);
        fmpz_fdiv_q(low, at + i, at + 2);
        fmpz_sub_ui(low, low, 1);
        fmpz_add_ui(high, low, 3);
        inside = 1;
        for (int side = -1, sign; side <= 1 && inside && !s->status; side += 2) {
            fmpz_set(form + 2, side < 0 ? low : high);
            trajectory_pullback(gap, s->c, form);
            s->status = algebraic_sign_at(&sign, s->context, gap, s->time);
            inside = sign == side;
        }
        if (!inside && !s->status)
            s->status = algebraic_narrow(s->context, s->time, step, &gain);
    }
    fmpz_sub_ui(low, low, 1);
    fmpz_add_ui(high, high, 1);
    s->window[i].exponent = places;
}

/* 1 if all common zeros of two curves, or for a = b all multiple zeros of one, in the window's
 * range of x (axis 0) or y (axis 1) have one such coordinate, that of the first zero found so far.
 */
static int meet_once(stack *s, int axis, size_t a, size_t b) {
    algebraic_list *place = &s->place[axis];
    fmpz_mpoly_struct *p = s->curve + a, *q = s->curve + b;
    int order = 0, other = 1 - axis;
    IN_RING(fmpz_mpoly, common, s->ring);
    LOCAL(fmpz_poly, meetings);
    s->status = context_work(s->context, s->work);
    if (!s->status && !(a != b ? fmpz_mpoly_resultant(common, p, q, other, s->ring)
                               : fmpz_mpoly_degree_si(p, other, s->ring) < 1 ||
                                     fmpz_mpoly_discriminant(common, p, other, s->ring)))
        s->status = context_fail(s->context, GRAZE_EINTERNAL, "a resultant is not found");
    fmpz_mpoly_get_fmpz_poly(meetings, common, axis, s->ring);
    if (!s->status)
        s->status = algebraic_roots(place, s->context, meetings, &s->window[axis]);
    for (size_t k = 1; k < place->count && !order && !s->status; k++)
        s->status = algebraic_compare(&order, s->context, &place->item[k], place->item);
    place->count = FLINT_MIN(place->count, 1);
    return order == 0 && !s->status;
}

/* Set curve k to the line on which the coordinate `axis` is n / d. */
static void set_line(stack *s, size_t k, int axis, const fmpz_t n, const fmpz_t d) {
    fmpz_mpoly_gen(s->curve + k, axis, s->ring);
    fmpz_mpoly_scalar_mul_fmpz(s->curve + k, s->curve + k, d, s->ring);
    fmpz_mpoly_sub_fmpz(s->curve + k, s->curve + k, n, s->ring);
}

static int is_small(stack *s) {
    size_t n = s->count, vertical = n + 2;
    const algebraic *x;
    int small = 1;
    LOCAL(fmpz, scale);
    fmpz_one_2exp(scale, s->window[1].exponent);
    set_line(s, n, 1, s->window[1].low, scale);
    set_line(s, n + 1, 1, s->window[1].high, scale);
    s->place[0].count = s->place[1].count = 0;
    for (size_t k = 0; k < n + 2 && small; k++)
        for (size_t j = 0; j <= k && small; j++)
            small = meet_once(s, 0, k, j);
    small = small && s->place[0].count;
    x = s->place[0].item;
    if (small && algebraic_is_rational(x))
        set_line(s, vertical, 0, fmpq_numref(x->value), fmpq_denref(x->value));
    else if (small)
        fmpz_mpoly_set_fmpz_poly(s->curve + vertical, x->poly, 0, s->ring);
    for (size_t k = 0; k < n && small; k++)
        small = meet_once(s, 1, k, vertical);
    return small;
}

static void choose_window(stack *s) {
    int small = 0;
    for (ulong places = FIRST_PLACES; !small && !s->status; places *= 4) {
        if (FLATTEST * places >= s->context->limits[GRAZE_LIMIT_BITS])
            s->status = algebraic_bits_limit(s->context);
        surround(s, 1, places);
        surround(s, 0, FLATTEST * places);
        small = !s->status && is_small(s);
    }
}

/* Evaluate the expression on a vertical line from below; a member's sign changes at its branches.
 */
static void walk_up(stack *s, const fmpz_t abscissa) {
    const dyadic_interval *x = &s->window[0], *y = &s->window[1];
    pullbacks *at = &s->at;
    dependence d;
    HELD(trajectory, line, 2);
    line.degree = 1;
    fmpz_poly_set_fmpz(&line.x[0], abscissa);
    fmpz_poly_set_coeff_fmpz(&line.x[1], 0, y->low);
    LOCAL(fmpz, height);
    fmpz_sub(height, y->high, y->low);
    fmpz_poly_set_coeff_fmpz(&line.x[1], 1, height);
    fmpz_poly_scalar_mul_2exp(&line.x[1], &line.x[1], x->exponent - y->exponent);
    fmpz_poly_one(&line.x[2]);
    fmpz_poly_scalar_mul_2exp(&line.x[2], &line.x[2], x->exponent);
    const exact_window whole = {0, 0, WINDOW_WHOLE, 0, s->count};
    s->status = pullbacks_set(at, &line, &whole, s->member);
    for (size_t k = 0; k < at->asked_count && !s->status; k++)
        s->e.sign[at->asked[k]] = (signed char)fmpz_sgn(at->form[at->asked[k]].coeffs);
    for (size_t k = 0; k <= at->zero_count && !s->status; k++) {
        s->status = expression_ask(&d, &s->e, NULL, 0);
        s->in |= d.state == GRAZE_STATE_I;
        s->out |= d.state == GRAZE_STATE_O;
        if (k < at->zero_count)
            s->e.sign[at->zero[k].surface] *= -1;
    }
}

static void stack_init(stack *s, const expression *signs, const size_t *surface) {
    s->status = expression_init(&s->e, s->context, signs->solid);
    graze_status other = pullbacks_init(&s->at, s->context, signs->solid);
    s->status = s->status ? s->status : other;
    s->member = calloc(s->count, sizeof *s->member);
    if (!s->status && !s->member)
        s->status = context_fail(s->context, GRAZE_ESYSTEM, "out of memory for curves");
    if (!s->status)
        memcpy(s->e.sign, signs->sign, signs->solid->surface_count);
    fmpz_mpoly_ctx_init(s->ring, 2, ORD_LEX);
    s->curve = flint_malloc((s->count + 3) * sizeof *s->curve);
    for (size_t k = 0; k < s->count + 3; k++)
        fmpz_mpoly_init(s->curve + k, s->ring);
    for (size_t k = 0; k < s->count && !s->status; k++) {
        const csg_surface *from = &signs->solid->surface[surface[k]];
        s->member[k].simplex = (uint32_t)surface[k];
        for (size_t t = 0; t < from->count; t++) {
            const ulong power[] = {from->power[t][0], from->power[t][1]};
            fmpz_mpoly_push_term_fmpz_ui(s->curve + k, from->coefficient + t, power, s->ring);
        }
        fmpz_mpoly_sort_terms(s->curve + k, s->ring);
    }
    for (int i = 0; i < 2; i++) {
        dyadic_interval_init(&s->window[i]);
        algebraic_list_init(&s->place[i]);
    }
}

static void stack_clear(stack *s) {
    for (size_t k = 0; k < s->count + 3; k++)
        fmpz_mpoly_clear(s->curve + k, s->ring);
    flint_free(s->curve);
    fmpz_mpoly_ctx_clear(s->ring);
    for (int i = 0; i < 2; i++) {
        dyadic_interval_clear(&s->window[i]);
        algebraic_list_clear(&s->place[i]);
    }
    free(s->member);
    pullbacks_clear(&s->at);
    expression_clear(&s->e);
}

static ulong member_size(const csg_surface *member) {
    slong bits = _fmpz_vec_max_bits(member->coefficient, (slong)member->count);
    return (ulong)(member->degree * member->degree + LEAST_SIZE) *
           ((ulong)FLINT_ABS(bits) / SIZE_BITS + 1);
}

graze_status stack_decide(graze_state *out, const expression *signs, const trajectory *c,
                          const size_t *surface, size_t count, algebraic *time) {
    stack s = {.context = signs->context, .c = c, .time = time, .count = count};
    ulong size = 0;
    for (size_t k = 0; k < count; k++)
        size += member_size(&signs->solid->surface[surface[k]]);
    *out = GRAZE_STATE_UNDECIDED;
    if (size > s.context->limits[GRAZE_LIMIT_WORK] / PAIR_WORK / size)
        return GRAZE_OK;
    s.work = PAIR_WORK * size * size / (count * count);
    stack_init(&s, signs, surface);
    choose_window(&s);
    for (int side = 0; side < 2 && !s.status; side++)
        walk_up(&s, side ? s.window[0].high : s.window[0].low);
    *out = !s.out ? GRAZE_STATE_I : s.in ? GRAZE_STATE_B : GRAZE_STATE_O;
    stack_clear(&s);
    return s.status;
}
