/* Narrowing the interval of a real algebraic number.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_REFINE_H
#define GRAZE_NUMBER_REFINE_H

#include "base/number/algebraic.h"

/** Halvings tried before a gcd is asked whether refinement would ever end; digits that a secant is
 * first tried with. */
enum { CHEAP_HALVINGS = 4, FIRST_GAIN = 4 };

/* Functions that take many steps ask the context's callback now and then and narrow no interval
 * past the limit `bits`: they return GRAZE_OK, GRAZE_ECANCELED or GRAZE_ELIMIT. The context may be
 * NULL, for neither. Without GRAZE_OK the numbers keep their values, and *out is not set. */

/** Halve the interval. */
void algebraic_refine(algebraic *x);

/**
 * Narrow the interval by the secant through its ends (proofs/claims.md C30): by 2^*gain where the
 * secant points close enough to the root, and then *gain is doubled; else halve the interval, and
 * *gain is halved. Repeated, it doubles the number of known digits each time in the end.
 * @param[in,out] gain at least 1; 4 to start with
 */
void algebraic_refine_quadratically(algebraic *x, ulong *gain);

/** GRAZE_ELIMIT: the ends of an interval have reached the limit of binary places. */
graze_status algebraic_bits_limit(graze_context *context);

/** GRAZE_ELIMIT if the interval's ends have reached the limit of binary places. */
graze_status algebraic_may_narrow(graze_context *context, const dyadic_interval *interval);

/** Narrow the interval: by halves for the first steps, which are numbered from 0, then by secants.
 * @param[in,out] gain as above, FIRST_GAIN to start with */
graze_status algebraic_narrow(graze_context *context, algebraic *x, int step, ulong *gain);

#endif
