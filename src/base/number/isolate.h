/* The real roots of an integer polynomial.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_ISOLATE_H
#define GRAZE_NUMBER_ISOLATE_H

#include "base/number/algebraic.h"

/**
 * Append all real roots of q in a closed interval, each once, ascending (proofs/claims.md C24,
 * C25). After a failure some may be missing.
 * @param q zero is taken as a constant that has none
 */
graze_status algebraic_roots(algebraic_list *list, graze_context *context, const fmpz_poly_t q,
                             const dyadic_interval *interval);

#endif
