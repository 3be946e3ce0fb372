/* Shards: the rows of one run dealt out to several.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rows are dealt like cards, one to each shard in turn: shard i of n has the rows i, i + n,
 * i + 2n, ... of the whole run, counted from 1. So the number of rows need not be known, easy
 * and hard regions are shared evenly, and the whole is put together by taking rows in turn again.
 */
#ifndef GRAZE_RUN_SHARD_H
#define GRAZE_RUN_SHARD_H

/** Notes (lines.h) that a shard's table or certificate has and a whole one lacks: the shard, in the
 * head; and before the last line the number of rows of all shards, a checksum of their points
 * (0 for a grid), and one of all bytes before it. */
#define SHARD_LINE "shard "
#define SHARD_ROWS "rows-of-all-shards "
#define SHARD_POINTS "points-checksum "
#define SHARD_BYTES "bytes-checksum "
/** Before these, in a table with positions: how many are undecided. */
#define UNDECIDED_LINE "undecided "
/** The last line, with the number of rows. */
#define COMPLETE_LINE "complete "

/** Shard `index` < `count`; one shard is the whole run. */
typedef struct shard {
    unsigned long index, count;
} shard;

/** The most shards a run is cut into. */
enum { SHARDS_MOST = 100000 };

/** Read `i/n`, 1 <= i <= n; 0 if the text is none. */
int shard_read(shard *out, const char *text);

/** The place in the whole run of the shard's row `row`; both from 0. */
unsigned long shard_place(shard s, unsigned long row);

/** How many of the first `rows` rows of the whole run are the shard's. */
unsigned long shard_rows(shard s, unsigned long rows);

#endif
