/* Grids of query points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_GRID_H
#define GRAZE_RUN_GRID_H

#include "output/table/typed.h"
#include "program/run/block.h"
#include "program/run/shard.h"

/** The values of --grid and --box; NULL where not given. */
typedef struct grid_options {
    const char *sizes, *box;
} grid_options;

typedef struct grid grid;

/** Read a value of --box into d initialised rationals each. On failure says why. */
int box_read(mpq_t *low, mpq_t *high, const char *text, int d, graze_context *context);
/** Make the grid of these options, in the box of the scene unless one is given. On failure says
 * why; `*out` is to be closed in either case. */
int grid_open(grid **out, const grid_options *o, graze_context *context, const graze_scene *scene);
void grid_close(grid *g);
/** The number of its points. */
unsigned long grid_count(const grid *g);
/** Fill a block with a shard's next points, at most `most`; an empty block means the end. */
void grid_fill(const grid *g, shard part, block *b, unsigned long most);
/** Make `count` points of a shard from its point `first` on, x running fastest in the whole grid.
 * Any thread may ask.
 * @param[out] points room for three coordinates a point; d of them are set, point after point */
void grid_points(mpq_t *points, const grid *g, shard part, unsigned long first, size_t count);
/** Rows of pmc alone of these points, as graze_grid_rows. */
graze_status grid_rows(char **out, size_t *length, size_t *done, graze_context *context,
                       const grid *g, shard part, unsigned long first, size_t count,
                       graze_format format);
/** Tell a table of its rows that they are the grid's. */
void grid_shape(typed_table *t, const grid *g);
/** Add the lines `# grid` and `# box`. */
void grid_notes(text *out, const grid *g);

#endif
