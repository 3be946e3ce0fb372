/* The sides of a contact: the trajectory's leading directions, and whether the cover is exact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SIDES_H
#define GRAZE_TOPO_SIDES_H

#include <flint/fmpq_poly.h>
#include "decide/trace/trajectory.h"
#include "questions/topo/germ.h"

/** Do the planes of the cone keep their directions about P throughout a piece (proofs/topology.md
 * C51)?
 * @param[out] same_way 1 if moreover the trajectory's distances from them, each divided by the
 * factor of its plane's normal, are multiples of one function of time */
int planes_keep_directions(int *same_way, const local_cone *cone, const point_map *map,
                           const trajectory *path);

/** Set the trajectory's distance from plane j of the cone, times a positive function of time. */
void distance_from_plane(fmpz_poly_t out, const local_cone *cone, size_t j, const trajectory *path);

/** Does a germ's cell, an edge of E^3, keep its direction about P throughout a piece? */
int edge_keeps_direction(const germ *g, const point_map *map);

/** Add the side after (sign 1) or before (sign -1) a germ's rational time, if the trajectory leaves
 * the cell there.
 * @param way the trajectory's displacement from its place at that time, times a positive function,
 * in powers of the time since then */
graze_status sides_add(germ *g, graze_context *context, const point_map *map, fmpq_poly_t *way,
                       int same_way, int sign);

#endif
