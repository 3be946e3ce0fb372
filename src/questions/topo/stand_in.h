/* Rational points with the same signs as a trajectory's place at an irrational time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_STAND_IN_H
#define GRAZE_TOPO_STAND_IN_H

#include "base/number/algebraic.h"
#include "decide/trace/trajectory.h"
#include "input/solid/planes.h"

/** The solid, the map and the trajectory for which germs are made. */
typedef struct germ_place {
    graze_context *context;
    const graze_solid *solid;
    int outside; /* 1: the complement is swept (cone_make) */
    const plane_list *planes;
    const point_map *map;
    const trajectory *path;
} germ_place;

/** Find a rational point that has the same signs against all planes of facets as the trajectory's
 * place.
 * @param[out] found 0 if no attempt succeeds
 * @param[out] x    d + 1 homogeneous integers, the last one positive
 * @param[out] near a rational time near `time` */
graze_status place_find(int *found, fmpz *x, fmpq_t near, const germ_place *place, algebraic *time);

#endif
