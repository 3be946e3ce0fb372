/* Squarefree and coprime parts of curves.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * If two polynomials have a common factor that depends on y, their values on each line x = c have
 * one, provided that the degree in y of one of them does not drop there; likewise with x. So one
 * line without a common factor, even modulo a prime, proves that there is none.
 */
#include "base/context/scope.h"
#include "base/number/modular.h"
#include "questions/topo/eliminate.h"

/* A curve is factored, in a tenth of a second, if its degree squared times the bits of its largest
 * coefficient is at most this. */
enum { FACTORED = 100000 };

/* The c of the line on which common factors are excluded. */
enum { LINE = 1000003 };

static ulong largest_bits(const fmpz_mpoly_t g) {
    slong bits = fmpz_mpoly_max_bits(g);
    return (ulong)FLINT_ABS(bits);
}

/* Is it certain that curve a has no common factor that depends on the variable with curve b or, if
 * b is NULL, with the derivative of a? */
static int is_coprime_in(const fmpz_mpoly_t a, const fmpz_mpoly_t b, int variable,
                         const fmpz_mpoly_ctx_t ring) {
    if (fmpz_mpoly_degree_si(a, variable, ring) < 1 ||
        (b && fmpz_mpoly_degree_si(b, variable, ring) < 1))
        return 1;
    LOCAL(fmpz_poly, f);
    LOCAL(fmpz_poly, g);
    HELD(sliced_curve, s, a, variable, ring);
    ZEROED(sliced_curve, other);
    if (b)
        sliced_curve_init(&other, b, variable, ring);
    else
        sliced_init_derivative(&other, &s);
    return sliced_at(f, &s, &(fmpz){LINE}) && sliced_at(g, &other, &(fmpz){LINE}) &&
           polynomials_certainly_coprime(f, g);
}

static int is_coprime(const fmpz_mpoly_t a, const fmpz_mpoly_t b, const fmpz_mpoly_ctx_t ring) {
    return is_coprime_in(a, b, RING_X, ring) && is_coprime_in(a, b, RING_Y, ring);
}

/* Is a curve small enough for the limit, so that its common factors are found in a fraction of a
 * second? */
static int is_bounded(const graze_context *context, const fmpz_mpoly_t g,
                      const fmpz_mpoly_ctx_t ring) {
    ulong degree = (ulong)fmpz_mpoly_total_degree_si(g, ring);
    return degree * largest_bits(g) <= context->limits[GRAZE_LIMIT_BITS];
}

/* Append the squarefree, pairwise coprime parts of one curve. */
static graze_status split_curve(curve_list *out, int *refused, graze_context *context,
                                const fmpz_mpoly_t curve) {
    const fmpz_mpoly_ctx_struct *ring = out->ring;
    ulong degree = (ulong)fmpz_mpoly_total_degree_si(curve, ring);
    int small = degree * degree * largest_bits(curve) <= FACTORED;
    if (!small && is_coprime(curve, NULL, ring))
        return curves_append(out, context, curve);
    if (!small && !is_bounded(context, curve, ring)) {
        *refused = 1;
        return GRAZE_OK;
    }
    IN_RING(fmpz_mpoly_factor, factors, ring);
    if (!(small ? fmpz_mpoly_factor(factors, curve, ring)
                : fmpz_mpoly_factor_squarefree(factors, curve, ring)))
        return context_fail(context, GRAZE_EINTERNAL, "a curve of a sweep is not factored");
    for (slong k = 0; k < fmpz_mpoly_factor_length(factors, ring); k++)
        TRY(curves_append(out, context, factors->poly + k));
    return GRAZE_OK;
}

/* Divide part k and a curve by their common factor d, which becomes a part. The curve is coprime to
 * all parts before k. */
static graze_status take_common(curve_list *parts, graze_context *context, size_t k,
                                fmpz_mpoly_t curve, const fmpz_mpoly_t d) {
    fmpz_mpoly_struct *part = &parts->item[k];
    if (!fmpz_mpoly_divides(curve, curve, d, parts->ring) ||
        !fmpz_mpoly_divides(part, part, d, parts->ring))
        return context_fail(context, GRAZE_EINTERNAL, "a common factor of curves is none");
    if (!fmpz_mpoly_is_fmpz(part, parts->ring))
        return curves_append(parts, context, d);
    fmpz_mpoly_set(part, d, parts->ring);
    return GRAZE_OK;
}

/* Add a squarefree curve to the parts. */
static graze_status refine(curve_list *parts, int *refused, graze_context *context,
                           fmpz_mpoly_t curve) {
    size_t count = parts->count;
    IN_RING(fmpz_mpoly, d, parts->ring);
    for (size_t k = 0; k < count && !*refused; k++) {
        if (fmpz_mpoly_is_fmpz(curve, parts->ring) ||
            is_coprime(&parts->item[k], curve, parts->ring))
            continue;
        if (!is_bounded(context, curve, parts->ring) ||
            !is_bounded(context, &parts->item[k], parts->ring))
            *refused = 1;
        else if (!fmpz_mpoly_gcd(d, &parts->item[k], curve, parts->ring))
            return context_fail(context, GRAZE_EINTERNAL, "a common factor is not found");
        else if (!fmpz_mpoly_is_fmpz(d, parts->ring))
            TRY(take_common(parts, context, k, curve, d));
        TRY(context_poll(context));
    }
    return *refused ? GRAZE_OK : curves_append(parts, context, curve);
}

graze_status coprime_add(curve_list *parts, int *refused, graze_context *context,
                         const fmpz_mpoly_t curve) {
    HELD(curve_list, own);
    TRY(split_curve(&own, refused, context, curve));
    for (size_t k = 0; k < own.count && !*refused; k++)
        TRY(refine(parts, refused, context, &own.item[k]));
    return GRAZE_OK;
}
