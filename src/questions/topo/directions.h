/* Directions, as vectors of integers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_DIRECTIONS_H
#define GRAZE_TOPO_DIRECTIONS_H

#include <flint/fmpq.h>

/** out = a x b in E^3; `out` is neither. */
void directions_cross(fmpz *out, const fmpz *a, const fmpz *b);

/** In E^3: is one vector a multiple of the other? */
int directions_parallel(const fmpz *a, const fmpz *b);

/** In E^3: find h and k that span the vectors perpendicular to v, which is not 0. */
void directions_basis(fmpz *h, fmpz *k, const fmpz *v);

/** Divide n integers by their greatest common divisor. */
void direction_reduce(fmpz *v, slong n);

/** Coprime integers in the ratio of n rationals, times a positive number. */
void direction_of_rationals(fmpz *out, const fmpq *x, slong n);

#endif
