/* Joints that move uniformly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_UNIFORM_H
#define GRAZE_CONVERT_UNIFORM_H

#include "input/convert/conversion.h"
#include "input/convert/joint.h"

/** Joints that all move uniformly, cut into pieces until they are near enough. */
graze_status convert_joints(conversion *out, graze_context *context, const target *goal,
                            const joint *joints, size_t count);

/** Write the pieces of a chain cut into `pieces` equal parts of [0, 1], one text of `pieces`.
 * @param bits of each joint's angles, `count` of them
 * @return GRAZE_ECANCELED
 */
graze_status chain_pieces(text *out, graze_context *context, const target *goal,
                          const joint *joints, const slong *bits, size_t count,
                          unsigned long pieces);
/** f for the functions of angle.h at the part k/n of a joint's turn. */
void turn_fraction(fmpq_t out, const joint *j, unsigned long k, unsigned long n);
/** ceil(|degrees| / 90) and at least 1, or 0 where that exceeds the limit `pieces`. */
unsigned long quarters_above(const graze_context *context, const joint *j);

#endif
