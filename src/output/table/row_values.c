/* Adds values to binary rows, in the floating-point environment of the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/table.h"

#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"

/* A double holds it. */
static int is_exact(const fmpz_t n) {
    const slong most = WORD(1) << 53;
    return !COEFF_IS_MPZ(*n) && *n >= -most && *n <= most;
}

/* If two doubles hold numerator and denominator exactly, their quotient is rounded to nearest (IEEE
 * 754); it is 0 or at least 2^-53 in size, so that it does not underflow. */
graze_status values_nearest(double *out, graze_context *context, const fmpq_t value) {
    graze_status status = GRAZE_OK;
    if (is_exact(fmpq_numref(value)) && is_exact(fmpq_denref(value)))
        *out = (double)*fmpq_numref(value) / (double)*fmpq_denref(value);
    else
        status = rational_nearest(out, context, value);
    return status ? context_fail(context, status, "expected a number that binary64 can hold")
                  : GRAZE_OK;
}

void values_coordinate(text *out, double value) {
    text_bytes(out, (const char *)&value, sizeof value);
}

graze_status values_field(text *out, graze_context *context, field number) {
    LOCAL(fmpq, value);
    graze_rounding asked = context->rounding;
    double nearest = 0;
    context->rounding = GRAZE_ROUND_NONE;
    graze_status status = rational_parse(value, context, number.start, number.length);
    context->rounding = asked;
    if (!status)
        status = values_nearest(&nearest, context, value);
    values_coordinate(out, nearest);
    return status;
}

void values_code(text *out, uint32_t code) {
    text_bytes(out, (const char *)&code, sizeof code);
}

void values_text(text *out, const char *bytes, size_t length) {
    text_bytes(out, (const char *)&length, sizeof length);
    text_bytes(out, bytes, length);
}
