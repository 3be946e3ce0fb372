/* Rows counted by group.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_TALLY_H
#define GRAZE_COMPARE_TALLY_H

#include "compare/table.h"

/** Groups past this number are counted as one. */
enum { MOST_GROUPS = 1000 };

typedef struct group {
    char *name;
    unsigned long rows, wrong, apart, missing;
} group;

typedef struct tally {
    size_t count, capacity;
    group *groups;
    group others;
} tally;

/** Count a row under its group. `status` is 'a' (agree), 'w' (wrong), 'p' (apart) or 'm' (missing).
 * @return GRAZE_ESYSTEM */
graze_status tally_add(tally *t, graze_context *context, field name, char status);
/** Order the groups by name, numbers by value. */
void tally_sort(tally *t);
void tally_clear(tally *t);

#endif
