/* The curves near a point: the coprime parts through it, and a square around it without other
 * events. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_NEAR_H
#define GRAZE_TOPO_NEAR_H

#include "questions/topo/plane.h"

/** Invariant (proofs/topology.md C48), with P at the origin and r = 2^-places: in the square |x|,
 * |y| <= r the curves of the list that this was made of have no zeros but those of `through`. The
 * polynomials of `through` are squarefree, pairwise coprime and vanish at the origin. For 0 < |x|
 * <= r their real roots in y are simple and distinct, their number does not depend on |x|, and none
 * is x or -x unless it is so for all x. All of this holds with x and y exchanged too. */
typedef struct near_curves {
    curve_list through;
    ulong places;
} near_curves;

/** Begin without curves, with r = 1. */
void near_init(near_curves *n);
void near_clear(near_curves *n);

/** Find the parts and the square for a list of curves and a point of 2 rationals.
 * @param[out] refused 1 if r needs more than `bits` places (the context's limit), or coprime_add
 * refuses */
graze_status near_make(near_curves *n, int *refused, graze_context *context, const curve_list *all,
                       const fmpq *point);

/** The product of `through` on a side of the square, as a polynomial in the coordinate along it.
 * The side is on the line x = r or, with `negative`, x = -r; with `axis` 1 on y = r or y = -r. */
void near_side(fmpz_poly_t out, const near_curves *n, int axis, int negative);

#endif
