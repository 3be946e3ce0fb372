/* Motions whose positions are dyadic at dyadic places of their pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_DYADIC_MOTION_H
#define GRAZE_CONVERT_DYADIC_MOTION_H

#include <flint/fmpq.h>
#include "input/convert/conversion.h"
#include "input/motion/motion.h"

/** A motion near another one: on pieces whose entries are polynomials their coefficients, in the
 * parameter that runs from 0 to 1 along the piece, become multiples of a power of two. No entry is
 * changed by more than the tolerance, which is positive, at any time. Other pieces are kept. */
graze_status convert_dyadic(conversion *out, graze_context *context, const graze_motion *motion,
                            const fmpq_t tolerance);

#endif
