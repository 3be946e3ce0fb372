/* Affine maps over two common denominators, and the point maps of such a map and of its inverse.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MOTION_COMMON_MAP_H
#define GRAZE_MOTION_COMMON_MAP_H

#include "input/motion/affine.h"

/**
 * P -> (N P) / w + B / v with polynomials of u. Invariant: w has no factor in Z[u] that all of N
 * have too, v none that all of B have; both are positive at u = 0.
 */
typedef struct common_map {
    int dimension;
    fmpz_poly_struct linear[9]; /* N, dimension * dimension in use, row by row */
    fmpz_poly_struct shift[3];  /* B */
    fmpz_poly_t w, v;
} common_map;

/** All polynomials zero, to be set. */
void common_map_init(common_map *m);
void common_map_clear(common_map *m);

/** The entry of N in row i and column j. */
fmpz_poly_struct *common_map_linear(common_map *m, int i, int j);

/** Entries times the least common multiples of their denominators, which are in lowest terms. */
void common_map_from_affine(calculation *c, common_map *out, const affine *a);
void common_map_to_affine(calculation *c, affine *out, const common_map *m);
/** Is the linear part orthogonal? It is where N^T N = w^2. 0 after a failure too. */
int common_map_is_orthogonal(calculation *c, const common_map *m);

/** The point map of m, which has no pole on [0, 1]. @param[out] out initialised */
void common_map_forward(calculation *c, point_map *out, const common_map *m);
/** The point map of m's inverse, whose linear part is the transpose, as m's is orthogonal.
 * @param[out] out initialised */
void common_map_backward(calculation *c, point_map *out, const common_map *m);

#endif
