/* The sign of a polynomial at a real algebraic number.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_SIGN_H
#define GRAZE_NUMBER_SIGN_H

#include "base/number/algebraic.h"

/** Set *out to the sign of q at x: -1, 0, 1 (proofs/claims.md C27). */
graze_status algebraic_sign_at(int *out, graze_context *context, const fmpz_poly_t q, algebraic *x);

#endif
