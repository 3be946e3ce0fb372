/* Directions along which corners, or what is below two nodes, are certainly apart for a while, in
 * doubles with proved bounds (proofs/collision.md C108).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_APART_H
#define GRAZE_COLLIDE_APART_H

#include "questions/collide/control_maps.h"
#include "questions/collide/solid_pair.h"

/** Corners first, first + 1, ... of a simplex, and behind the last one the first. */
typedef struct corner_run {
    uint32_t simplex;
    int first, count;
} corner_run;

/** Bound of the errors in doubles of moved and standing corners together; infinite where nothing is
 * known. */
double error_of_places(const solid_pair *pair, const control_maps *maps);

/** Are the convex hulls of corners of the moving and of the fixed solid certainly apart during the
 * interval of the maps?
 * @param error that of error_of_places */
int corners_apart(const solid_pair *pair, const control_maps *maps, corner_run moving,
                  corner_run fixed, double error);

/** Whether all simplices below two nodes are apart, by the slabs of inner nodes. */
int slabs_apart(const solid_pair *pair, const control_maps *maps, uint32_t moving, uint32_t fixed,
                double error);

#endif
