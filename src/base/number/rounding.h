/* Rationals and binary floats. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_NUMBER_ROUNDING_H
#define GRAZE_NUMBER_ROUNDING_H

#include <flint/fmpq.h>
#include "base/context/context.h"

/** Round to the nearest binary64 or binary32, ties to even, subnormals included; NONE leaves it.
 * Overflow: GRAZE_EINPUT. */
graze_status rational_round(fmpq_t value, graze_context *context, graze_rounding rounding);

/** The nearest binary64, ties to even, subnormals included. Overflow: GRAZE_EINPUT, `out` 0. */
graze_status rational_nearest(double *out, graze_context *context, const fmpq_t value);

/** The dyadic rational a finite double is; NaN and infinities are GRAZE_EINPUT. */
graze_status rational_from_double(fmpq_t out, graze_context *context, double value);

/**
 * Bounds in doubles: *low <= value <= *high, whatever the rounding mode, FTZ and DAZ are; past the
 * range of doubles they are infinite. They are within a few ulps.
 */
void rational_bounds(double *low, double *high, const fmpq_t value);

#endif
