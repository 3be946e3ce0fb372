/* The cone of a solid at one of its points, asked about directions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Vectors are d integers; a positive factor does not matter.
 */
#ifndef GRAZE_TOPO_CONE_H
#define GRAZE_TOPO_CONE_H

#include "input/solid/planes.h"

/** The cone at a point. `normal` has the outward or inward normals of the `count` different planes
 * of the facets that contain it. Answers are kept: the state of a direction depends on its signs
 * against these planes alone (proofs/claims.md C1). */
typedef struct local_cone {
    const graze_solid *solid;
    int outside;              /* it is that of the closure of the solid's complement */
    const plane_list *planes; /* of all facets */
    int dimension;
    fmpz *at;      /* the point: d + 1 homogeneous integers, the last one positive */
    slong nearest; /* a direction of b bits, times 2^-(nearest + b), reaches no plane that does not
                      hold the point, in units of its last coordinate */
    size_t count;
    fmpz *normal; /* d of each */
    size_t known, known_capacity;
    signed char *known_item; /* signs, then the state */
    int knows_all;           /* every cell of the planes' arrangement is known */
} local_cone;

/** The cone at a point; cone_clear in any case, also of zeros.
 * @param outside 1: of the closure of the solid's complement, with I and O exchanged */
graze_status cone_make(local_cone *cone, graze_context *context, const graze_solid *solid,
                       int outside, const plane_list *planes, const fmpz *at);
void cone_clear(local_cone *cone);

/** The state of the points that follow next to the point in a direction. */
graze_status cone_state(graze_state *out, local_cone *cone, graze_context *context,
                        const fmpz *direction);

/** 1 and the state of directions with these signs against the planes if it is known, else 0. */
int cone_knows(graze_state *out, const local_cone *cone, const signed char *signs);

/** The dimension of the cell of the facets' planes that holds the point. */
int cone_cell_dimension(const local_cone *cone);

/** Whether one of the directions u + s e, s >= 0, is in the interior, and whether one is in the
 * cone.
 * @param ray NULL, or a direction: then the cone near that direction is asked, seen from there */
graze_status cone_sweep(int *in_interior, int *in_cone, local_cone *cone, graze_context *context,
                        const fmpz *ray, const fmpz *u, const fmpz *e);

/** Is one of the directions u + s e, s of either sign, in the interior? */
graze_status cone_meets_line(int *out, local_cone *cone, graze_context *context, const fmpz *u,
                             const fmpz *e);

#endif
