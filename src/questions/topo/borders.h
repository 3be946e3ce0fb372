/* The central arrangement of the planes (E^2: lines) at which the cover of directions can change.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_BORDERS_H
#define GRAZE_TOPO_BORDERS_H

#include "questions/topo/germ.h"

/** Bounds of the numbers of planes and rays of an arrangement. */
enum { BORDER_PLANES = 60, BORDER_RAYS = 3000 };

/** An arrangement. `plane`: the planes' normals, d integers each, no two parallel; they span all
 * directions. `ray`: the rays in which d - 1 planes meet, each once; the closure of every cell has
 * one of them. */
typedef struct borders {
    int dimension;
    size_t plane_count, plane_capacity, ray_count, ray_capacity;
    fmpz *plane, *ray;
} borders;

void borders_init(borders *b, int dimension);
void borders_clear(borders *b);

/** Make the arrangement of the planes of all germs and of their sides, in directions about P.
 * @param[out] refused 1 if a bound is exceeded: then the arrangement is incomplete */
graze_status borders_find(borders *b, int *refused, graze_context *context, germ_list *germs);

/** Make the arrangement of those planes of one germ that contain a direction, in directions of the
 * body (E^3). It shows where the germ's cover changes around the direction, which is ray 0. */
graze_status borders_about(borders *b, graze_context *context, germ *g, const fmpz *direction);

/** Make the arrangement of a cone's own planes. */
graze_status borders_of_cone(borders *b, int *refused, graze_context *context,
                             const local_cone *cone);

/** Give a direction in each cell around ray `r`, in order around the ray. In E^3 cell 2 k has
 * dimension 3, cell 2 k + 1 is the cell of dimension 2 after it. In E^2 there are the two cells of
 * dimension 2 beside the ray.
 * @param[out] out `*count` times d integers, for _fmpz_vec_clear with *count d */
void borders_around(fmpz **out, size_t *count, const borders *b, size_t r);

#endif
