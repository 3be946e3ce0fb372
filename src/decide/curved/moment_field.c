/* Polynomials in the local time, and their signs at a time or along a gap.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "base/number/modular.h"
#include "decide/curved/walker.h"

void moment_field_init(moment_field *f, graze_context *context, algebraic *time, int on_gap,
                       unsigned long *work) {
    *f = (moment_field){.context = context, .time = time, .work = work};
    fmpq_poly_init(f->modulus);
    if (on_gap)
        return;
    if (algebraic_is_rational(time)) {
        fmpq_poly_set_coeff_si(f->modulus, 1, 1);
        LOCAL(fmpq, root);
        fmpq_neg(root, time->value);
        fmpq_poly_set_coeff_fmpq(f->modulus, 0, root);
        return;
    }
    f->status = common_factor_work(context, time->poly, time->poly);
    if (!f->status)
        time->low_sign = algebraic_factor(time->poly, time->poly, &time->where);
    fmpq_poly_set_fmpz_poly(f->modulus, time->poly);
}

void moment_field_clear(moment_field *f) {
    for (size_t k = 0; k < f->asked_count; k++)
        fmpz_poly_clear(&f->asked[k]);
    free(f->asked);
    fmpq_poly_clear(f->modulus);
}

static void reduce_value(value *x, const moment_field *f) {
    if (!fmpq_poly_is_zero(f->modulus) && fmpq_poly_degree(x) >= fmpq_poly_degree(f->modulus))
        fmpq_poly_rem(x, x, f->modulus);
}

void field_set(value *out, const moment_field *f, const fmpz_poly_t p) {
    fmpq_poly_set_fmpz_poly(out, p);
    reduce_value(out, f);
}

void field_charge(moment_field *f, unsigned long products, unsigned long words) {
    if (f->status)
        return;
    *f->work += words;
    f->status = *f->work > f->context->limits[GRAZE_LIMIT_WORK]
                    ? GRAZE_ELIMIT
                    : context_work(f->context, products);
}

static ulong element_words(const value *a) {
    ulong bits = (ulong)FLINT_ABS(_fmpz_vec_max_bits(a->coeffs, a->length));
    return (ulong)a->length * (bits / FLINT_BITS + 1);
}

void field_mul(value *out, moment_field *f, const value *a, const value *b) {
    ulong one = element_words(a), other = element_words(b);
    field_charge(f, one * other, (one + other) * FLINT_BIT_COUNT(one + other) / 8);
    if (f->status)
        return;
    fmpq_poly_mul(out, a, b);
    reduce_value(out, f);
}

void field_addmul(value *out, moment_field *f, const value *a, const value *b) {
    if (fmpq_poly_is_zero(a) || fmpq_poly_is_zero(b))
        return;
    LOCAL(fmpq_poly, product);
    field_mul(product, f, a, b);
    fmpq_poly_add(out, out, product);
}

void field_submul(value *out, moment_field *f, const value *a, const value *b) {
    fmpq_poly_neg(out, out);
    field_addmul(out, f, a, b);
    fmpq_poly_neg(out, out);
}

/* Keep a polynomial whose sign was asked for on a gap, divided by the kept polynomials that divide
 * it (proofs/flows.md C122). */
static void keep_asked(moment_field *f, const fmpz_poly_t p) {
    if (!fmpq_poly_is_zero(f->modulus))
        return;
    LOCAL(fmpz_poly, rest);
    fmpz_poly_primitive_part(rest, p);
    for (size_t k = 0; k < f->asked_count && !f->status; k++) {
        f->status = common_factor_work(f->context, rest, &f->asked[k]);
        fmpz_poly_remove(rest, rest, &f->asked[k]);
    }
    if (!f->status && fmpz_poly_degree(rest) > 0)
        f->status = array_grow(f->context, &f->asked, &f->asked_capacity, f->asked_count + 1,
                               sizeof *f->asked, "the signs asked along a slide");
    if (!f->status && fmpz_poly_degree(rest) > 0) {
        fmpz_poly_init(&f->asked[f->asked_count]);
        fmpz_poly_swap(&f->asked[f->asked_count++], rest);
    }
}

int field_sign(moment_field *f, const value *a) {
    int sign = 0;
    if (f->status || fmpq_poly_is_zero(a))
        return 0;
    LOCAL(fmpz_poly, numerator);
    fmpq_poly_get_numerator(numerator, a);
    if (fmpz_poly_degree(numerator) > 0)
        keep_asked(f, numerator);
    if (!f->status)
        f->status = algebraic_sign_at(&sign, f->context, numerator, f->time);
    /* On a gap the sample may be a root: the polynomial is kept, and the gap is cut there. */
    if (!f->status && sign == 0 && !fmpq_poly_is_zero(f->modulus))
        f->status =
            context_fail(f->context, GRAZE_EINTERNAL, "a number that is not zero has the sign 0");
    return f->status ? 0 : sign;
}

value *field_vector(moment_field *f, size_t count) {
    value *out = malloc((count + 1) * sizeof *out);
    if (!out && !f->status)
        f->status = context_fail(f->context, GRAZE_ESYSTEM, "out of memory for a contact");
    for (size_t k = 0; out && k < count; k++)
        fmpq_poly_init(out + k);
    return out;
}

void field_vector_clear(value *vector, size_t count) {
    for (size_t k = 0; vector && k < count; k++)
        fmpq_poly_clear(vector + k);
    free(vector);
}
