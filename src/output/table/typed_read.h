/* The rows of a table, read into typed columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TYPED_READ_H
#define GRAZE_TABLE_TYPED_READ_H

#include "output/table/typed.h"

/**
 * Read the next lines of the table, the last of which may lack its line end only at the table's
 * end. The rounding of the context has no effect: these numbers do not belong to the scene.
 * @return GRAZE_EINPUT it is no table of answers, or has another number of rows than it says;
 * GRAZE_ELIMIT; GRAZE_ESYSTEM; where a row is wrong, the message names row and column
 */
graze_status typed_add(typed_table *t, const char *lines, size_t length);
/** GRAZE_EINPUT unless the table is whole. */
graze_status typed_end(const typed_table *t);

#endif
