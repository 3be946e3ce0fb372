/* The sides of a time of contact: where the trajectory goes, and what is exact about it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SIDES_H
#define GRAZE_TOPO_SIDES_H

#include <flint/fmpq_poly.h>
#include "decide/trace/trajectory.h"
#include "questions/topo/germ.h"

/** Do the planes of the germ's cone keep their directions on a piece, and are then the
 * trajectory's distances from them, each divided by its plane's factor, multiples of one function
 * (proofs/topology.md C51)?
 * @param[out] same_way the latter; 0 without the former */
int planes_keep_directions(int *same_way, const local_cone *cone, const point_map *map,
                           const trajectory *path);

/** The trajectory's distance from plane j of the cone, times a positive function of time. */
void distance_from_plane(fmpz_poly_t out, const local_cone *cone, size_t j, const trajectory *path);

/** Does the edge of E^3 that is a germ's cell keep its direction about the point on a piece? */
int edge_keeps_direction(const germ *g, const point_map *map);

/**
 * Add the side after (sign 1) or before (-1) a germ's rational time, if the trajectory leaves the
 * cell there.
 * @param way of the trajectory from its place at that time, times a positive function, in powers of
 * the time that has passed
 */
graze_status sides_add(germ *g, graze_context *context, const point_map *map, fmpq_poly_t *way,
                       int same_way, int sign);

#endif
