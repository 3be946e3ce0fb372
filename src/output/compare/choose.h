/* Choice of a comparison: the kind of tables, the columns judged, the key of rows, the groupings.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_CHOOSE_H
#define GRAZE_COMPARE_CHOOSE_H

#include "output/compare/comparison.h"

/** Choose the columns to judge and those to match rows by, and take over the golden table's
 * options.
 * @return GRAZE_EINPUT the tables do not go together, or lack columns; GRAZE_ESYSTEM */
graze_status comparison_choose(graze_comparison *c, const table *golden, const table *candidate);

/** The golden column of a grouping. */
column grouping_column(grouping g);
/** Does the golden table have that column, and does its kind of table have that grouping? */
int grouping_is_of(const graze_comparison *c, const table *golden, grouping g);

#endif
