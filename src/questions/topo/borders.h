/* The central arrangement of the planes (E^2: lines) at which what germs cover can change.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_BORDERS_H
#define GRAZE_TOPO_BORDERS_H

#include "questions/topo/germ.h"

/** Most planes and rays of an arrangement that is looked at. */
enum { BORDER_PLANES = 60, BORDER_RAYS = 3000 };

/** Normals of the planes, d integers each, no two parallel; they span all directions. `rays` are
 * those in which d - 1 of the planes meet, each once: every cell has one in its closure. */
typedef struct borders {
    int dimension;
    size_t plane_count, plane_capacity, ray_count, ray_capacity;
    fmpz *plane, *ray;
} borders;

void borders_init(borders *b, int dimension);
void borders_clear(borders *b);

/** The planes of all germs and their sides, in directions about P, and the rays.
 * @param[out] refused 1 if there are too many: then the arrangement is not whole */
graze_status borders_find(borders *b, int *refused, graze_context *context, germ_list *germs);

/** The arrangement of planes in the directions of a germ's body that contain one direction, at
 * which what the germ covers can change, as seen along that direction (E^3). That is ray 0. */
graze_status borders_about(borders *b, graze_context *context, germ *g, const fmpz *direction);

/** The arrangement of a cone's own planes, with its rays. */
graze_status borders_of_cone(borders *b, int *refused, graze_context *context,
                             const local_cone *cone);

/**
 * A direction in each cell of dimension d, and (E^3) d - 1, whose closure has ray `r` in it, in
 * order around the ray: cell 2 k has dimension d, cell 2 k + 1 lies between it and the next.
 * In E^2 there are two, and nothing between them.
 * @param[out] out `*count` times d integers, for _fmpz_vec_clear with *count d
 */
void borders_around(fmpz **out, size_t *count, const borders *b, size_t r);

#endif
