/* The signed distances of cells: their bands of colour, level lines and the border of the set.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The side of a cell's centre is exact. Its distance is within 1/64 of the cell's side.
 */
#ifndef GRAZE_DRAW_LEVELS_H
#define GRAZE_DRAW_LEVELS_H

#include "output/draw/class_grid.h"

/** Find answers and distances of all centres, choose the step of the levels, and set the tones. */
graze_status cells_measure(cells *c, graze_context *context, const graze_scene *scene);

/** The multiple k of the step as a decimal; 0 without memory. */
enum { LEVEL_ROOM = 24 };
int level_text(char out[LEVEL_ROOM], const cells *c, int k);
/** The distances of a band, such as `-2 to -1`; 0 without memory. */
enum { BAND_ROOM = 64 };
int band_text(char out[BAND_ROOM], const cells *c, tone t);

#endif
