/* A contact time in the motion's own parameter: minimal polynomial and widest isolating dyadic
 * interval (formats: TIME), so that equal times are equal text (proofs/claims.md C28).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "trace/trace.h"

#include <flint/fmpz_poly_factor.h>
#include "context/environment.h"

/* With lo = a / b and hi - lo = c / e: u = (e b t - e a) / (b c). The result is p(u) times a
 * positive number, as a polynomial in t. */
static void to_motion_parameter(fmpz_poly_t out, const fmpz_poly_t p, const motion_piece *piece) {
    fmpq_t width;
    fmpz_poly_t linear;
    fmpz_t scale, power;
    fmpq_init(width);
    fmpz_poly_init(linear);
    fmpz_init(scale);
    fmpz_init_set_ui(power, 1);
    fmpq_sub(width, piece->hi, piece->lo);
    fmpz_mul(scale, fmpq_denref(width), fmpq_numref(piece->lo));
    fmpz_neg(scale, scale);
    fmpz_poly_set_coeff_fmpz(linear, 0, scale);
    fmpz_mul(scale, fmpq_denref(width), fmpq_denref(piece->lo));
    fmpz_poly_set_coeff_fmpz(linear, 1, scale);
    fmpz_mul(scale, fmpq_denref(piece->lo), fmpq_numref(width));
    fmpz_poly_set(out, p);
    for (slong i = fmpz_poly_degree(p); i >= 0; i--) {
        fmpz_mul(out->coeffs + i, out->coeffs + i, power);
        fmpz_mul(power, power, scale);
    }
    fmpz_poly_compose(out, out, linear);
    fmpq_clear(width);
    fmpz_poly_clear(linear);
    fmpz_clear(scale);
    fmpz_clear(power);
}

static void bounds_in_motion_parameter(fmpq_t low, fmpq_t high, const graze_time *time) {
    const motion_piece *piece = &time->motion->piece[time->piece];
    fmpq_t width;
    fmpq_init(width);
    fmpq_sub(width, piece->hi, piece->lo);
    algebraic_bounds(low, high, &time->u);
    fmpq_mul(low, low, width);
    fmpq_add(low, low, piece->lo);
    fmpq_mul(high, high, width);
    fmpq_add(high, high, piece->lo);
    fmpq_clear(width);
}

static int sign_at_rational(const fmpz_poly_t p, const fmpq_t x) {
    fmpq_t value;
    fmpq_init(value);
    fmpz_poly_evaluate_fmpq(value, p, x);
    int sign = fmpq_sgn(value);
    fmpq_clear(value);
    return sign;
}

static void set_rational(graze_time *time, const fmpq_t value) {
    fmpz_t c;
    fmpz_init(c);
    fmpq_set(time->low, value);
    fmpq_set(time->high, value);
    fmpz_neg(c, fmpq_numref(value));
    fmpz_poly_zero(time->poly);
    fmpz_poly_set_coeff_fmpz(time->poly, 0, c);
    fmpz_poly_set_coeff_fmpz(time->poly, 1, fmpq_denref(value));
    fmpz_clear(c);
}

/* The irreducible factor of the time's polynomial that has the root: the polynomial has just this
 * one, a simple one, between low and high, and does not vanish there. */
static void find_minimal_polynomial(graze_time *time, const fmpq_t low, const fmpq_t high) {
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    to_motion_parameter(time->poly, time->u.poly, &time->motion->piece[time->piece]);
    fmpz_poly_factor(factors, time->poly);
    for (slong k = 0; k < factors->num; k++)
        if (sign_at_rational(factors->p + k, low) != sign_at_rational(factors->p + k, high))
            fmpz_poly_set(time->poly, factors->p + k);
    if (fmpz_sgn(fmpz_poly_lead(time->poly)) < 0)
        fmpz_poly_neg(time->poly, time->poly);
    fmpz_poly_factor_clear(factors);
}

static size_t count_roots(const fmpz_poly_t p, const dyadic_interval *interval) {
    algebraic_list roots;
    algebraic_list_init(&roots);
    algebraic_roots(&roots, p, interval);
    size_t count = roots.count;
    algebraic_list_clear(&roots);
    return count;
}

/* floor(x 2^m) */
static void scaled_floor(fmpz_t out, const fmpq_t x, ulong m) {
    fmpq_t scaled;
    fmpq_init(scaled);
    fmpq_mul_2exp(scaled, x, m);
    fmpz_fdiv_q(out, fmpq_numref(scaled), fmpq_denref(scaled));
    fmpq_clear(scaled);
}

/* An irrational number and its minimal polynomial's other roots: no dyadic number is among them, so
 * both loops end. */
static void find_widest_interval(graze_time *time, fmpq_t low, fmpq_t high) {
    dyadic_interval at;
    dyadic_interval_init(&at);
    for (ulong m = 0;; m++) {
        at.exponent = m;
        for (;;) {
            bounds_in_motion_parameter(low, high, time);
            scaled_floor(at.low, low, m);
            scaled_floor(at.high, high, m);
            if (fmpz_equal(at.low, at.high))
                break;
            algebraic_refine(&time->u);
        }
        fmpz_add_ui(at.high, at.low, 1);
        if (count_roots(time->poly, &at) == 1)
            break;
    }
    dyadic_value(time->low, at.low, at.exponent);
    dyadic_value(time->high, at.high, at.exponent);
    dyadic_interval_clear(&at);
}

void time_canonicalise(graze_time *time) {
    if (time->canonical)
        return;
    /* Getters that take no context end up here. */
    __attribute__((cleanup(environment_leave), unused)) environment host = environment_enter();
    time->canonical = 1;
    fmpq_t low, high;
    fmpq_init(low);
    fmpq_init(high);
    bounds_in_motion_parameter(low, high, time);
    if (algebraic_is_rational(&time->u)) {
        set_rational(time, low);
    } else {
        find_minimal_polynomial(time, low, high);
        if (fmpz_poly_degree(time->poly) == 1) {
            fmpq_set_fmpz_frac(low, time->poly->coeffs, time->poly->coeffs + 1);
            fmpq_neg(low, low);
            set_rational(time, low);
        } else {
            find_widest_interval(time, low, high);
        }
    }
    fmpq_clear(low);
    fmpq_clear(high);
}
