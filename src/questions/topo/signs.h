/* Directions that are known by their signs against a cone's planes alone: signs of polynomials at a
 * real algebraic number. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SIGNS_H
#define GRAZE_TOPO_SIGNS_H

#include "questions/topo/germ.h"

/** A normal, pulled back, in a direction about the point: a function of time, times a positive one.
 */
void signs_pull_back(fmpz_poly_t out, const point_map *map, const fmpz *normal,
                     const fmpz *direction);

/** The state of directions with these signs, one for each plane; there are such directions. B where
 * the cone has too many cells to know it. */
graze_status signs_state(graze_state *out, local_cone *cone, graze_context *context,
                         const signed char *signs);

/** 1 in *covered if a part of a germ with a root may cover a direction about the point
 * (proofs/topology.md C53). */
graze_status signs_cover_at_root(int *covered, germ *g, graze_context *context,
                                 const fmpz *direction, int part);

/** 1 in *covered if the solid lies in the direction at some time strictly inside the turning
 * stretch with the germ g. */
graze_status signs_cover_in_turn(int *covered, turning_stretch *t, germ *g, graze_context *context,
                                 const fmpz *direction);

#endif
