/* The trajectory of one point on one piece of a motion: P carried by a point map, as integer
 * polynomials. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_TRAJECTORY_H
#define GRAZE_TRACE_TRAJECTORY_H

#include "input/motion/motion.h"
#include "input/solid/tree.h"

/**
 * c(u) = (X_0, ..., X_(d-1)) / W, u in [0, 1]. Invariant: W > 0 on [0, 1]; degree is at least the
 * degree of each polynomial, and at least 0.
 */
typedef struct trajectory {
    int dimension;
    slong degree;
    fmpz_poly_struct x[4]; /* X_0 ... X_(d-1), and W at index d */
} trajectory;

void trajectory_init(trajectory *c, int dimension);
void trajectory_clear(trajectory *c);

/** The trajectory under a map of a point given as d + 1 homogeneous integers, the last one
 * positive. */
void trajectory_carry(trajectory *c, const point_map *map, const fmpz *point);
/** The trajectory under a map of a point of d rationals. */
void trajectory_set(trajectory *c, const point_map *map, const fmpq *point);

/** The pullback of a form (proofs/claims.md C9): the sum of form[i] x[i]. */
void trajectory_pullback(fmpz_poly_t out, const trajectory *c, const fmpz *form);

/** c(u) as d + 1 homogeneous integers, the last one positive. */
void trajectory_at(fmpz *out, const trajectory *c, const fmpq_t u);

/**
 * A box that holds a piece of the curve, from the Bernstein coefficients of its d + 1 polynomials
 * on the piece, all to the trajectory's degree. Past the range of doubles its ends are infinite.
 * @return 1; or 0, and a box of all space, where a coefficient of W is not positive
 *         (proofs/claims.md C23): then a smaller piece may have a smaller box
 */
int trajectory_bound(box *out, const trajectory *c, const fmpz *bernstein);

#endif
