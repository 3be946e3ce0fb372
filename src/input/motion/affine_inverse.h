/* Determinants and inverses of affine maps.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_AFFINE_INVERSE_H
#define GRAZE_MOTION_AFFINE_INVERSE_H

#include "input/motion/affine.h"

/** The determinant of the linear part. */
void affine_determinant(calculation *c, fmpz_poly_q_t out, const affine *a);
/** The inverse map; the determinant is not the zero function. `orthogonal`: the linear part is
 * known to be orthogonal. `out` is not `a`. */
void affine_inverse(calculation *c, affine *out, const affine *a, int orthogonal);

#endif
