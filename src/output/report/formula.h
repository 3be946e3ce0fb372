/* Rational functions, polynomials and numbers as a person reads them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_FORMULA_H
#define GRAZE_REPORT_FORMULA_H

#include "base/number/text.h"
#include "input/motion/motion.h"

/** Append a coordinate of the trajectory on a piece as a rational function of the motion's
 * parameter in lowest terms, such as `(2*t^2 - 1)/(t^2 + 1)`. A long one is shortened, with the
 * number of terms left out.
 */
void formula_coordinate(text *out, const motion_piece *piece, const point_map *map, int coordinate,
                        const fmpq *point);
/** Append an integer polynomial in t, highest power first; shortened like a coordinate. */
void formula_polynomial(text *out, const fmpz_poly_t polynomial);
/** Append a rational; if it has many digits, the middle ones are replaced by their number. */
void formula_rational(text *out, const fmpq_t value);

#endif
