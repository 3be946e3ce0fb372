/* The curves near a point: those through it as parts without common factors, and a square around it
 * in which nothing else happens.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_NEAR_H
#define GRAZE_TOPO_NEAR_H

#include "questions/topo/plane.h"

/**
 * Invariant (proofs/topology.md C48): with P at the origin and r = 2^-places, no curve of the list
 * that this was made of meets the square |x|, |y| <= r but in the zeros of `through`; these are
 * squarefree, pairwise coprime, vanish at the origin, and while 0 < |x| <= r the real roots in y
 * of all of them are simple, distinct, of a number that does not depend on |x|, and none is x or -x
 * but where it is so for all x; and the same with x and y exchanged.
 */
typedef struct near_curves {
    curve_list through;
    ulong places;
} near_curves;

/** Zeros: no curve, r = 1. */
void near_init(near_curves *n);
void near_clear(near_curves *n);

/**
 * Fill for the curves of a list and a point of 2 rationals.
 * @param[out] refused 1 where r would need more than `bits` places (the context's limit), or
 *                     coprime_add refuses
 */
graze_status near_make(near_curves *n, int *refused, graze_context *context, const curve_list *all,
                       const fmpq *point);

/**
 * The product of the curves on a side of the square as a polynomial of the coordinate along it: on
 * the line x = r or, with `negative`, x = -r; with `axis` 1 the line y = r or y = -r.
 */
void near_side(fmpz_poly_t out, const near_curves *n, int axis, int negative);

#endif
