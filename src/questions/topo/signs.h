/* Directions given only by their signs against a cone's planes, which are signs of polynomials at a
 * real algebraic number. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SIGNS_H
#define GRAZE_TOPO_SIGNS_H

#include "questions/topo/germ.h"

/** The scalar product of a pulled back normal with a direction about the point, as a function of
 * time, times a positive one. */
void signs_pull_back(fmpz_poly_t out, const point_map *map, const fmpz *normal,
                     const fmpz *direction);

/** The state of the directions with given signs, one for each plane; some direction has them. The
 * state is B if the cone has too many cells. */
graze_status signs_state(graze_state *out, local_cone *cone, graze_context *context,
                         const signed char *signs);

/** Set *covered to 1 if a part of a germ with a root may cover a direction about the point
 * (proofs/topology.md C53). */
graze_status signs_cover_at_root(int *covered, germ *g, graze_context *context,
                                 const fmpz *direction, int part);

/** Set *covered to 1 if the solid lies in a direction at some time inside a turning stretch; g is
 * its germ. */
graze_status signs_cover_in_turn(int *covered, turning_stretch *t, germ *g, graze_context *context,
                                 const fmpz *direction);

#endif
