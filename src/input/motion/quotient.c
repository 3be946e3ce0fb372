/* Rational functions of one variable over Q, with the limits acting at every step.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/motion/affine.h"

#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "base/number/modular.h"

enum { OPERATION_WORK = 8 };    /* work of an operation, beside that of its result's words */
enum { LONG_WORDS = 64 };       /* of a coefficient for which a common divisor doubles the work */
enum { ROOT_REFINEMENTS = 12 }; /* halvings of a root's interval, for a message */

void quotients_init(quotients *q) {
    for (int k = 0; k < 4; k++)
        fmpz_poly_q_init(q->at[k]);
}

void quotients_clear(quotients *q) {
    for (int k = 0; k < 4; k++)
        fmpz_poly_q_clear(q->at[k]);
}

void calculation_spend(calculation *c, unsigned long work) {
    if (c->status != GRAZE_OK)
        return;
    unsigned long limit = c->context->limits[GRAZE_LIMIT_WORK];
    if (c->context->work > limit || work > limit - c->context->work) {
        c->status = context_limit(c->context, GRAZE_LIMIT_WORK,
                                  "the functions of a motion, all pieces together");
        return;
    }
    c->context->work += work;
}

static unsigned long longest_bits(const fmpz_poly_t p) {
    return (unsigned long)labs(fmpz_poly_max_bits(p));
}

static unsigned long work_of(const fmpz_poly_t p, unsigned long bits) {
    unsigned long words = bits / FLINT_BITS + 1;
    return (unsigned long)fmpz_poly_length(p) * (words + words * words / LONG_WORDS);
}

unsigned long polynomial_work(const fmpz_poly_t p) {
    return work_of(p, longest_bits(p));
}

static void check(calculation *c, const fmpz_poly_t p) {
    const unsigned long *limits = c->context->limits;
    if (c->status != GRAZE_OK)
        return;
    if (fmpz_poly_degree(p) > (slong)limits[GRAZE_LIMIT_DEGREE]) {
        c->status =
            context_limit(c->context, GRAZE_LIMIT_DEGREE, "the degree of a rational function");
        return;
    }
    /* 3.322 > log2(10), so a number of `digits` digits always passes. */
    unsigned long bits = longest_bits(p);
    if (bits > limits[GRAZE_LIMIT_DIGITS] * 3322 / 1000 + 1)
        c->status =
            context_limit(c->context, GRAZE_LIMIT_DIGITS, "a coefficient of a rational function");
    calculation_spend(c, work_of(p, bits));
}

void polynomial_check(calculation *c, const fmpz_poly_t p) {
    check(c, p);
    calculation_spend(c, OPERATION_WORK);
}

void quotient_check(calculation *c, const fmpz_poly_q_t a) {
    check(c, fmpz_poly_q_numref(a));
    check(c, fmpz_poly_q_denref(a));
    calculation_spend(c, OPERATION_WORK);
}

void quotient_add(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b) {
    if (c->status == GRAZE_OK) {
        fmpz_poly_q_add(out, a, b);
        quotient_check(c, out);
    }
}

void quotient_sub(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b) {
    if (c->status == GRAZE_OK) {
        fmpz_poly_q_sub(out, a, b);
        quotient_check(c, out);
    }
}

void quotient_mul(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b) {
    if (c->status == GRAZE_OK) {
        fmpz_poly_q_mul(out, a, b);
        quotient_check(c, out);
    }
}

void quotient_div(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_poly_q_t b) {
    if (c->status != GRAZE_OK)
        return;
    if (fmpz_poly_q_is_zero(b)) {
        c->status = context_fail(c->context, GRAZE_EINPUT, "division by the zero function");
        return;
    }
    fmpz_poly_q_div(out, a, b);
    quotient_check(c, out);
}

void quotient_reduce(fmpz_poly_q_t a) {
    fmpz_poly_struct *top = fmpz_poly_q_numref(a), *bottom = fmpz_poly_q_denref(a);
    if (fmpz_poly_is_zero(top) || !polynomials_certainly_coprime(top, bottom)) {
        fmpz_poly_q_canonicalise(a);
        return;
    }
    LOCAL_VEC(fmpz, content, 2);
    fmpz *other = content + 1;
    fmpz_poly_content(content, bottom);
    fmpz_poly_content(other, top);
    fmpz_gcd(content, content, other);
    if (fmpz_sgn(fmpz_poly_lead(bottom)) < 0)
        fmpz_neg(content, content);
    if (!fmpz_is_one(content)) {
        fmpz_poly_scalar_divexact_fmpz(top, top, content);
        fmpz_poly_scalar_divexact_fmpz(bottom, bottom, content);
    }
}

/* 1 if p is an integer times q, or q is an integer that divides p. 0 says nothing. */
static int is_plain_multiple(const fmpz_poly_t p, const fmpz_poly_t q) {
    slong n = fmpz_poly_degree(p);
    const fmpz *lead = fmpz_poly_lead(q);
    int number = fmpz_poly_degree(q) == 0;
    if ((!number && fmpz_poly_degree(q) != n) || !fmpz_divisible(fmpz_poly_lead(p), lead))
        return 0;
    LOCAL_VEC(fmpz, factor, 2);
    fmpz *value = factor + 1;
    fmpz_divexact(factor, fmpz_poly_lead(p), lead);
    int holds = 1;
    for (slong k = 0; k < n && holds; k++) {
        if (number) {
            holds = fmpz_divisible(p->coeffs + k, lead);
        } else {
            fmpz_mul(value, factor, q->coeffs + k);
            holds = fmpz_equal(value, p->coeffs + k);
        }
    }
    return holds;
}

/* Denominators of one motion are often integers, or integer multiples of one polynomial: then no
 * common divisor of polynomials is computed. */
void polynomial_widen(fmpz_poly_t common, const fmpz_poly_t other) {
    if (is_plain_multiple(common, other))
        return;
    if (is_plain_multiple(other, common)) {
        fmpz_poly_set(common, other);
        return;
    }
    LOCAL_VEC(fmpz, content, 2);
    fmpz *factor = content + 1;
    LOCAL(fmpz_poly, left);
    LOCAL(fmpz_poly, right);
    fmpz_poly_content(content, common);
    fmpz_poly_content(factor, other);
    fmpz_poly_scalar_divexact_fmpz(left, common, content);
    fmpz_poly_scalar_divexact_fmpz(right, other, factor);
    if (fmpz_poly_is_one(right) || fmpz_poly_equal(left, right) || fmpz_poly_is_one(left)) {
        fmpz_lcm(factor, content, factor);
        fmpz_poly_scalar_mul_fmpz(common, fmpz_poly_is_one(left) ? right : left, factor);
    } else {
        fmpz_poly_lcm(common, common, other);
    }
}

void polynomial_narrow(fmpz_poly_t g, const fmpz_poly_t p) {
    if (fmpz_poly_is_zero(p))
        return;
    if (fmpz_poly_is_zero(g)) {
        fmpz_poly_set(g, p);
        return;
    }
    if (fmpz_poly_degree(g) > 0 && !polynomials_certainly_coprime(g, p)) {
        fmpz_poly_gcd(g, g, p);
        return;
    }
    LOCAL(fmpz, content);
    fmpz_poly_content(content, g);
    for (slong k = fmpz_poly_length(p); k-- > 0 && !fmpz_is_one(content);)
        fmpz_gcd(content, content, p->coeffs + k);
    fmpz_poly_set_fmpz(g, content);
}

void polynomial_divide(fmpz_poly_t out, const fmpz_poly_t p, const fmpz_poly_t divisor) {
    if (fmpz_poly_is_one(divisor)) {
        fmpz_poly_set(out, p);
    } else if (fmpz_poly_degree(divisor) == 0) {
        fmpz_poly_scalar_divexact_fmpz(out, p, fmpz_poly_lead(divisor));
    } else if (fmpz_poly_degree(divisor) == fmpz_poly_degree(p)) {
        LOCAL(fmpz, factor);
        fmpz_divexact(factor, fmpz_poly_lead(p), fmpz_poly_lead(divisor));
        fmpz_poly_set_fmpz(out, factor);
    } else {
        fmpz_poly_div(out, p, divisor);
    }
}

void quotient_over(fmpz_poly_t out, const fmpz_poly_q_t a, const fmpz_poly_t common) {
    polynomial_divide(out, common, fmpz_poly_q_denref(a));
    fmpz_poly_mul(out, out, fmpz_poly_q_numref(a));
}

/* The exponent's bits are taken from the highest down, so that no power above the result is ever
 * made and the limits stop a large one after a few squarings. */
void quotient_power(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a, const fmpz_t n) {
    LOCAL(fmpz_poly_q, one);
    LOCAL(fmpz_poly_q, base);
    LOCAL(fmpz, size);
    fmpz_poly_q_one(one);
    fmpz_poly_q_set(base, a);
    fmpz_abs(size, n);
    fmpz_poly_q_one(out);
    for (ulong bit = fmpz_bits(size); bit-- > 0 && c->status == GRAZE_OK;) {
        quotient_mul(c, out, out, out);
        if (fmpz_tstbit(size, bit))
            quotient_mul(c, out, out, base);
    }
    if (fmpz_sgn(n) < 0)
        quotient_div(c, out, one, out);
}

void quotient_set_rational(fmpz_poly_q_t out, const fmpq_t value) {
    fmpz_poly_set_fmpz(fmpz_poly_q_numref(out), fmpq_numref(value));
    fmpz_poly_set_fmpz(fmpz_poly_q_denref(out), fmpq_denref(value));
}

void quotient_set_line(fmpz_poly_q_t out, const fmpq_t low, const fmpq_t high) {
    LOCAL(fmpq, step);
    LOCAL(fmpz, value);
    fmpq_sub(step, high, low);
    fmpz_poly_zero(fmpz_poly_q_numref(out));
    fmpz_mul(value, fmpq_numref(low), fmpq_denref(step));
    fmpz_poly_set_coeff_fmpz(fmpz_poly_q_numref(out), 0, value);
    fmpz_mul(value, fmpq_numref(step), fmpq_denref(low));
    fmpz_poly_set_coeff_fmpz(fmpz_poly_q_numref(out), 1, value);
    fmpz_mul(value, fmpq_denref(step), fmpq_denref(low));
    fmpz_poly_set_fmpz(fmpz_poly_q_denref(out), value);
    quotient_reduce(out);
}

void quotient_at(fmpq_t out, const fmpz_poly_q_t a, const fmpq_t u) {
    LOCAL(fmpq, denominator);
    fmpz_poly_evaluate_fmpq(denominator, fmpz_poly_q_denref(a), u);
    fmpz_poly_evaluate_fmpq(out, fmpz_poly_q_numref(a), u);
    fmpq_div(out, out, denominator);
}

/* Horner's scheme. */
static void substitute_polynomial(calculation *c, fmpz_poly_q_t out, const fmpz_poly_t p,
                                  const fmpz_poly_q_t line) {
    LOCAL(fmpz_poly_q, coefficient);
    fmpz_poly_q_zero(out);
    for (slong k = fmpz_poly_degree(p); k >= 0 && c->status == GRAZE_OK; k--) {
        fmpz_poly_q_one(coefficient);
        fmpz_poly_set_fmpz(fmpz_poly_q_numref(coefficient), fmpz_poly_get_coeff_ptr(p, k));
        quotient_mul(c, out, out, line);
        quotient_add(c, out, out, coefficient);
    }
}

void quotient_substitute(calculation *c, fmpz_poly_q_t out, const fmpz_poly_q_t a,
                         const fmpz_poly_q_t line) {
    LOCAL(fmpz_poly_q, denominator);
    substitute_polynomial(c, out, fmpz_poly_q_numref(a), line);
    substitute_polynomial(c, denominator, fmpz_poly_q_denref(a), line);
    quotient_div(c, out, out, denominator);
}

/* Numerator and denominator are coprime in Z[u], which factors uniquely; so a is a square exactly
 * if both are. */
int quotient_square_root(fmpz_poly_q_t out, const fmpz_poly_q_t a) {
    return fmpz_poly_sqrt(fmpz_poly_q_numref(out), fmpz_poly_q_numref(a)) &&
           fmpz_poly_sqrt(fmpz_poly_q_denref(out), fmpz_poly_q_denref(a));
}

graze_status polynomial_root(int *found, fmpq_t low, fmpq_t high, graze_context *context,
                             const fmpz_poly_t p) {
    *found = 0;
    if (fmpz_poly_degree(p) <= 0)
        return GRAZE_OK;
    HELD(dyadic_interval, unit);
    dyadic_interval_set_si(&unit, 0, 1);
    HELD(algebraic_list, roots);
    TRY(algebraic_roots(&roots, context, p, &unit));
    *found = roots.count > 0;
    for (int k = 0; k < ROOT_REFINEMENTS && *found; k++)
        algebraic_refine(&roots.item[0]);
    if (*found)
        algebraic_bounds(low, high, &roots.item[0]);
    return GRAZE_OK;
}
