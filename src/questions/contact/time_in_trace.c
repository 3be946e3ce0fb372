/* Times of the trace next to the time of a site. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Times of contact are ordered and alternate with gaps of one state, so only the ends of gaps next
 * to t matter. Two of them, on either side, are compared by reflecting one at t.
 */
#include "questions/contact/nearby.h"

#include "base/context/scope.h"

/* Set *out to the sign of (time - t), for a time of the trace. */
static graze_status compare_to_site(int *out, graze_context *context, graze_time *time,
                                    const graze_site *s) {
    const motion_piece *piece = &s->scene->motion->piece[time->piece];
    LOCAL(fmpq, u);
    HELD(algebraic, own);
    motion_parameter_at(u, piece, s->t);
    algebraic_set_rational(&own, u);
    return algebraic_compare(out, context, &time->u, &own);
}

/* Find the contact that holds t, and whether t is its beginning or its end. */
static graze_status find_contact(size_t *out, int *begins, int *ends, graze_context *context,
                                 const graze_site *s) {
    for (size_t k = 0; k < s->trace.contact_count; k++) {
        const contact *c = &s->trace.contact[k];
        int from, to;
        TRY(compare_to_site(&from, context, c->from, s));
        TRY(compare_to_site(&to, context, c->to, s));
        *out = k;
        *begins = from == 0;
        *ends = to == 0;
        if (from <= 0 && to >= 0)
            return GRAZE_OK;
    }
    return context_fail(context, GRAZE_EINTERNAL,
                        "the trajectory of a boundary point misses the boundary at its time");
}

/* Set scale x - shift or, if `reflect`, shift - scale x, for a canonical time x and a positive
 * integer `scale`. */
static void moved_time(algebraic *out, const graze_time *time, const fmpz_t scale,
                       const fmpz_t shift, int reflect) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    fmpq_mul_fmpz(low, time->low, scale);
    fmpq_mul_fmpz(high, time->high, scale);
    fmpq_sub_fmpz(low, low, shift);
    fmpq_sub_fmpz(high, high, shift);
    if (reflect) {
        fmpq_neg(low, low);
        fmpq_neg(high, high);
        fmpq_swap(low, high);
    }
    if (fmpq_equal(time->low, time->high)) {
        algebraic_set_rational(out, low);
    } else {
        /* p((shift + X) / scale) or p((shift - X) / scale), times a power of the scale */
        LOCAL(fmpz_poly, linear);
        fmpz_poly_set_coeff_fmpz(linear, 0, shift);
        fmpz_poly_set_coeff_si(linear, 1, reflect ? -1 : 1);
        LOCAL(fmpz, power);
        fmpz_set_ui(power, 1);
        fmpz_poly_set(out->poly, time->poly);
        for (slong k = fmpz_poly_degree(out->poly); k >= 0; k--) {
            fmpz_mul(out->poly->coeffs + k, out->poly->coeffs + k, power);
            fmpz_mul(power, power, scale);
        }
        fmpz_poly_compose(out->poly, out->poly, linear);
        /* the ends are dyadic, and remain so when scaled and moved by integers */
        fmpz_set(power, fmpz_cmp(fmpq_denref(low), fmpq_denref(high)) > 0 ? fmpq_denref(low)
                                                                          : fmpq_denref(high));
        out->where.exponent = fmpz_val2(power);
        fmpq_mul_fmpz(low, low, power);
        fmpq_mul_fmpz(high, high, power);
        fmpz_set(out->where.low, fmpq_numref(low));
        fmpz_set(out->where.high, fmpq_numref(high));
        out->low_sign = dyadic_sign(out->poly, out->where.low, out->where.exponent);
    }
}

/* Find which of a time before t and a time after t is nearer to t; NULL stands for no time. */
static graze_status nearer(const graze_time **out, graze_context *context, const graze_site *s,
                           graze_time *before, graze_time *after) {
    if (before)
        TRY(time_canonicalise(before, context));
    if (after)
        TRY(time_canonicalise(after, context));
    *out = before ? before : after;
    if (!before || !after)
        return GRAZE_OK;
    int order = 0;
    HELD(algebraic, back);
    HELD(algebraic, forth);
    moved_time(&back, before, fmpq_denref(s->t), fmpq_numref(s->t), 1);
    moved_time(&forth, after, fmpq_denref(s->t), fmpq_numref(s->t), 0);
    TRY(algebraic_compare(&order, context, &back, &forth));
    *out = order <= 0 ? before : after;
    return GRAZE_OK;
}

/* Give t as a time of the motion, which the site owns and makes once. */
static graze_status own_time(const graze_time **out, graze_context *context, graze_site *s) {
    if (!s->itself) {
        const site_side *side = &s->side[!s->side[0].present];
        HELD(algebraic, u);
        algebraic_set_rational(&u, side->u);
        TRY(time_make(&s->itself, context, s->scene->motion, side->piece, &u));
    }
    *out = s->itself;
    return time_canonicalise(s->itself, context);
}

/* Give the end of the nearest gap of state I before t, and the beginning of the nearest one after
 * t; contact k holds t. */
static void interiors_beside(graze_time **before, graze_time **after, const graze_site *s,
                             size_t k) {
    const graze_trace *trace = &s->trace;
    *before = *after = NULL;
    for (size_t j = k + 1; j-- > 0 && !*before;)
        if (trace->contact[j].left == GRAZE_STATE_I)
            *before = trace->contact[j].from;
    for (size_t j = k; j < trace->contact_count && !*after; j++)
        if (trace->contact[j].right == GRAZE_STATE_I)
            *after = trace->contact[j].to;
}

/* Find `left`, `right` and `trim`, and the contact k that holds t; *is_instant: that contact is t
 * alone. */
static graze_status find_trim(graze_site *s, graze_context *context, size_t *k, int *is_instant) {
    const graze_trace *trace = &s->trace;
    int begins = 0, ends = 0;
    TRY(find_contact(k, &begins, &ends, context, s));
    graze_site_facts *f = &s->facts;
    f->left = begins ? trace->contact[*k].left : GRAZE_STATE_B;
    f->right = ends ? trace->contact[*k].right : GRAZE_STATE_B;
    *is_instant = begins && ends;
    if (trace->verdict.pmc == GRAZE_IN)
        f->trim = f->left == GRAZE_STATE_I || f->right == GRAZE_STATE_I ? GRAZE_TRIM_NEAR
                                                                        : GRAZE_TRIM_FAR;
    else
        f->trim = !*is_instant                ? GRAZE_TRIM_SLIDES
                  : trace->contact_count == 1 ? GRAZE_TRIM_SIMPLE
                                              : GRAZE_TRIM_MEETS;
    return GRAZE_OK;
}

graze_status nearest_trim(graze_site *s, graze_context *context) {
    size_t k = 0;
    int is_instant = 0;
    return find_trim(s, context, &k, &is_instant);
}

graze_status nearest_find(graze_site *s, graze_context *context) {
    const graze_trace *trace = &s->trace;
    size_t k = 0;
    int is_instant = 0;
    TRY(find_trim(s, context, &k, &is_instant));
    int inside_near = s->facts.left == GRAZE_STATE_I || s->facts.right == GRAZE_STATE_I;
    if (inside_near || !is_instant)
        TRY(own_time(&s->near, context, s));
    else
        TRY(nearer(&s->near, context, s, k > 0 ? trace->contact[k - 1].to : NULL,
                   k + 1 < trace->contact_count ? trace->contact[k + 1].from : NULL));
    if (inside_near)
        return own_time(&s->near_in, context, s);
    graze_time *before, *after;
    interiors_beside(&before, &after, s, k);
    return nearer(&s->near_in, context, s, before, after);
}
