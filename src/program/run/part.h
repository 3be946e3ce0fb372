/* A part: the table or the certificate of one shard, as graze merge reads it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A part is a plain file that is open only while it is read from, so that there is no limit to how
 * many there are. Its head and its last lines are read first; the number of its rows and a checksum
 * of its bytes are held to these lines.
 */
#ifndef GRAZE_RUN_PART_H
#define GRAZE_RUN_PART_H

#include "input/delimited/stream.h"
#include "program/run/checksum.h"
#include "program/run/lines.h"
#include "program/run/output.h"
#include "program/run/shard.h"

typedef struct part {
    stream in;
    result_kind kind;
    shard shard;
    text head;    /* without the line that names the shard */
    field next;   /* the line behind the rows that are copied, borrowed from `in` */
    checksum sum; /* of the bytes before that line */
    unsigned long rows, rows_of_all;
    int topo; /* rows have positions; and the number of undecided ones */
    unsigned long undecided;
    unsigned long long points, bytes; /* checksums in the last lines */
} part;

/** Read head and last lines, and see that they fit together. Returns an exit status and says what
 * is wrong: EXIT_INPUT it is no part, or not a whole one. part_close frees it in any case. */
int part_open(part *p, graze_context *context, const char *path);
void part_close(part *p);

/** Copy the next row. EXIT_INPUT: there is none. */
int part_copy_row(part *p, output *out);

/** All rows are copied. EXIT_INPUT: there are more, or the part was changed. */
int part_end(part *p);

#endif
