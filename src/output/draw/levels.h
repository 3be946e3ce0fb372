/* The signed distances of cells: their bands of colour, level lines and the border of the set.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The side of a cell's centre is exact. Its distance is within 1/64 of the cell's side, and level
 * lines are interpolated between centres.
 */
#ifndef GRAZE_DRAW_LEVELS_H
#define GRAZE_DRAW_LEVELS_H

#include "output/draw/class_grid.h"

/** Find answers and distances of all centres, choose the step of the levels, and set the tones. */
graze_status cells_measure(cells *c, graze_context *context, const graze_scene *scene);

/** Add the line on which the distance is k steps, k not 0. */
void level_path(drawn_path *out, const cells *c, const panel *p, int k);
/** Add the borders between neighbouring cells of different answers. */
void border_path(drawn_path *out, const cells *c, const panel *p);

/** The multiple k of the step as a decimal; 0 without memory. */
enum { LEVEL_ROOM = 24 };
int level_text(char out[LEVEL_ROOM], const cells *c, int k);
/** The distances of a band, such as `-2 to -1`; 0 without memory. */
enum { BAND_ROOM = 64 };
int band_text(char out[BAND_ROOM], const cells *c, tone t);

#endif
