/* Integer forms of simplices: the plane through one, and the sides that cut it out of its plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_FORMS_H
#define GRAZE_SOLID_FORMS_H

#include <flint/fmpq.h>

/**
 * The plane (E^2: line) of a simplex as d + 1 coprime integers, positive on the outer side.
 * @param vertex d pointers to d rationals each, outward oriented (validate.h), not degenerate
 */
void form_of_plane(fmpz *out, const fmpq *const *vertex, int dimension);

/**
 * Side form k: d + 1 coprime integers, zero on side k, positive at the opposite vertex, without the
 * coordinate of the plane's first non-zero normal coordinate.
 */
void form_of_side(fmpz *out, const fmpq *const *vertex, const fmpz *plane, int k, int dimension);

#endif
