/* Integer forms of simplices: the plane through one, and the sides that cut it out of its plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A form is d + 1 coprime integers c; its value at the homogeneous point (X, W), W > 0, is
 * c[0] X_0 + ... + c[d-1] X_(d-1) + c[d] W.
 */
#ifndef GRAZE_SOLID_FORMS_H
#define GRAZE_SOLID_FORMS_H

#include <flint/fmpq.h>

/**
 * The plane (E^2: line) of a simplex; the first non-zero normal coordinate is positive.
 * @param vertex d pointers to d rationals each, outward oriented (validate.h), not degenerate
 * @return +1 if the form is positive on the outer side, -1 if on the inner one
 */
int form_of_plane(fmpz *out, const fmpq *const *vertex, int dimension);

/**
 * Side form k: zero on side k, positive at the opposite vertex, without the coordinate of the
 * plane's first non-zero normal coordinate.
 */
void form_of_side(fmpz *out, const fmpq *const *vertex, const fmpz *plane, int k, int dimension);

/** Sign of a form at a homogeneous point. */
int form_sign(const fmpz *form, const fmpz *x, int dimension);

/** The order of forms as lists of integers: negative, zero or positive. */
int form_compare(const fmpz *a, const fmpz *b, int dimension);

#endif
