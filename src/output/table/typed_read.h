/* Rows of values, read into typed columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_TYPED_READ_H
#define GRAZE_TABLE_TYPED_READ_H

#include "output/table/typed.h"

/** Set the columns of a table: the names that its head has, comma-joined. */
graze_status typed_begin(typed_table *t, int dimension, field names, int pmc_alone);
/**
 * Add rows of values. The rounding of the context has no effect: numbers of further columns do not
 * belong to the scene.
 * @return GRAZE_EINPUT they are not whole rows of these columns, or a number is past binary64;
 * GRAZE_ELIMIT; GRAZE_ESYSTEM
 */
graze_status typed_add(typed_table *t, const char *rows, size_t length);

#endif
