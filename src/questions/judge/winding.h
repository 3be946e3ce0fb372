/* What a mesh says of a point: its winding number there, and whether it has the point inside.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_WINDING_H
#define GRAZE_JUDGE_WINDING_H

#include "questions/judge/judged_mesh.h"

/** Where a point is. Inside is where the winding number is not 0, or odd, by the mesh's rule
 * (proofs/mesh.md C114). */
typedef enum mesh_place {
    MESH_IN,
    MESH_ON, /* on a triangle with area, whatever the rule */
    MESH_OUT,
    MESH_UNTOLD /* GRAZE_MESH_NONE: off the mesh, and the mesh has no inside */
} mesh_place;

/**
 * Locate a point exactly. Threads may share the mesh.
 * @param[out] winding the winding number for GRAZE_MESH_WINDING at points off the mesh, else 0
 * @param point 3 canonical rationals
 */
mesh_place judged_place(long *winding, const judged_mesh *m, const fmpq *point);

/** Set the least and the greatest winding number beside some triangles of the mesh, on both sides
 * of each: exact, but more may be elsewhere. */
void judged_windings(judged_mesh *m);

#endif
