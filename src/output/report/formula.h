/* Rational functions, polynomials and numbers as a person reads them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_FORMULA_H
#define GRAZE_REPORT_FORMULA_H

#include "base/number/text.h"
#include "input/motion/motion.h"

/**
 * The trajectory's coordinate under a piece's map, as a rational function of the motion's parameter
 * in lowest terms, such as `(2*t^2 - 1)/(t^2 + 1)`. What is left out of a long one is said.
 */
void formula_coordinate(text *out, const motion_piece *piece, const point_map *map, int coordinate,
                        const fmpq *point);
/** An integer polynomial in t, highest power first; shortened like a coordinate. */
void formula_polynomial(text *out, const fmpz_poly_t polynomial);
/** A rational, its middle digits left out and their number said where there are many. */
void formula_rational(text *out, const fmpq_t value);

#endif
