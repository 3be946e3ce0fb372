/* Directions that separate corners, or the simplices below two nodes, during an interval of time,
 * in doubles with proved bounds (proofs/collision.md C108).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_APART_H
#define GRAZE_COLLIDE_APART_H

#include "questions/collide/control_maps.h"
#include "questions/collide/solid_pair.h"

/** Corners first, first + 1, ... of a simplex, in cyclic order. */
typedef struct corner_run {
    uint32_t simplex;
    int first, count;
} corner_run;

/** A bound of the sum of the errors of a moved and of a standing corner in doubles; infinite if
 * none is known. */
double error_of_places(const solid_pair *pair, const control_maps *maps);

/** Are the convex hulls of some corners of the moving and of the fixed solid certainly disjoint
 * during the interval of the maps?
 * @param error from error_of_places */
int corners_apart(const solid_pair *pair, const control_maps *maps, corner_run moving,
                  corner_run fixed, double error);

/** Are all simplices below two nodes certainly disjoint, by the nodes' slabs? */
int slabs_apart(const solid_pair *pair, const control_maps *maps, uint32_t moving, uint32_t fixed,
                double error);

#endif
