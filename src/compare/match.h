/* Matches the rows of the candidate with those of the golden table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Both tables have the same rows in the same order, but for rows that are missing or extra. Rows
 * ahead are read only where the next ones differ, and at most MATCH_AHEAD of them.
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
    int by_id;     /* the id is the key of a row, else its point */
    int dimension; /* of the points */
    window golden, candidate;
    size_t skip_golden, skip_candidate; /* rows to hand out alone before the next pair */
    digest missing, extra;              /* sums of the keys of rows handed out alone */
    unsigned long pairs, missing_count, extra_count;
} match;

/** Choose the key of rows: `id` if both tables have it, else the point.
 * @return GRAZE_EINPUT the tables have neither in common */
graze_status match_start(match *m, graze_context *context, table *golden, table *candidate);
void match_clear(match *m);

/**
 * The next pair; either is NULL for a row without a counterpart, both at the end of both tables.
 * Borrowed until the next call.
 * @return GRAZE_EINPUT a coordinate is no number
 */
graze_status match_next(match *m, const table_row **golden, const table_row **candidate);

/** Check a matching at its end. GRAZE_EINPUT: no row has a counterpart, or the rows without one are
 * the same on both sides, in another order. */
graze_status match_finish(const match *m);

/** Make a row's key: the digest of its id, or of its point in lowest terms after rounding. */
graze_status match_key(table_row *row, graze_context *context, const table *t, int by_id,
                       int dimension);

#endif
