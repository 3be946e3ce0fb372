/* Cover on one side of a plane about a point, as forms on the plane's directions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_QUARTER_H
#define GRAZE_TOPO_QUARTER_H

#include <flint/fmpq_poly.h>
#include "base/number/algebraic.h"

/** Directions of the plane: h + b k or, `swapped`, b h + k, and their opposites. */
typedef struct half_quarter {
    int swapped, opposite;
} half_quarter;

/** About the point a place is x + z N, x in the plane. To its leading term, up to smaller ones,
 * what is covered is z < Q(x)^(1/m), or with `above` z > Q(x)^(1/m), with the root that has the
 * sign of Q, a form of degree m + 1 (proofs/topology.md C55, proofs/gaps.md C89), at all x, or
 * where `reach`, a linear form, is positive, and where `turn` is not negative. */
typedef struct half_germ {
    int above;
    slong order;      /* m */
    fmpq_poly_t form; /* Q(h + b k) as a polynomial in b */
    int has_reach, has_turn;
    fmpq_poly_t reach, turn;
} half_germ;

void half_init(half_germ *half);
void half_clear(half_germ *half);

/** A form of a degree, given at h + b k, as a polynomial in b in a quarter, times a positive
 * number. */
void half_in_quarter(fmpz_poly_t out, const fmpq_poly_t form, slong degree, half_quarter quarter);

/** Is the germ's form valid at parameter b of the quarter? */
graze_status half_is_valid(int *out, const half_germ *half, graze_context *context,
                           half_quarter quarter, algebraic *at);

#endif
