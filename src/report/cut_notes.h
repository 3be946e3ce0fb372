/* The `#` lines of a finished table that its columns and rows are held to.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_CUT_NOTES_H
#define GRAZE_REPORT_CUT_NOTES_H

#include "report/cut_table.h"

/** What follows a key in a `#` line; 0 if the line has another. */
int cut_value(field *out, field line, const char *key);
/** GRAZE_EINPUT with the message, which says what is wrong, and what a whole table is. */
graze_status cut_broken(graze_context *context, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** Take a `#` line of the head: dimension, grid and box, each once. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status cut_note(cut_table *c, graze_context *context, field line);
/** All of the head is taken: is what must be there, there? GRAZE_EINPUT. */
graze_status cut_notes_end(const cut_table *c, graze_context *context);
/** Does the grid have that many points? 1 also where there is no grid. */
int cut_grid_has(const cut_table *c, size_t rows);

#endif
