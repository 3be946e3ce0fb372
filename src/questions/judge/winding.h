/* The place of a point relative to a mesh, and its winding number.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_WINDING_H
#define GRAZE_JUDGE_WINDING_H

#include "questions/judge/judged_mesh.h"

/** The place of a point: it is inside if the winding number is not 0, or is odd, by the mesh's rule
 * (proofs/mesh.md C114). */
typedef enum mesh_place {
    MESH_IN,
    MESH_ON, /* on a triangle with area, whatever the rule */
    MESH_OUT,
    MESH_UNTOLD /* off a mesh that has no inside (GRAZE_MESH_NONE) */
} mesh_place;

/** Locate a point exactly. Threads may use the same mesh at the same time.
 * @param[out] winding the winding number for GRAZE_MESH_WINDING at points off the mesh, else 0
 * @param point 3 canonical rationals */
mesh_place judged_place(long *winding, const judged_mesh *m, const fmpq *point);

/** Set `least` and `most` from the exact winding numbers on both sides of some of the triangles;
 * elsewhere there may be other ones. */
void judged_windings(judged_mesh *m);

#endif
