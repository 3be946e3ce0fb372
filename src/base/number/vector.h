/* Vectors of rationals, and cross products, from which areas, turns and normals come.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_VECTOR_H
#define GRAZE_NUMBER_VECTOR_H

#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>

/** out = a + b, out = a - b; `out` may be a or b. */
void vector_add(fmpq *out, const fmpq *a, const fmpq *b, int dimension);
void vector_sub(fmpq *out, const fmpq *a, const fmpq *b, int dimension);
/** out = (a + b) / 2; `out` may be a or b. */
void vector_middle(fmpq *out, const fmpq *a, const fmpq *b, int dimension);
int vector_is_zero(const fmpq *a, int dimension);
/** Set `size` to the largest absolute value of a coordinate; returns the first place that has it.
 */
int vector_widest(fmpq_t size, const fmpq *a, int dimension);
/** The lexicographic order of two points: negative, 0 or positive if a is before, equal to or
 * behind b. */
int vector_compare(const fmpq *a, const fmpq *b, int dimension);
/** Whether three points of space are on one line. */
int vector_collinear(const fmpq *a, const fmpq *b, const fmpq *c);
void vector_set(fmpq *out, const fmpq *a, int dimension);
/** out = a x b, in space; `out` is neither a nor b. */
void vector_cross(fmpq *out, const fmpq *a, const fmpq *b);
/** out = a + part (b - a); `out` may be a or b. */
void vector_between(fmpq *out, const fmpq *a, const fmpq *b, const fmpq_t part, int dimension);
/** The zero between p and q of an affine function that is `a` at p and `b` at q, which differ. */
void vector_zero(fmpq *out, const fmpq *p, const fmpq *q, const fmpq_t a, const fmpq_t b,
                 int dimension);
/** The inner product of a vector of integers and one of rationals. */
void vector_dot_integers(fmpq_t out, const fmpz *a, const fmpq *b, int dimension);
/** The image of a point under an affine map, a homogeneous matrix of size d + 1; `out` is not
 * `point`. */
void vector_image(fmpq *out, const fmpq_mat_t map, const fmpq *point, int dimension);

/** (q_i - p_i)(r_j - p_j) - (q_j - p_j)(r_i - p_i): twice the area of the triangle p, q, r in the
 * coordinates i and j, positive if it runs counter-clockwise. */
void cross_integers(fmpz_t out, const fmpz *p, const fmpz *q, const fmpz *r, int i, int j);
void cross_rationals(fmpq_t out, const fmpq *p, const fmpq *q, const fmpq *r, int i, int j);

#endif
