/* Polynomials that certainly have no root in an interval, by one value in doubles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_ROOTLESS_H
#define GRAZE_NUMBER_ROOTLESS_H

#include "base/number/dyadic.h"

/** 1 if p, not zero, certainly has no root in the interval (proofs/roots.md C92); 0 says nothing,
 * and is the answer for an interval that is not in [0, 1]. Any rounding mode may be set. */
int certainly_rootless(const fmpz_poly_t p, const dyadic_interval *interval);

#endif
