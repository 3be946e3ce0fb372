/* The head of a table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TYPED_HEAD_H
#define GRAZE_TABLE_TYPED_HEAD_H

#include "output/table/typed.h"

/** Take a `#` line of the head: dimension, grid and box, each once. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status typed_head_line(typed_table *t, field line);
/** GRAZE_EINPUT unless all lines that the head must have were taken. */
graze_status typed_head_end(const typed_table *t);
/** 1 if the grid has as many points as there are rows, or there is no grid. */
int typed_grid_fits(const typed_table *t);

#endif
