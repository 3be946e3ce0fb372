/* What a germ covers below or above a plane about the point, by its leading term.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_HALF_H
#define GRAZE_TOPO_HALF_H

#include <flint/fmpq_poly.h>
#include "topo/germ.h"

/** The plane across a normal through a point, with a basis h, k. */
typedef struct open_plane {
    const fmpq *point;
    const fmpz *normal;
    fmpz basis[2][3];
} open_plane;

/** About the point a place is x + z N, x in the plane. To its leading term, up to smaller ones,
 * what is covered is z < Q(x)^(1/m), or with `above` z > Q(x)^(1/m), with m odd and a form Q of
 * degree m + 1 (proofs/topology.md C55). */
typedef struct half_germ {
    int above;
    slong order;      /* m */
    fmpq_poly_t form; /* Q(h + b k) as a polynomial in b */
} half_germ;

/**
 * What a germ covers below the plane (sign -1) or above it (1).
 * @param[out] found 0 if nothing is known of it
 * @param[out] out   `form` is initialised
 * @param bent       of a facet what it covers by its contact of higher order, else without turning;
 *                   for an edge 0
 */
graze_status half_of_germ(int *found, half_germ *out, const open_plane *h, graze_context *context,
                          germ *g, int sign, int bent);

#endif
