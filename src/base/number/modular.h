/* Common factors of integer polynomials. A greatest common divisor modulo one prime certifies most
 * coprime pairs; for the other pairs the exact one is computed (proofs/claims.md C29).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_MODULAR_H
#define GRAZE_NUMBER_MODULAR_H

#include <flint/fmpz_poly.h>
#include "base/context/context.h"

/** The greatest degree for which the certificate is tried. */
enum { MODULAR_DEGREE = 127 };

/**
 * 1 if p and q certainly have no common factor of positive degree; 0 says nothing. Neither is zero.
 * Safe in any thread.
 */
int polynomials_certainly_coprime(const fmpz_poly_t p, const fmpz_poly_t q);

/** Count the work of a call of common_factor before it, as context_work does, since nothing
 * interrupts that call. `context` may be NULL. */
graze_status common_factor_work(graze_context *context, const fmpz_poly_t p, const fmpz_poly_t q);

/**
 * Greatest common divisor of p and q, neither zero, up to a constant factor.
 * @param[out] g initialised; neither p nor q
 * @return the degree of g; if it is 0, g may be any constant
 */
slong common_factor(fmpz_poly_t g, const fmpz_poly_t p, const fmpz_poly_t q);

#endif
