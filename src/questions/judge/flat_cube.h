/* Cubes in which the boundary of the sweep is the mesh, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_FLAT_CUBE_H
#define GRAZE_JUDGE_FLAT_CUBE_H

#include "decide/filter/curve.h"
#include "decide/lattice/cell_asker.h"
#include "questions/judge/cube.h"
#include "questions/judge/judged_mesh.h"

/** A cube as a box and as a span; chord_meets tests the span against triangles of a mesh. */
typedef struct cube_span {
    curve shape; /* dimension and corners alone */
    box space;
    span all;
} cube_span;

void cube_span_set(cube_span *out, const cube *c, const judged_mesh *mesh);

/** Test whether the mesh is the sweep's boundary in a cube of the band (proofs/judging.md C123):
 * the planes of the few triangles there cut it into cells, and each cell is inside both mesh and
 * sweep, or outside both. The cube becomes CUBE_FLAT; or CUBE_IN or CUBE_OUT with `beside`, if all
 * cells are alike.
 * @return as cell_certain */
graze_status flat_decide(cube *c, cell_asker *ask, const judged_mesh *mesh);

/** Classify a cube below a flat one: it is flat, or, if the mesh misses it, inside or outside; it
 * is of the band if it has too many cells. */
graze_status flat_child(cube *c, graze_context *context, const judged_mesh *mesh);

/** Add the volume of a flat cube's part inside the mesh. */
graze_status flat_volume(fmpq_t sum, graze_context *context, const cube *c,
                         const judged_mesh *mesh);

#endif
