/* The halves of a germ below and above a plane through the point, by leading terms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_HALF_H
#define GRAZE_TOPO_HALF_H

#include "questions/topo/germ.h"
#include "questions/topo/half_germ.h"

/** The plane across a normal through a point, with a basis h, k. */
typedef struct open_plane {
    const fmpq *point;
    const fmpz *normal;
    fmpz basis[2][3];
} open_plane;

/** Ways in which a germ may cover one side of the plane: way 0 by times on both sides of the
 * contact, way 1 + 2 s + part by times on side s of it alone (germ.side). Part 1 is the second half
 * of an edge of even order. */
enum { HALF_WAYS = 5 };

/** Find how a germ covers places below the plane (sign -1) or above it (sign 1).
 * @param[out] found 0 if this way proves no cover
 * @param[out] out   initialised */
graze_status half_of_germ(int *found, half_germ *out, const open_plane *h, graze_context *context,
                          germ *g, int sign, int way);

#endif
