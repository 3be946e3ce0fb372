/* The membership of all points of a cell at once, where that is certain.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_LATTICE_CELL_ASKER_H
#define GRAZE_LATTICE_CELL_ASKER_H

#include "decide/filter/cell_walls.h"
#include "decide/filter/point_box.h"
#include "decide/scene/scene.h"

/** The state of one thread that asks for cells. */
typedef struct cell_asker {
    graze_context *context;   /* borrowed */
    const graze_scene *scene; /* borrowed; of a polyhedron */
    curve tube;
    size_t time; /* the time at which the last cell was settled */
} cell_asker;

/** Anchors with which the points of a cell may be joined. */
typedef struct anchors {
    anchor item[CERTAIN_TIMES_MOST];
    int count;
} anchors;

void cell_asker_init(cell_asker *out, graze_context *context, const graze_scene *scene);
void cell_asker_clear(cell_asker *a);

/** Are the points of a cell certainly joined with one of the anchors? Then they have the membership
 * that an anchor proves. The asker's tube is the cell's. */
int cell_joins(cell_asker *a, const point_box *points, const anchors *near);

/** Find up to CERTAIN_TIMES_MOST times at which the centre of a cell is in the state that decides a
 * membership (proofs/cells.md C76 (b)); returns their number. */
int cell_certain_times(piece_time when[CERTAIN_TIMES_MOST], const cell_asker *a,
                       const point_box *points);

/** The membership of a point that is in the deciding state at some time. */
graze_pmc cell_membership_proved(const cell_asker *a);

/** The common membership of all points of a cell; NONE if it is not certain that there is one
 * (proofs/cells.md C76).
 * @param[in,out] near anchors of a cell around this one; replaced by the cell's own, if it has some
 * @param smallest 1 if its points are asked next otherwise: then no anchors are sought, since a
 * search costs as much as a few points
 */
graze_pmc cell_decide(cell_asker *a, const point_box *points, anchors *near, int smallest);

/**
 * Ask as cell_decide does, with all tests, also of the parts of the boundary that pass through the
 * cell (proofs/judging.md C116).
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED; GRAZE_ESYSTEM also if memory is too short for a test
 */
graze_status cell_certain(graze_pmc *out, cell_asker *a, const point_box *points, anchors *near);

/** Have all points of a cell within walls certainly the membership `pmc`, in a sweep of E^3
 * (proofs/judging.md C123)?
 * @param inside one of them, three rationals
 * @return as cell_certain
 */
graze_status cell_part_has(int *out, cell_asker *a, const point_box *points,
                           const cell_walls *walls, const fmpq *inside, graze_pmc pmc);

#endif
