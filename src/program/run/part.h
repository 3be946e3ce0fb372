/* A part: the table or the certificate of one shard, as graze merge reads it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A part is a plain file that is open only while it is read from, so that there is no limit to how
 * many there are. Its head and its last lines are read first, and the rows are checked against
 * them: their number, their form, and the answers that belong to their words.
 */
#ifndef GRAZE_RUN_PART_H
#define GRAZE_RUN_PART_H

#include "input/delimited/stream.h"
#include "program/run/certified.h"
#include "program/run/output.h"
#include "program/run/shard.h"

typedef struct part {
    stream in;
    shard shard;
    text head; /* without the line that names the shard */
    row_form form;
    certified intervals;
    unsigned long rows, rows_of_all;
    unsigned long undecided; /* of the rows that are copied */
    char checksum[32];       /* of the points, as text */
} part;

/** Read head and last lines, and see that they fit together. Returns an exit status and says what
 * is wrong: EXIT_INPUT it is no part, or not a whole one. part_close frees it in any case. */
int part_open(part *p, graze_context *context, const char *path);
void part_close(part *p);

/** Copy the next row, which is counted if its position is undecided. EXIT_INPUT: there is none, or
 * it is none that graze writes. */
int part_copy_row(part *p, output *out);

/** 1 if the rows end with positions. */
int part_has_topo(const part *p);

/** All rows are copied. EXIT_INPUT: there are more. */
int part_end(part *p);

#endif
