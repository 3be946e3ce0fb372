/* Common factors of integer polynomials. A greatest common divisor modulo one prime certifies most
 * pairs as coprime; the others go to the exact one (proofs/claims.md C29).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_MODULAR_H
#define GRAZE_NUMBER_MODULAR_H

#include <flint/fmpz_poly.h>
#include "base/context/context.h"

/** Degree up to which the certificate is tried. */
enum { MODULAR_DEGREE = 127 };

/**
 * 1 if p and q certainly have no common factor of positive degree; 0 says nothing.
 * Neither is zero. Any thread.
 */
int polynomials_certainly_coprime(const fmpz_poly_t p, const fmpz_poly_t q);

/** Count the work that common_factor may be, and poll before it: nothing interrupts it. `context`
 * may be NULL. */
graze_status common_factor_work(graze_context *context, const fmpz_poly_t p, const fmpz_poly_t q);

/**
 * Greatest common divisor of p and q, neither zero, up to a constant factor.
 * @param[out] g initialised; neither p nor q
 * @return its degree; at 0, g may be any constant
 */
slong common_factor(fmpz_poly_t g, const fmpz_poly_t p, const fmpz_poly_t q);

#endif
