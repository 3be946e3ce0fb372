/* Signs of several polynomials all along [0, 1]: at their roots, at the ends, and between.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_AXIS_H
#define GRAZE_ENVELOPE_AXIS_H

#include "base/number/algebraic.h"

/** Numbers 0 = point[0] < ... < point[count - 1] = 1, and between two of them a rational sample:
 * sample[k] before point k, k >= 1. Every root in [0, 1] of a polynomial that is not zero is a
 * point. */
typedef struct axis {
    algebraic_list roots;
    algebraic **point;
    size_t count;
    fmpq *sample; /* count, the first unused */
} axis;

/** @param[out] out uninitialised; axis_clear in any case */
graze_status axis_make(axis *out, graze_context *context, const fmpz_poly_struct *p, size_t count);
void axis_clear(axis *x);

/** Sign of a polynomial at point k. */
graze_status axis_sign(int *out, graze_context *context, axis *x, const fmpz_poly_struct *p,
                       size_t k);
/** Its sign between points k - 1 and k, 1 <= k < count. */
int axis_sign_before(const axis *x, const fmpz_poly_struct *p, size_t k);

/** The strict sign of a polynomial on all of [0, 1], if it is cheaply seen to have one, else 0. */
int axis_one_sign(const fmpz_poly_struct *p);

#endif
