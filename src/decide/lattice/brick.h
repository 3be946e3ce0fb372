/* Memberships of a brick of grid points, decided for whole cells of points where possible.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_LATTICE_BRICK_H
#define GRAZE_LATTICE_BRICK_H

#include "decide/lattice/lattice.h"
#include "decide/scene/scene.h"

/** Points along an axis of a brick, in E^2 and in E^3; a brick has at most BRICK_POINTS. */
enum { BRICK_SIDE_PLANE = 64, BRICK_SIDE_SPACE = 16, BRICK_POINTS = 4096 };

/** A brick: the points from `first` to before `end` along each axis. */
typedef struct brick {
    size_t first[3], end[3];
} brick;

/**
 * Decide the points of a brick, x running fastest.
 * @param[out] pmc a graze_pmc for each point; 0 for a point that met a limit or a fault, and meets
 * it again if asked alone
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status brick_decide(unsigned char pmc[BRICK_POINTS], graze_context *context,
                          const graze_scene *scene, const lattice *l, const brick *points);

#endif
