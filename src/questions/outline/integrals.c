/* Integrals of functions num/den and sqrt(num)/den of polynomials, in brackets, by Taylor series at
 * the middle of cells; the last coefficient over the whole cell bounds the rest
 * (proofs/outline.md C142).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/outline/bracket.h"

#include "base/context/scope.h"

/* Terms of a series, more where more places are kept; the last one, of even order, is the rest. */
enum { TERMS = 14, MOST_TERMS = 62, ROOM = 63 };

/* A cell, and brackets of the function's series in sigma: the parameter is
 * the cell's middle + sigma times its radius, -1 <= sigma <= 1. */
typedef struct cell {
    const integrand *f;
    ulong places;
    int terms;
    dyadic_interval where;
    bracket num[ROOM], den[ROOM], value[ROOM], spare;
} cell;

/* Numbers that are all zero bits are initialised ones. */
static void cell_init(cell *c, const integrand *f, ulong places) {
    ulong more = places > 128 ? (places - 128) / 16 : 0;
    *c = (cell){.f = f, .places = places};
    c->terms = (int)FLINT_MIN(TERMS + 2 * more, MOST_TERMS);
}

static void cell_clear(cell *c) {
    dyadic_interval_clear(&c->where);
    for (int k = 0; k <= c->terms; k++) {
        bracket_clear(&c->num[k]);
        bracket_clear(&c->den[k]);
        bracket_clear(&c->value[k]);
    }
    bracket_clear(&c->spare);
}

/* p as a polynomial of sigma, times 2^*scale. */
static void in_sigma(fmpz_poly_t out, slong *scale, const cell *c, const fmpz_poly_t p) {
    HELD(dyadic_interval, from_middle);
    fmpz_add(from_middle.low, c->where.low, c->where.high);
    fmpz_mul_2exp(from_middle.high, c->where.high, 1);
    from_middle.exponent = c->where.exponent + 1;
    dyadic_pull(out, p, &from_middle);
    *scale = (slong)from_middle.exponent * FLINT_MAX(fmpz_poly_degree(p), 0);
}

/* out = integer 2^shift, rounded outward. */
static void bracket_shift(bracket *out, const fmpz_t low, const fmpz_t high, slong shift) {
    if (shift >= 0) {
        fmpz_mul_2exp(out->low, low, (ulong)shift);
        fmpz_mul_2exp(out->high, high, (ulong)shift);
    } else {
        fmpz_fdiv_q_2exp(out->low, low, (ulong)-shift);
        fmpz_cdiv_q_2exp(out->high, high, (ulong)-shift);
    }
}

/* The coefficients of the series of p at the middle or, if `whole`, at all points of the cell, in
 * brackets of p 2^shift. */
static void set_series(bracket *out, int last, const fmpz_poly_t p, slong shift, int whole) {
    LOCAL(fmpz, low);
    LOCAL(fmpz, high);
    LOCAL(fmpz, term);
    slong n = fmpz_poly_degree(p);
    for (slong j = 0; j <= last; j++) {
        fmpz_poly_get_coeff_fmpz(low, p, j);
        fmpz_set(high, low);
        for (slong i = j + 1; i <= n && whole; i++) {
            fmpz_bin_uiui(term, (ulong)i, (ulong)j);
            fmpz_mul(term, term, fmpz_poly_get_coeff_ptr(p, i));
            fmpz_abs(term, term);
            fmpz_sub(low, low, term);
            fmpz_add(high, high, term);
        }
        bracket_shift(&out[j], low, high, shift);
    }
}

/* num[0] ... num[last] become the series of their square root. */
static int take_square_root(cell *c, int last) {
    bracket *s = c->num, *g = c->value;
    if (!bracket_sqrt(&g[0], &s[0], c->places))
        return 0;
    for (int j = 1; j <= last; j++) {
        bracket_set(&g[j], &s[j]);
        for (int i = 1; i < j; i++) {
            bracket_mul(&c->spare, &g[i], &g[j - i], c->places);
            bracket_sub(&g[j], &g[j], &c->spare);
        }
        bracket_add(&c->spare, &g[0], &g[0]);
        if (!bracket_div(&g[j], &g[j], &c->spare, c->places))
            return 0;
    }
    for (int j = 0; j <= last; j++)
        bracket_set(&s[j], &g[j]);
    return 1;
}

/* value[0] ... value[last]: the function's series, at the middle or over the whole cell. Returns 0
 * where the denominator, or what a root is taken of, may vanish. */
static int function_series(cell *c, int last, int whole) {
    slong num_scale, den_scale;
    LOCAL(fmpz_poly, num);
    LOCAL(fmpz_poly, den);
    LOCAL(fmpz, middle);
    in_sigma(num, &num_scale, c, c->f->num);
    in_sigma(den, &den_scale, c, c->f->den);
    fmpz_poly_get_coeff_fmpz(middle, den, 0);
    /* Both are divided by a power of 2 near the denominator. */
    slong size = (slong)fmpz_bits(middle) - den_scale;
    set_series(c->num, last, num, (slong)c->places - num_scale - (c->f->root ? 2 * size : size),
               whole);
    set_series(c->den, last, den, (slong)c->places - den_scale - size, whole);
    if (c->f->root && !take_square_root(c, last))
        return 0;
    for (int j = 0; j <= last; j++) {
        bracket_set(&c->value[j], &c->num[j]);
        for (int i = 1; i <= j; i++) {
            bracket_mul(&c->spare, &c->den[i], &c->value[j - i], c->places);
            bracket_sub(&c->value[j], &c->value[j], &c->spare);
        }
        if (!bracket_div(&c->value[j], &c->value[j], &c->den[0], c->places))
            return 0;
    }
    return 1;
}

/* out = x times the cell's radius. */
static void set_scaled_by(bracket *out, const bracket *x, const cell *c) {
    LOCAL(fmpz, width);
    fmpz_sub(width, c->where.high, c->where.low);
    fmpz_mul(out->low, x->low, width);
    fmpz_mul(out->high, x->high, width);
    bracket_shift(out, out->low, out->high, -(slong)(c->where.exponent + 1));
}

static int is_tight(const bracket *x, ulong bits) {
    LOCAL(fmpz, width);
    fmpz_sub(width, x->high, x->low);
    return fmpz_bits(width) <= bits;
}

/* The integral over the cell by its series; 0 where that is not possible. */
static int by_series(bracket *out, cell *c) {
    HELD(bracket, sum);
    HELD(bracket, term);
    HELD(bracket, rest);
    if (!function_series(c, c->terms, 1))
        return 0;
    bracket_set(&rest, &c->value[c->terms]);
    if (!function_series(c, c->terms, 0))
        return 0;
    for (int j = 0; j <= c->terms; j += 2) {
        bracket_set(&term, j < c->terms ? &c->value[j] : &rest);
        bracket_add(&term, &term, &term);
        fmpz_fdiv_q_si(term.low, term.low, j + 1);
        fmpz_cdiv_q_si(term.high, term.high, j + 1);
        bracket_add(&sum, &sum, &term);
    }
    set_scaled_by(out, &sum, c);
    return 1;
}

/* The integral over the cell, or over a part of it that begins or ends where it does if `part`, by
 * the function's range; 0 where that is unbounded. */
static int by_range(bracket *out, cell *c, int part) {
    HELD(bracket, range);
    HELD(bracket, zero);
    if (!function_series(c, 0, 1)) {
        /* Only a root of what may vanish is bounded: by 0 and the root of the upper end, which is
         * not below 0, as the number is not. */
        if (!c->f->root)
            return 0;
        bracket_sqrt(&range, &c->num[0], c->places);
        if (!bracket_div(&range, &range, &c->den[0], c->places))
            return 0;
    } else {
        bracket_set(&range, &c->value[0]);
    }
    if (part)
        bracket_join(&range, &zero);
    bracket_add(&range, &range, &range);
    set_scaled_by(out, &range, c);
    return 1;
}

/* Add the integral over the cell, halved until each part's bracket has at most `bits` bits. */
static graze_status integrate_cells(bracket *out, graze_context *context, cell *c, ulong bits) {
    HELD(bracket, part);
    if ((by_series(&part, c) && is_tight(&part, bits)) ||
        (by_range(&part, c, 0) && is_tight(&part, bits))) {
        bracket_add(out, out, &part);
        return context_work(context, 50000);
    }
    if (c->where.exponent > 8 * c->places)
        return context_limit(context, GRAZE_LIMIT_BITS, "the cells of an integral");
    HELD(cell, half, c->f, c->places);
    HELD(dyadic_interval, upper);
    dyadic_interval_halves(&half.where, &upper, &c->where);
    TRY(integrate_cells(out, context, &half, bits));
    dyadic_interval_swap(&half.where, &upper);
    return integrate_cells(out, context, &half, bits);
}

/* Add the integral from the number within the bracket `at`, which ends at its higher end (`from`),
 * or to it from the lower one. */
static graze_status integrate_end(bracket *out, graze_context *context, const integrand *f,
                                  const bracket *at, ulong places) {
    HELD(cell, c, f, places);
    HELD(bracket, part);
    if (fmpz_equal(at->low, at->high))
        return GRAZE_OK;
    c.where.exponent = places;
    fmpz_set(c.where.low, at->low);
    fmpz_set(c.where.high, at->high);
    if (!by_range(&part, &c, 1))
        return context_limit(context, GRAZE_LIMIT_BITS, "the ends of an integral");
    bracket_add(out, out, &part);
    return GRAZE_OK;
}

graze_status integral_between(bracket *out, graze_context *context, const integrand *f,
                              algebraic *from, algebraic *to, ulong places, ulong bits) {
    HELD(bracket, first);
    HELD(bracket, last);
    HELD(cell, c, f, places);
    TRY(bracket_of_number(&first, context, from, places));
    TRY(bracket_of_number(&last, context, to, places));
    fmpz_zero(out->low);
    fmpz_zero(out->high);
    if (fmpz_cmp(first.high, last.low) >= 0) {
        bracket_join(&first, &last);
        return integrate_end(out, context, f, &first, places);
    }
    TRY(integrate_end(out, context, f, &first, places));
    TRY(integrate_end(out, context, f, &last, places));
    c.where.exponent = places;
    fmpz_set(c.where.low, first.high);
    fmpz_set(c.where.high, last.low);
    return integrate_cells(out, context, &c, bits);
}
