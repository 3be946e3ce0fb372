/* Narrowing the interval of a real algebraic number.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_REFINE_H
#define GRAZE_NUMBER_REFINE_H

#include "base/number/algebraic.h"

/** CHEAP_HALVINGS are made before a gcd decides whether refinement would ever end; FIRST_GAIN is
 * the number of binary places that the first secant is to gain. */
enum { CHEAP_HALVINGS = 4, FIRST_GAIN = 4 };

/* Functions that take many steps ask the context's callback now and then and narrow no interval
 * past the limit `bits`: they return GRAZE_OK, GRAZE_ECANCELED or GRAZE_ELIMIT. A context of NULL
 * has neither callback nor limit. After a failure the numbers have their values still, and *out has
 * no meaning. */

/** Halve the interval. */
void algebraic_refine(algebraic *x);

/**
 * Narrow the interval by the secant through its ends (proofs/claims.md C30): by the factor 2^*gain
 * if the secant points close enough to the root, and then *gain is doubled; else halve the
 * interval, and *gain is halved. Repeated calls in the end double the number of known digits each
 * time.
 * @param[in,out] gain at least 1; FIRST_GAIN at the first call
 */
void algebraic_refine_quadratically(algebraic *x, ulong *gain);

/** Fail with GRAZE_ELIMIT and a message: the ends of an interval have reached the limit `bits`. */
graze_status algebraic_bits_limit(graze_context *context);

/** GRAZE_ELIMIT, with a message, if the interval's ends have reached the limit `bits`, else
 * GRAZE_OK. */
graze_status algebraic_may_narrow(graze_context *context, const dyadic_interval *interval);

/** Narrow the interval: halve it in steps 0 to CHEAP_HALVINGS - 1, then use secants.
 * @param[in,out] gain as for algebraic_refine_quadratically */
graze_status algebraic_narrow(graze_context *context, algebraic *x, int step, ulong *gain);

#endif
