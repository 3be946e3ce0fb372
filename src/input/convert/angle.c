/* Half angles as exact pairs, by MPFR.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "input/convert/angle.h"

void half_angle_init(half_angle *h) {
    fmpq_init(h->w);
    fmpq_init(h->c);
}

void half_angle_clear(half_angle *h) {
    fmpq_clear(h->w);
    fmpq_clear(h->c);
}

void rational_to_mpfr(mpfr_t out, const fmpq_t value, mpfr_rnd_t round) {
    LOCAL(mpq, copy);
    fmpq_get_mpq(copy, value);
    mpfr_set_q(out, copy, round);
}

void mpfr_to_rational(fmpq_t out, const mpfr_t value) {
    LOCAL(mpq, copy);
    mpfr_get_q(copy, value);
    fmpq_set_mpq(out, copy);
}

int bound_exceeds(const mpfr_t bound, const fmpq_t most) {
    LOCAL(mpq, copy);
    fmpq_get_mpq(copy, most);
    return mpfr_cmp_q(bound, copy) > 0;
}

void root_above(mpfr_t out, const fmpq_t square) {
    rational_to_mpfr(out, square, MPFR_RNDU);
    mpfr_sqrt(out, out, MPFR_RNDU);
}

static void length_of(mpfr_t out, const fmpq_t square) {
    rational_to_mpfr(out, square, MPFR_RNDN);
    mpfr_sqrt(out, out, MPFR_RNDN);
}

/* 2 pi (f - the nearest integer): the reduction is exact. */
static void radians(mpfr_t out, const fmpq_t f) {
    LOCAL(fmpq, rest);
    LOCAL(fmpz, whole);
    LOCAL_MPFR(pi, ANGLE_BITS);
    fmpq_set_si(rest, 1, 2);
    fmpq_add(rest, rest, f);
    fmpz_fdiv_q(whole, fmpq_numref(rest), fmpq_denref(rest));
    fmpq_sub_fmpz(rest, f, whole);
    rational_to_mpfr(out, rest, MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul(out, out, pi, MPFR_RNDN);
    mpfr_mul_2ui(out, out, 1, MPFR_RNDN);
}

void round_to_grid(fmpq_t out, const mpfr_t value, slong bits) {
    LOCAL_MPFR(scaled, ANGLE_BITS);
    mpfr_mul_2si(scaled, value, bits, MPFR_RNDN);
    mpfr_rint(scaled, scaled, MPFR_RNDN);
    mpfr_mul_2si(scaled, scaled, -bits, MPFR_RNDN);
    mpfr_to_rational(out, scaled);
}

void half_angle_dyadic(half_angle *out, const fmpq_t f, const fmpq_t square, slong bits) {
    LOCAL_MPFR(angle, ANGLE_BITS);
    LOCAL_MPFR(value, ANGLE_BITS);
    LOCAL_MPFR(length, ANGLE_BITS);
    radians(angle, f);
    length_of(length, square);
    mpfr_cos(value, angle, MPFR_RNDN);
    round_to_grid(out->w, value, bits);
    mpfr_sin(value, angle, MPFR_RNDN);
    mpfr_div(value, value, length, MPFR_RNDN);
    round_to_grid(out->c, value, bits + mpfr_get_exp(length));
}

/* arg(w + i c L), to nearest. */
static void argument(mpfr_t out, const half_angle *h, const fmpq_t square) {
    LOCAL_MPFR(across, ANGLE_BITS);
    LOCAL_MPFR(along, ANGLE_BITS);
    length_of(out, square);
    rational_to_mpfr(across, h->c, MPFR_RNDN);
    mpfr_mul(across, across, out, MPFR_RNDN);
    rational_to_mpfr(along, h->w, MPFR_RNDN);
    mpfr_atan2(out, across, along, MPFR_RNDN);
}

static void add_slack(mpfr_t out) {
    LOCAL_MPFR(slack, 2);
    mpfr_set_ui_2exp(slack, 1, -ANGLE_SLACK, MPFR_RNDU);
    mpfr_add(out, out, slack, MPFR_RNDU);
}

/* |a - b| for two arguments, the short way round the circle. */
static void gap(mpfr_t out, const mpfr_t a, const mpfr_t b) {
    LOCAL_MPFR(turn, ANGLE_BITS);
    mpfr_const_pi(turn, MPFR_RNDN);
    mpfr_mul_2ui(turn, turn, 1, MPFR_RNDN);
    mpfr_sub(out, a, b, MPFR_RNDN);
    mpfr_abs(out, out, MPFR_RNDN);
    mpfr_sub(turn, turn, out, MPFR_RNDN);
    mpfr_abs(turn, turn, MPFR_RNDN);
    mpfr_min(out, out, turn, MPFR_RNDN);
}

void half_angle_error(mpfr_t out, const half_angle *h, const fmpq_t f, const fmpq_t square) {
    LOCAL_MPFR(asked, ANGLE_BITS);
    LOCAL_MPFR(made, ANGLE_BITS);
    if (fmpq_is_zero(f) && fmpq_is_zero(h->c) && fmpq_sgn(h->w) > 0) {
        mpfr_set_zero(out, 1);
        return;
    }
    radians(asked, f);
    argument(made, h, square);
    gap(out, asked, made);
    add_slack(out);
    mpfr_mul_2ui(out, out, 1, MPFR_RNDU);
}

/* |w + i c L|^2, exactly. */
static void norm(fmpq_t out, const half_angle *h, const fmpq_t square) {
    fmpq_mul(out, h->c, h->c);
    fmpq_mul(out, out, square);
    fmpq_addmul(out, h->w, h->w);
}

/* | |z1| - |z0| | / min(|z0|, |z1|) = sqrt(larger / smaller norm) - 1, upwards. */
static void mismatch(mpfr_t out, const half_angle *from, const half_angle *to,
                     const fmpq_t square) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    norm(low, from, square);
    norm(high, to, square);
    if (fmpq_cmp(low, high) > 0)
        fmpq_swap(low, high);
    fmpq_div(high, high, low);
    root_above(out, high);
    mpfr_sub_ui(out, out, 1, MPFR_RNDU);
}

void half_angle_apart(mpfr_t out, const half_angle *from, const half_angle *to,
                      const fmpq_t square) {
    LOCAL_MPFR(start, ANGLE_BITS);
    argument(start, from, square);
    argument(out, to, square);
    gap(out, start, out);
    add_slack(out);
}

/* With x = 2s - 1, h = b / 2 and T = tan h the argument exceeds the uniform one by g(x) = atan(x T)
 * - h x, an odd function. On [0, 1] it is not negative, and grows with h, since its derivative by h
 * is x ((1 + T^2) / (1 + x^2 T^2) - 1). Its maximum is where 1 + x^2 T^2 = T / h; at a place that
 * is d beside it g is less by at most T^3 d^2, as |g''| <= 2 T^3, and where T / h - 1 loses all
 * digits T^3 is below 2^-470. Both terms of g are between 0 and h, so b bounds 2 g where b is so
 * large that T is no small number. */
void angle_sway(mpfr_t out, const mpfr_t apart) {
    mpfr_set(out, apart, MPFR_RNDU);
    if (mpfr_cmp_d(apart, 2.8) > 0)
        return;
    LOCAL_MPFR(h, ANGLE_BITS);
    LOCAL_MPFR(tangent, ANGLE_BITS);
    LOCAL_MPFR(x, ANGLE_BITS);
    mpfr_div_2ui(h, out, 1, MPFR_RNDU);
    mpfr_tan(tangent, h, MPFR_RNDN);
    mpfr_div(out, tangent, h, MPFR_RNDN);
    mpfr_sub_ui(out, out, 1, MPFR_RNDN);
    mpfr_sqrt(out, out, MPFR_RNDN);
    mpfr_div(x, out, tangent, MPFR_RNDN);
    mpfr_mul(x, x, h, MPFR_RNDN);
    mpfr_atan(out, out, MPFR_RNDN);
    mpfr_sub(out, out, x, MPFR_RNDN);
    add_slack(out);
    mpfr_mul_2ui(out, out, 1, MPFR_RNDU);
}

/* For lengths r0 and r1 the argument is that for equal lengths at s' = s r1 / ((1 - s) r0 + s r1)
 * in place of s, and |s' - s| = s (1 - s) |r1 - r0| / ((1 - s) r0 + s r1) <= |r1 - r0| / (4 min(r0,
 * r1)). The bound adds both, doubled since the angle is twice the argument, and is at most 2
 * `apart`, as each argument is between those of z0 and z1.
 */
void half_angle_sway(mpfr_t out, const half_angle *from, const half_angle *to,
                     const fmpq_t square) {
    LOCAL_MPFR(apart, ANGLE_BITS);
    LOCAL_MPFR(share, ANGLE_BITS);
    half_angle_apart(apart, from, to, square);
    angle_sway(out, apart);
    mismatch(share, from, to, square);
    mpfr_mul(share, share, apart, MPFR_RNDU);
    mpfr_div_2ui(share, share, 1, MPFR_RNDU);
    mpfr_add(out, out, share, MPFR_RNDU);
    mpfr_mul_2ui(apart, apart, 1, MPFR_RNDU);
    mpfr_min(out, out, apart, MPFR_RNDU);
}

/* The last convergent is the approximation itself, which is within 2^-ANGLE_FINEST. */
void half_angle_convergent(half_angle *out, const fmpq_t f, const fmpq_t square,
                           const fmpq_t tolerance) {
    LOCAL_MPFR(tangent, ANGLE_BITS);
    LOCAL_MPFR(length, ANGLE_BITS);
    LOCAL_MPFR(error, ANGLE_BITS);
    LOCAL_VEC(fmpq, x, 2);
    fmpq *rest = x + 1;
    radians(tangent, f);
    mpfr_tan(tangent, tangent, MPFR_RNDN);
    length_of(length, square);
    mpfr_div(tangent, tangent, length, MPFR_RNDN);
    mpfr_to_rational(x, tangent);
    LOCAL_VEC(fmpz, term, fmpq_cfrac_bound(x));
    slong count = fmpq_get_cfrac(term, rest, x, fmpq_cfrac_bound(x)), n = 1;
    fmpq_one(out->w);
    do {
        fmpq_set_cfrac(out->c, term, n);
        half_angle_error(error, out, f, square);
    } while (bound_exceeds(error, tolerance) && n++ < count);
}
