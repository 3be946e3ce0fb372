/* A motion as the text of a motion file of plain pieces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_WRITE_MOTION_H
#define GRAZE_MOTION_WRITE_MOTION_H

#include "base/number/text.h"
#include "input/motion/motion.h"

/** Pieces with a matrix each, whose entries are polynomials in t, or `(A)/(W)` with the piece's one
 * denominator W. */
void motion_write(text *out, const graze_motion *motion);

#endif
