/* The distance from a place to a mesh, in doubles with proved bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_MESH_GAP_H
#define GRAZE_JUDGE_MESH_GAP_H

#include "questions/judge/judged_mesh.h"

/** low <= distance <= high. */
typedef struct mesh_gap {
    double low, high;
    uint32_t
        simplex; /* a triangle at a distance of at most `high`; UINT32_MAX: the mesh has none */
} mesh_gap;

/** Bounds of the distance from a point to the nearest triangle (proofs/judging.md C118); infinite
 * for an empty mesh. */
mesh_gap mesh_gap_of(const judged_mesh *mesh, const double *point);

/** An upper bound of the distances from all points of a cube to one triangle. */
double mesh_gap_of_cube(const judged_mesh *mesh, uint32_t simplex, const double *centre,
                        double half);

#endif
