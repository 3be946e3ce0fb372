/* Rotations near matrices of few digits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_NEAR_ROTATION_H
#define GRAZE_SCAD_NEAR_ROTATION_H

#include <flint/fmpq.h>
#include "base/context/context.h"

/**
 * Replace a linear part by a number times a rotation or reflection, if each entry divided by that
 * number is within the tolerance of the rotation's.
 * @param[in,out] matrix 9 entries, rows
 * @param[out] error     at least the norm of the difference; 0 if none is taken
 * @return whether one is taken; not if the matrix is such a one itself
 */
int scad_turn(fmpq *matrix, fmpq_t error, graze_context *context, const fmpq_t tolerance);

/** At least the norm of a linear part, and no more for a rotation or reflection times a rational
 * number. */
void scad_norm(fmpq_t out, const fmpq *matrix);

#endif
