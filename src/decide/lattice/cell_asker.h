/* The membership of all points of a cell at once, where that is certain.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_LATTICE_CELL_ASKER_H
#define GRAZE_LATTICE_CELL_ASKER_H

#include "decide/filter/cell_walls.h"
#include "decide/filter/point_box.h"
#include "decide/scene/scene.h"

/** Who asks for cells: one thread's. */
typedef struct cell_asker {
    graze_context *context;   /* borrowed */
    const graze_scene *scene; /* borrowed; of a polyhedron */
    curve tube;
    size_t time; /* at which the last cell was settled */
} cell_asker;

/** Places that the points of a cell are perhaps joined with. */
typedef struct anchors {
    anchor item[CERTAIN_TIMES_MOST];
    int count;
} anchors;

void cell_asker_init(cell_asker *out, graze_context *context, const graze_scene *scene);
void cell_asker_clear(cell_asker *a);

/** Whether the points of a cell are certainly joined with one of the anchors: then they have the
 * membership that an anchor proves. The tube is that of the cell. */
int cell_joins(cell_asker *a, const point_box *points, const anchors *near);

/** Times at which the centre of a cell is in the state that decides a membership, as few as are
 * looked for (proofs/cells.md C76 (b)); returns how many are found. */
int cell_certain_times(piece_time when[CERTAIN_TIMES_MOST], const cell_asker *a,
                       const point_box *points);

/** The membership that one time in the deciding state gives. */
graze_pmc cell_membership_proved(const cell_asker *a);

/** The membership of all points of a cell; NONE if it is not known to be one (proofs/cells.md C76).
 * @param[in,out] near those of a cell around it; its own where it has some
 * @param smallest its points are next: then those around it must do, since a search costs as much
 * as some points
 */
graze_pmc cell_decide(cell_asker *a, const point_box *points, anchors *near, int smallest);

/**
 * cell_decide by every test there is, also by the parts of the boundary that pass through the cell
 * (proofs/judging.md C116).
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED; GRAZE_ESYSTEM also where memory was too short to be
 * certain
 */
graze_status cell_certain(graze_pmc *out, cell_asker *a, const point_box *points, anchors *near);

/** Whether a membership is certainly that of all points of a cell within walls (proofs/judging.md
 * C123), of a sweep in E^3.
 * @param inside one of them, three rationals
 * @return as cell_certain
 */
graze_status cell_part_has(int *out, cell_asker *a, const point_box *points,
                           const cell_walls *walls, const fmpq *inside, graze_pmc pmc);

#endif
