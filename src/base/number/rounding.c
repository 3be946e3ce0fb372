/* Rationals and binary floats: rounding to a format, bounds in doubles, exact values of doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * MPFR rounds by integer arithmetic, so the host's floating-point environment has no influence.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include "base/context/scope.h"
#include "base/number/dyadic.h"
#include "base/number/rounding.h"

/* A binary format: its precision, and the exponents of MPFR's convention (|x| < 2^exponent) of its
 * smallest subnormal and its largest number. */
typedef struct binary_format {
    int precision;
    mpfr_exp_t least, largest;
} binary_format;

static const binary_format formats[] = {
    [GRAZE_ROUND_BINARY64] = {53, -1073, 1024}, [GRAZE_ROUND_BINARY32] = {24, -148, 128}};

graze_status rational_round(fmpq_t value, graze_context *context, graze_rounding rounding) {
    if (rounding == GRAZE_ROUND_NONE || fmpq_is_zero(value))
        return GRAZE_OK;
    const binary_format *format = &formats[rounding];
    mpfr_exp_t emin = mpfr_get_emin(), emax = mpfr_get_emax();
    LOCAL_MPFR(x, format->precision);
    mpfr_set_emin(format->least);
    mpfr_set_emax(format->largest);
    int inexact = fmpq_get_mpfr(x, value, MPFR_RNDN);
    mpfr_subnormalize(x, inexact, MPFR_RNDN);
    int overflows = mpfr_inf_p(x);
    mpfr_set_emin(emin);
    mpfr_set_emax(emax);
    LOCAL(mpq, exact);
    if (!overflows) {
        mpfr_get_q(exact, x);
        fmpq_set_mpq(value, exact);
    }
    return overflows ? context_fail(context, GRAZE_EINPUT, "overflows %s when rounded",
                                    graze_rounding_name(rounding))
                     : GRAZE_OK;
}

graze_status rational_nearest(double *out, graze_context *context, const fmpq_t value) {
    LOCAL(fmpq, rounded);
    fmpq_set(rounded, value);
    graze_status status = rational_round(rounded, context, GRAZE_ROUND_BINARY64);
    *out = status == GRAZE_OK ? fmpq_get_d(rounded) : 0;
    return status;
}

graze_status rational_from_double(fmpq_t out, graze_context *context, double value) {
    uint64_t image;
    memcpy(&image, &value, sizeof image);
    int exponent = (int)(image >> 52 & 0x7ff);
    uint64_t mantissa = image & 0xfffffffffffff;
    fmpq_zero(out);
    if (exponent == 0x7ff) {
        return context_fail(context, GRAZE_EINPUT, "%s is not a number; expected a finite double",
                            mantissa != 0 ? "NaN" : "an infinity");
    }
    mantissa |= exponent > 0 ? (uint64_t)1 << 52 : 0;
    fmpz_set_ui(fmpq_numref(out), mantissa);
    rational_shift(out, (exponent > 0 ? exponent : 1) - 1075);
    if (image >> 63)
        fmpq_neg(out, out);
    return GRAZE_OK;
}

void rational_bounds(double *low, double *high, const fmpq_t value) {
    *low = *high = 0;
    if (fmpq_is_zero(value))
        return;
    slong places = (slong)fmpz_bits(fmpq_denref(value)) - 1;
    if (fmpz_bits(fmpq_numref(value)) <= DBL_MANT_DIG && places <= DBL_MANT_DIG &&
        (slong)fmpz_val2(fmpq_denref(value)) == places) {
        *low = *high = ldexp(fmpz_get_d(fmpq_numref(value)), -(int)places);
        return;
    }
    LOCAL_MPFR(x, DBL_MANT_DIG);
    int inexact = fmpq_get_mpfr(x, value, MPFR_RNDZ) != 0;
    mpfr_abs(x, x, MPFR_RNDZ);
    double below = 0, above = DBL_MIN; /* subnormal doubles may read as 0 */
    if (mpfr_get_exp(x) > 1024) {
        below = DBL_MAX;
        above = INFINITY;
    } else if (mpfr_get_exp(x) > -1022) {
        below = mpfr_get_d(x, MPFR_RNDZ);
        if (inexact)
            mpfr_nextabove(x);
        above = mpfr_get_d(x, MPFR_RNDU);
    }
    *low = fmpq_sgn(value) > 0 ? below : -above;
    *high = fmpq_sgn(value) > 0 ? above : -below;
}
