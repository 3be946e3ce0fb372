/* The convex cells into which planes cut a cube, with exact volumes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_CUBE_CELLS_H
#define GRAZE_JUDGE_CUBE_CELLS_H

#include <flint/fmpq.h>
#include "base/context/context.h"
#include "questions/judge/cube.h"

/** Bounds of the numbers of planes, of cells, and of tetrahedra that the cells are made of. */
enum { CUBE_PLANES = 10, CUBE_CELLS = 64, CUBE_PARTS = 200 };

/** A cell of positive volume. */
typedef struct cube_cell {
    unsigned sides; /* bit k: the cell is where plane k is positive */
    fmpq at[4];     /* a point inside, and the volume */
} cube_cell;

/** Planes n x + d = 0, four numbers each, and their cells; `failed`: a bound is exceeded. */
typedef struct cube_cells {
    graze_context *context;
    int plane_count, failed;
    size_t count, capacity, parts;
    fmpq *plane;
    cube_cell *item;
} cube_cells;

/** Begin without planes. */
void cube_cells_init(cube_cells *c, graze_context *context);
void cube_cells_clear(cube_cells *c);
/** Add a plane, unless it is one of the planes, and drop the cells; n is not 0. */
void cube_cells_plane(cube_cells *c, const fmpq *plane);
/** Make the cells of a cube. @return GRAZE_ESYSTEM */
graze_status cube_cells_make(cube_cells *c, const cube *of);

#endif
