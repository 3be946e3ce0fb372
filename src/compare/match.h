/* Which row of the candidate answers which row of the golden table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Both tables have the same rows in the same order, but for rows that are missing or too many. Rows
 * are looked ahead for only where they differ, and never more than MATCH_AHEAD of them.
 */
#ifndef GRAZE_COMPARE_MATCH_H
#define GRAZE_COMPARE_MATCH_H

#include "compare/table.h"

enum { MATCH_AHEAD = 1000 };

/** Rows read and not yet matched, oldest first, in a ring. */
typedef struct window {
    table *table;
    size_t first, count;
    int ended;
    table_row rows[MATCH_AHEAD];
} window;

typedef struct match {
    graze_context *context;
    int by_id;     /* rows are known by their id, else by their point */
    int dimension; /* of the points */
    window golden, candidate;
    size_t skip_golden, skip_candidate; /* rows to hand out alone before the next pair */
    digest missing, extra;              /* sums of the keys of rows handed out alone */
    unsigned long pairs, missing_count, extra_count;
} match;

/** Decide how rows are known: by `id` if both tables have it, else by the point.
 * @return GRAZE_EINPUT the tables have neither in common */
graze_status match_start(match *m, graze_context *context, table *golden, table *candidate);
void match_clear(match *m);

/**
 * The next pair; either is NULL for a row without a counterpart, both at the end of both tables.
 * Borrowed until the next call.
 * @return GRAZE_EINPUT a coordinate is no number
 */
graze_status match_next(match *m, const table_row **golden, const table_row **candidate);

/** At the end: is what was left over on both sides the same rows in another order, or was no row
 * met at all? Then GRAZE_EINPUT. */
graze_status match_finish(const match *m);

/** Make a row's key: the digest of its id, or of its point in lowest terms after rounding. */
graze_status match_key(table_row *row, graze_context *context, const table *t, int by_id,
                       int dimension);

#endif
