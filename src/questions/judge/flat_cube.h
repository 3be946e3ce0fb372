/* Cubes in which the boundary of the sweep is the mesh, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_FLAT_CUBE_H
#define GRAZE_JUDGE_FLAT_CUBE_H

#include "decide/filter/curve.h"
#include "decide/lattice/cell_asker.h"
#include "questions/judge/cube.h"
#include "questions/judge/judged_mesh.h"

/** A cube as a box and a span, of which chord_meets says whether it misses triangles of a mesh. */
typedef struct cube_span {
    curve shape; /* dimension and corners alone */
    box space;
    span all;
} cube_span;

void cube_span_set(cube_span *out, const cube *c, const judged_mesh *mesh);

/**
 * Make a cube of the band CUBE_FLAT, or of one kind and `beside`, if planes of few triangles of the
 * mesh cut it into cells that are inside both the mesh and the sweep, or outside both
 * (proofs/judging.md C123).
 * @return as cell_certain
 */
graze_status flat_decide(cube *c, cell_asker *ask, const judged_mesh *mesh);

/** Decide a part of a flat cube: flat too, or inside or outside where the mesh misses it; of the
 * band where its cells are too many. */
graze_status flat_child(cube *c, graze_context *context, const judged_mesh *mesh);

/** Add the volume that is inside the mesh in a flat cube. */
graze_status flat_volume(fmpq_t sum, graze_context *context, const cube *c,
                         const judged_mesh *mesh);

#endif
