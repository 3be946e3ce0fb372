/* Rationals and binary floats. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_NUMBER_ROUNDING_H
#define GRAZE_NUMBER_ROUNDING_H

#include <flint/fmpq.h>
#include "base/context/context.h"

/** Round to the nearest binary64 or binary32, ties to even, subnormals included; GRAZE_ROUND_NONE
 * leaves the value as it is, as does an overflow, which returns GRAZE_EINPUT. */
graze_status rational_round(fmpq_t value, graze_context *context, graze_rounding rounding);

/** The nearest binary64, ties to even, subnormals included. An overflow sets *out to 0 and returns
 * GRAZE_EINPUT. */
graze_status rational_nearest(double *out, graze_context *context, const fmpq_t value);

/** Set `out` to the exact value of a finite double; GRAZE_EINPUT for NaN and infinities. */
graze_status rational_from_double(fmpq_t out, graze_context *context, double value);

/**
 * Bounds in doubles: *low <= value <= *high, whatever the rounding mode, FTZ and DAZ are. They are
 * a few ulps apart; below the normal doubles they are 0 and DBL_MIN, past the range DBL_MAX and
 * infinity, with the value's sign.
 */
void rational_bounds(double *low, double *high, const fmpq_t value);

#endif
