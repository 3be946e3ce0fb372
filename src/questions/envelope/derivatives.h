/* The derivatives of the trajectories through the points of the body, as polynomials of time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * On a piece the trajectory c of M(u) y has at u, c(u) = y, the derivatives c^(k) = Phi_k (y, 1) /
 * Delta^k for k = 1, 2, 3, with matrices Phi_k of d rows and d + 1 columns of polynomials and
 * Delta > 0 on [0, 1] (proofs/events.md C77).
 */
#ifndef GRAZE_ENVELOPE_DERIVATIVES_H
#define GRAZE_ENVELOPE_DERIVATIVES_H

#include "input/motion/motion.h"
#include "questions/envelope/cells.h"

enum { FIELD_ORDERS = 3 };

/** `vertex` has, for each vertex of the cells and each order, Phi_k (X, W) for its homogeneous
 * integers: d polynomials. */
typedef struct derivatives {
    const cell_complex *cells;
    int dimension;
    fmpz_poly_struct entry[FIELD_ORDERS][POINT_MAP_ENTRIES];
    fmpz_poly_struct delta;
    fmpz_poly_struct *vertex;
} derivatives;

/** @param[out] out uninitialised; field_clear in any case */
graze_status piece_field_make(derivatives *out, graze_context *context, const motion_piece *piece,
                              const cell_complex *cells);
void derivatives_clear(derivatives *f);

/** The components of Phi_k at a vertex, 1 <= k <= 3: d polynomials. */
const fmpz_poly_struct *derivatives_at(const derivatives *f, int k, size_t vertex);

/** The velocity g of a facet at a vertex, -n Phi_1 for its outward normal: g times a positive
 * function. */
void derivatives_velocity(fmpz_poly_t out, const derivatives *f, size_t facet, size_t vertex);
/** n Phi_k at a vertex: for k = 2 theta, for k = 3 the third derivative, where those before are 0,
 * times positive functions. */
void derivatives_along(fmpz_poly_t out, const derivatives *f, int k, size_t facet, size_t vertex);

#endif
