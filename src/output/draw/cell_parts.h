/* Cells at borders, split into parts, so that a border has no stairs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A cell is split where one of its eight neighbours has another tone; each part is classified
 * exactly at its own centre. The middle part has the cell's centre.
 */
#ifndef GRAZE_DRAW_CELL_PARTS_H
#define GRAZE_DRAW_CELL_PARTS_H

#include "output/draw/class_grid.h"

/**
 * Split the cells at borders; of measured cells, those at borders between answers. A cell is split
 * into at most 7 parts, none smaller than 1/2600 of the grid's longer side.
 * @return GRAZE_ELIMIT more parts than the limit `grid`
 */
graze_status parts_classify(cells *c, graze_context *context, const graze_scene *scene);

/** Add the parts of a tone whose cells have another one as rectangles, one for each run. */
void parts_path(drawn_path *out, const cells *c, const panel *p, tone t);

#endif
