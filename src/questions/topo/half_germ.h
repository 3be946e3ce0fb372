/* The part of a germ on one side of a plane, as a form on the plane's directions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_HALF_GERM_H
#define GRAZE_TOPO_HALF_GERM_H

#include <flint/fmpq_poly.h>
#include "base/number/algebraic.h"

/** A chart of the directions of the plane with the basis h, k: the parameter b in [-1, 1] stands
 * for h + b k, with `swapped` for b h + k; with `opposite` for the negative of these. Four charts
 * cover the plane's directions. */
typedef struct direction_chart {
    int swapped, opposite;
} direction_chart;

/** The half of a germ below or above the plane. Write a place near the point as x + z N, with x in
 * the plane. The germ covers z < Q(x)^(1/m), with `above` z > Q(x)^(1/m), up to terms smaller than
 * this leading one. Q is a form of degree m + 1; the root has the sign of Q (proofs/topology.md
 * C55, proofs/gaps.md C89). The statement is valid at the x where the linear form `reach` is
 * positive and the linear form `turn` is not negative, where these are given. */
typedef struct half_germ {
    int above;
    slong order;      /* m */
    fmpq_poly_t form; /* Q(h + b k) as a polynomial in b */
    int has_reach, has_turn;
    fmpq_poly_t reach, turn;
} half_germ;

void half_init(half_germ *half);
void half_clear(half_germ *half);

/** Write a form in a chart, as a polynomial in b times a positive number.
 * @param form the form of this degree at h + b k, as a polynomial in b */
void half_in_chart(fmpz_poly_t out, const fmpq_poly_t form, slong degree, direction_chart chart);

/** Is the germ's form valid at a parameter of the chart? */
graze_status half_is_valid(int *out, const half_germ *half, graze_context *context,
                           direction_chart chart, algebraic *at);

#endif
