/* Parts of a mesh in a recursive subdivision: nodes of its tree, then triangles and parts of them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_MESH_PART_H
#define GRAZE_JUDGE_MESH_PART_H

#include "questions/judge/judged_mesh.h"

enum { PART_OF_TRIANGLE = UINT32_MAX };

/** A part of the mesh with its reference point x, which is near a point of the part. */
typedef struct mesh_part {
    uint32_t node;    /* of the tree, or PART_OF_TRIANGLE */
    double corner[9]; /* of a triangle: its corners, each within `error` of the exact one */
    double error;     /* x too is within `error` of a point of the mesh */
    double x[3];
    double radius; /* bound of the distance of x to points of the exact part */
} mesh_part;

/** Make the part below a node of the mesh's tree. */
void mesh_part_of_node(mesh_part *out, const judged_mesh *mesh, uint32_t node);

/** Cut a part in two. */
void mesh_part_cut(mesh_part out[2], const judged_mesh *mesh, const mesh_part *whole);

#endif
