/* Matches the rows of the candidate with those of the golden table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_MATCH_H
#define GRAZE_COMPARE_MATCH_H

#include "output/compare/drift.h"
#include "output/compare/key.h"
#include "output/compare/row_index.h"

enum { MATCH_AHEAD = 1000 };

/** Ways to match rows. */
typedef enum match_way {
    MATCH_STREAMED, /* equal keys in the same order, but for rows that are missing or extra; rows
                       ahead are read only where the next ones differ, at most MATCH_AHEAD */
    MATCH_INDEXED,  /* equal keys in any order; the candidate's rows are in memory */
    MATCH_ORDER     /* the first row with the first one, and so on, whatever their keys */
} match_way;

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
    match_way way;
    int indexed; /* 1: the candidate's rows are in `index` */
    row_index index;
    int sites;   /* 1: rows are contact points */
    drift drift; /* of pairs that were not matched by their points */
    row_window golden, candidate;
    size_t skip_golden, skip_candidate; /* rows to hand out alone before the next pair */
    digest missing, extra;              /* sums of the keys of rows handed out alone */
    unsigned long pairs, missing_count, extra_count;
} match;

/** Start a matching. match_clear in any case, of a zeroed one too. */
void match_start(match *m, graze_context *context, table *golden, table *candidate,
                 const row_key *key, match_way way, int sites);
void match_clear(match *m);

/**
 * The next pair; either is NULL for a row without a counterpart, both at the end of both tables.
 * Borrowed until the next call.
 * @return GRAZE_EINPUT a coordinate or a time is no number
 */
graze_status match_next(match *m, const table_row **golden, const table_row **candidate);

/** At the end of a matching: the way that may give more rows a counterpart, or the same one. */
match_way match_better(const match *m);

/** Check a matching at its end. GRAZE_EINPUT: no row has a counterpart; the rows without one are
 * the same on both sides, in another order; rows without keys differ in number; an id has another
 * point. */
graze_status match_finish(const match *m);

#endif
