/* Matches the rows of the candidate with those of the golden table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Points: both tables have the same rows in the same order, but for rows that are missing or extra.
 * Rows ahead are read only where the next ones differ, and at most MATCH_AHEAD of them.
 * Contact points: rows stand in any order; those of the candidate are in memory.
 */
#ifndef GRAZE_COMPARE_MATCH_H
#define GRAZE_COMPARE_MATCH_H

#include "output/compare/key.h"
#include "output/compare/row_index.h"

enum { MATCH_AHEAD = 1000 };

/** Rows read and not yet matched, oldest first, in a ring. */
typedef struct row_window {
    table *table;
    size_t first, count;
    int ended;
    table_row rows[MATCH_AHEAD];
} row_window;

typedef struct match {
    graze_context *context;
    row_key key;
    int any_order; /* 1: rows stand in any order, and those of the candidate are in `index` */
    int indexed;   /* 1: they have been read */
    row_index index;
    row_window golden, candidate;
    size_t skip_golden, skip_candidate; /* rows to hand out alone before the next pair */
    digest missing, extra;              /* sums of the keys of rows handed out alone */
    unsigned long pairs, missing_count, extra_count;
} match;

/** Start a matching by a key. */
void match_start(match *m, graze_context *context, table *golden, table *candidate,
                 const row_key *key, int any_order);
void match_clear(match *m);

/**
 * The next pair; either is NULL for a row without a counterpart, both at the end of both tables.
 * Borrowed until the next call.
 * @return GRAZE_EINPUT a coordinate or a time is no number
 */
graze_status match_next(match *m, const table_row **golden, const table_row **candidate);

/** Check a matching at its end. GRAZE_EINPUT: no row has a counterpart, or the rows without one are
 * the same on both sides, in another order. */
graze_status match_finish(const match *m);

#endif
