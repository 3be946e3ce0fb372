/* Intervals with fixed binary places.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/outline/bracket.h"

#include "base/context/scope.h"

void bracket_init(bracket *x) {
    fmpz_init(x->low);
    fmpz_init(x->high);
}

void bracket_clear(bracket *x) {
    fmpz_clear(x->low);
    fmpz_clear(x->high);
}

void point_place_init(point_place *p) {
    bracket_init(&p->xy[0]);
    bracket_init(&p->xy[1]);
}

void point_place_clear(point_place *p) {
    bracket_clear(&p->xy[0]);
    bracket_clear(&p->xy[1]);
}

void bracket_set(bracket *x, const bracket *y) {
    fmpz_set(x->low, y->low);
    fmpz_set(x->high, y->high);
}

void bracket_set_rational(bracket *x, const fmpq_t value, ulong places) {
    LOCAL(fmpz, scaled);
    fmpz_mul_2exp(scaled, fmpq_numref(value), places);
    fmpz_fdiv_q(x->low, scaled, fmpq_denref(value));
    fmpz_cdiv_q(x->high, scaled, fmpq_denref(value));
}

void bracket_low(fmpq_t out, const bracket *x, ulong places) {
    dyadic_value(out, x->low, places);
}

void bracket_high(fmpq_t out, const bracket *x, ulong places) {
    dyadic_value(out, x->high, places);
}

void bracket_add(bracket *out, const bracket *a, const bracket *b) {
    fmpz_add(out->low, a->low, b->low);
    fmpz_add(out->high, a->high, b->high);
}

void bracket_sub(bracket *out, const bracket *a, const bracket *b) {
    LOCAL(fmpz, low);
    fmpz_sub(low, a->low, b->high);
    fmpz_sub(out->high, a->high, b->low);
    fmpz_swap(out->low, low);
}

void bracket_join(bracket *out, const bracket *x) {
    if (fmpz_cmp(x->low, out->low) < 0)
        fmpz_set(out->low, x->low);
    if (fmpz_cmp(x->high, out->high) > 0)
        fmpz_set(out->high, x->high);
}

void bracket_mul(bracket *out, const bracket *a, const bracket *b, ulong places) {
    LOCAL_VEC(fmpz, end, 4);
    fmpz_mul(end, a->low, b->low);
    fmpz_mul(end + 1, a->low, b->high);
    fmpz_mul(end + 2, a->high, b->low);
    fmpz_mul(end + 3, a->high, b->high);
    fmpz *low = end, *high = end;
    for (int k = 1; k < 4; k++) {
        low = fmpz_cmp(end + k, low) < 0 ? end + k : low;
        high = fmpz_cmp(end + k, high) > 0 ? end + k : high;
    }
    fmpz_cdiv_q_2exp(out->high, high, places);
    fmpz_fdiv_q_2exp(out->low, low, places);
}

int bracket_sign(const bracket *x) {
    return fmpz_sgn(x->low) > 0 ? 1 : fmpz_sgn(x->high) < 0 ? -1 : 0;
}

int bracket_div(bracket *out, const bracket *a, const bracket *b, ulong places) {
    if (!bracket_sign(b))
        return 0;
    HELD(bracket, inverse);
    LOCAL(fmpz, one);
    fmpz_one_2exp(one, 2 * places);
    fmpz_fdiv_q(inverse.low, one, b->high);
    fmpz_cdiv_q(inverse.high, one, b->low);
    bracket_mul(out, a, &inverse, places);
    return 1;
}

int bracket_sqrt(bracket *out, const bracket *a, ulong places) {
    int is_positive = fmpz_sgn(a->low) > 0;
    fmpz_mul_2exp(out->high, a->high, places);
    fmpz_mul_2exp(out->low, a->low, places);
    if (!is_positive)
        fmpz_zero(out->low);
    fmpz_sqrt(out->low, out->low);
    fmpz_sqrt(out->high, out->high);
    fmpz_add_ui(out->high, out->high, 1);
    return is_positive;
}

int bracket_meets(const bracket *a, const bracket *b) {
    return fmpz_cmp(a->low, b->high) <= 0 && fmpz_cmp(b->low, a->high) <= 0;
}

void bracket_evaluate(bracket *out, const fmpz_poly_t p, const bracket *at, ulong places) {
    HELD(bracket, sum);
    LOCAL(fmpz, c);
    for (slong k = fmpz_poly_degree(p); k >= 0; k--) {
        bracket_mul(&sum, &sum, at, places);
        fmpz_mul_2exp(c, fmpz_poly_get_coeff_ptr(p, k), places);
        fmpz_add(sum.low, sum.low, c);
        fmpz_add(sum.high, sum.high, c);
    }
    bracket_set(out, &sum);
}

/* Is the number's interval less than 2^-places wide? */
static int is_short(const dyadic_interval *where, ulong places) {
    LOCAL(fmpz, width);
    fmpz_sub(width, where->high, where->low);
    return fmpz_bits(width) + places <= where->exponent;
}

graze_status bracket_of_number(bracket *out, graze_context *context, algebraic *x, ulong places) {
    ulong gain = FIRST_GAIN;
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    for (int step = 0; !algebraic_is_rational(x) && !is_short(&x->where, places); step++)
        TRY(algebraic_narrow(context, x, step, &gain));
    HELD(bracket, upper);
    algebraic_bounds(low, high, x);
    bracket_set_rational(out, low, places);
    bracket_set_rational(&upper, high, places);
    bracket_join(out, &upper);
    return GRAZE_OK;
}

/* The other coordinate of a slanted line where its parameter, a coordinate, is in a bracket; 0
 * where too few places are kept. `at` is the bracket of its time. */
static int slant_place(bracket *out, const outline_curve *c, const bracket *at, const bracket *s,
                       ulong places) {
    HELD(bracket, along);
    HELD(bracket, across);
    HELD(bracket, constant);
    bracket_evaluate(&along, &c->x[c->axis], at, places);
    bracket_evaluate(&across, &c->x[1 - c->axis], at, places);
    bracket_evaluate(&constant, &c->x[2], at, places);
    bracket_mul(&along, &along, s, places);
    bracket_add(&along, &along, &constant);
    fmpz_neg(along.low, along.low);
    fmpz_neg(along.high, along.high);
    fmpz_swap(along.low, along.high);
    return bracket_div(out, &along, &across, places);
}

/* Both coordinates with `working` places; 0 where these are too few. */
static graze_status place_with(int *done, bracket *xy, graze_context *context, outline_curve *c,
                               algebraic *s, ulong working) {
    HELD(bracket, at);
    HELD(bracket, weight);
    TRY(bracket_of_number(&at, context, s, working));
    if (c->slant) {
        HELD(bracket, time);
        TRY(bracket_of_number(&time, context, &c->at, working));
        bracket_set(&xy[c->axis], &at);
        *done = slant_place(&xy[1 - c->axis], c, &time, &at, working);
        return GRAZE_OK;
    }
    bracket_evaluate(&weight, &c->x[2], &at, working);
    *done = bracket_sign(&weight) != 0;
    for (int k = 0; k < 2 && *done; k++) {
        bracket_evaluate(&xy[k], &c->x[k], &at, working);
        *done = bracket_div(&xy[k], &xy[k], &weight, working);
    }
    return GRAZE_OK;
}

graze_status outline_curve_place(bracket *xy, graze_context *context, outline_curve *c,
                                 algebraic *s, ulong places) {
    LOCAL(fmpz, width);
    for (ulong guard = 64;; guard *= 2) {
        int done = 0;
        TRY(place_with(&done, xy, context, c, s, places + guard));
        for (int k = 0; k < 2 && done; k++) {
            fmpz_sub(width, xy[k].high, xy[k].low);
            done = fmpz_bits(width) <= guard;
        }
        for (int k = 0; k < 2 && done; k++) {
            fmpz_fdiv_q_2exp(xy[k].low, xy[k].low, guard);
            fmpz_cdiv_q_2exp(xy[k].high, xy[k].high, guard);
        }
        if (done)
            return GRAZE_OK;
        if (guard > context->limits[GRAZE_LIMIT_BITS])
            return context_limit(context, GRAZE_LIMIT_BITS, "the places of a point of the outline");
    }
}
