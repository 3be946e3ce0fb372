/* Rows counted by group.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_TALLY_H
#define GRAZE_COMPARE_TALLY_H

#include "output/compare/errors.h"
#include "output/compare/table.h"

/** Groups past this number are counted as one. */
enum { MOST_GROUPS = 1000 };

typedef struct group {
    char *name;
    unsigned long rows, wrong, undecided, missing;
    errors *values; /* NULL: none */
} group;

typedef struct tally {
    size_t count, capacity;
    group *groups;
    group others;
} tally;

/** Count a row under its group. `status` is 'a' (agree), 'w' (wrong), 'u' (undecided) or 'm'
 * (missing).
 * @param value the error of its value, or NULL
 * @return GRAZE_ESYSTEM */
graze_status tally_add(tally *t, graze_context *context, field name, char status,
                       const value_error *value);
/** Order the groups by name, numbers by value. */
void tally_sort(tally *t);
void tally_clear(tally *t);

#endif
