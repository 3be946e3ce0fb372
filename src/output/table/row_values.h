/* Rows of values: an answer in the binary form that tables of one type a column are made of.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A row is its coordinates, each the nearest double; codes of 32 bits for pmc and, in this order,
 * class, definition (0 for ext), case, i and t, those that the table has; its word, if it has
 * one; and where there are further columns these, comma-joined. A text is its length and its bytes.
 * All is as in memory, without gaps.
 */
#ifndef GRAZE_TABLE_ROW_VALUES_H
#define GRAZE_TABLE_ROW_VALUES_H

#include <stdint.h>
#include "base/number/text.h"

/** The nearest double, ties to even. GRAZE_EINPUT: it is past binary64. */
graze_status values_nearest(double *out, graze_context *context, const fmpq_t value);

void values_coordinate(text *out, double value);
void values_code(text *out, uint32_t code);
void values_text(text *out, const char *bytes, size_t length);

#endif
