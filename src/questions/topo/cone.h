/* The local cone of a solid at a boundary point: the states of the directions there.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vectors are d integers, up to a positive factor.
 */
#ifndef GRAZE_TOPO_CONE_H
#define GRAZE_TOPO_CONE_H

#include "input/solid/planes.h"

/** A cone. `normal` has the normals, outward or inward, of the `count` distinct planes of the
 * facets that contain the point. The state of a direction depends only on its signs against these
 * planes (proofs/claims.md C1), so states are kept by signs. */
typedef struct local_cone {
    const graze_solid *solid;
    int outside;              /* 1: the cone of the closure of the solid's complement */
    const plane_list *planes; /* of all facets */
    int dimension;
    fmpz *at;      /* the point: d + 1 homogeneous integers, the last one positive */
    slong nearest; /* a direction with entries of b bits, times 2^-(nearest + b), in units of the
                      last coordinate, reaches no plane off the point */
    size_t count;
    fmpz *normal; /* d integers each */
    size_t known, known_capacity;
    signed char *known_item; /* for each kept answer the signs, then the state */
    int knows_all;           /* the states of all cells of the arrangement are kept */
} local_cone;

/** Make the cone at a point. The caller calls cone_clear in any case; it takes zeros too.
 * @param outside 1: make the cone of the closure of the solid's complement: I and O are exchanged
 */
graze_status cone_make(local_cone *cone, graze_context *context, const graze_solid *solid,
                       int outside, const plane_list *planes, const fmpz *at);
void cone_clear(local_cone *cone);

/** The state of the points near the cone's point in a direction from it. */
graze_status cone_state(graze_state *out, local_cone *cone, graze_context *context,
                        const fmpz *direction);

/** 1 and the state of the directions with these signs against the planes, if it is kept; else 0. */
int cone_knows(graze_state *out, const local_cone *cone, const signed char *signs);

/** The dimension of the cell of the facets' planes that holds the point. */
int cone_cell_dimension(const local_cone *cone);

/** Is one of the directions u + s e, s >= 0, in the cone's interior, and is one in the cone?
 * @param ray if not NULL: ask the cone's own local cone at this direction instead */
graze_status cone_sweep(int *in_interior, int *in_cone, local_cone *cone, graze_context *context,
                        const fmpz *ray, const fmpz *u, const fmpz *e);

/** Is one of the directions u + s e, for any s, in the cone's interior? */
graze_status cone_meets_line(int *out, local_cone *cone, graze_context *context, const fmpz *u,
                             const fmpz *e);

#endif
