/* Files of query points, cut into lines and handed out in blocks.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first thread cuts a file into lines and does nothing else with them; columns.h reads them.
 */
#ifndef GRAZE_RUN_CSV_H
#define GRAZE_RUN_CSV_H

#include "program/run/columns.h"
#include "program/run/progress.h"
#include "program/run/shard.h"

typedef struct csv csv;

/** Open a file, or standard input for `-`, for the rows of a shard. The context is
 * borrowed. On failure says why. */
int csv_open(csv **out, const char *path, int dimension, shard part, graze_context *context);
void csv_close(csv *c);
/** Before the first line is read: the rows are contact points, which are moved with `snap`. */
void csv_expect_sites(csv *c, int snap);
/**
 * Fill a block with the next rows, at most `most`; an empty block means the end. On an error, for
 * which csv_fault has the message, the rows before it are in the block. EXIT_SIGNAL when a signal
 * came first.
 */
int csv_fill(csv *c, block *b, unsigned long most);
/** 1 if csv_fill would return without waiting for its input. May read. */
int csv_ready(csv *c);
/** The error csv_fill met. */
const fault *csv_fault(const csv *c);
/** The columns, fixed once a header or a first row has been read. */
const columns *csv_columns(const csv *c);
/** How much of the file is read; unknown for a pipe. */
portion csv_portion(const csv *c);
/** Rows read so far, those of other shards too, and a checksum of the line of names and of their
 * text. */
unsigned long csv_rows(const csv *c);
unsigned long long csv_checksum(const csv *c);

#endif
