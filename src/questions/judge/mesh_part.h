/* Parts of a mesh, cut again and again: nodes of its tree, then triangles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_MESH_PART_H
#define GRAZE_JUDGE_MESH_PART_H

#include "questions/judge/judged_mesh.h"

enum { PART_OF_TRIANGLE = UINT32_MAX };

/** A part of the mesh, and a point of doubles near one of its points. */
typedef struct mesh_part {
    uint32_t node;    /* of the tree, or PART_OF_TRIANGLE */
    double corner[9]; /* then a triangle, each corner within `error` of that of an exact one */
    double error;     /* also: x is within it of a point of the mesh */
    double x[3];
    double radius; /* no point of the part is further from x, errors included */
} mesh_part;

/** Make the part of a node. */
void mesh_part_of_node(mesh_part *out, const judged_mesh *mesh, uint32_t node);

/** Cut a part in two. */
void mesh_part_cut(mesh_part out[2], const judged_mesh *mesh, const mesh_part *whole);

#endif
