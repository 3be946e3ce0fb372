/* Bernstein coefficients of squares and products. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DISTANCE_BERNSTEIN_SQUARE_H
#define GRAZE_DISTANCE_BERNSTEIN_SQUARE_H

#include "decide/filter/normal.h"

/** Degrees up to here have their products taken. */
enum { SQUARED = 20, SQUARE_ROOM = 2 * SQUARED + 5 };

/** A computed coefficient of a product errs by at most this times the greatest of each factor's
 * coefficients (proofs/distance.md C69). */
#define SQUARE_ERROR (128 * UNIT_ROUNDING)

/** Down and up by more than the roundings of a short chain of operations. */
#define ROUNDED_DOWN (1 - 0x1p-48)
#define ROUNDED_UP (1 + 0x1p-48)

/** The 2n + 1 coefficients of the square of a polynomial, of |.|^2 of a vector function, and of a
 * scalar product; n <= SQUARED + 1. */
void square_numbers(double *out, const double *c, int n);
void square_vectors(double *out, const double (*c)[3], int n);
void product_vectors(double *out, const double (*a)[3], const double (*c)[3], int n);

#endif
