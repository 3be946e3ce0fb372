/* Cross products of differences of points, from which areas, turns and normals come.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_CROSS_H
#define GRAZE_NUMBER_CROSS_H

#include <flint/fmpq.h>

/** (q_i - p_i)(r_j - p_j) - (q_j - p_j)(r_i - p_i): twice the area of the triangle p, q, r in the
 * coordinates i and j, positive if it runs counter-clockwise. */
void cross_integers(fmpz_t out, const fmpz *p, const fmpz *q, const fmpz *r, int i, int j);
void cross_rationals(fmpq_t out, const fmpq *p, const fmpq *q, const fmpq *r, int i, int j);

#endif
