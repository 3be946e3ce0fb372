/* Golden rows that rounding makes equal.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_ROUNDED_ROWS_H
#define GRAZE_COMPARE_ROUNDED_ROWS_H

#include "output/compare/key.h"

/**
 * Refuse two golden rows that rounding makes equal and whose answers in `columns` differ. The table
 * is read again, several times if digests would take more than 160 MB.
 * @param key     columns of numbers
 * @param columns count columns whose answers matter
 */
graze_status match_rounding(graze_context *context, const table *golden, const char *path,
                            const row_key *key, const column *columns, size_t count);

#endif
