/* Cover by a germ below or above a plane about the point, by its leading term.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_HALF_H
#define GRAZE_TOPO_HALF_H

#include "questions/topo/germ.h"
#include "questions/topo/quarter.h"

/** The plane across a normal through a point, with a basis h, k. */
typedef struct open_plane {
    const fmpq *point;
    const fmpz *normal;
    fmpz basis[2][3];
} open_plane;

/** Ways in which a germ may cover: as it is at its time, or an edge by both its sides; else the
 * side (way - 1) / 2, of an edge of even order in two parts. */
enum { HALF_WAYS = 5 };

/**
 * Find how a germ covers the side below the plane (sign -1) or above it (1).
 * @param[out] found 0 if nothing is known of it
 * @param[out] out   initialised
 */
graze_status half_of_germ(int *found, half_germ *out, const open_plane *h, graze_context *context,
                          germ *g, int sign, int way);

#endif
