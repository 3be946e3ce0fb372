/* A text file line by line, one buffer's worth of it in memory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TABLE_STREAM_H
#define GRAZE_TABLE_STREAM_H

#include "context/context.h"
#include "table/field.h"

typedef struct stream {
    graze_context *context;
    const char *name; /* for messages */
    int fd, ended;
    char *buffer;
    size_t capacity, from, to; /* bytes from..to are read and not yet used */
    unsigned long line;        /* number of the line handed out last, from 1 */
} stream;

/** Open a file, or standard input for `-`. `path` is borrowed. stream_close in either case.
 * @return GRAZE_ESYSTEM it cannot be opened, is a directory, or memory is short */
graze_status stream_open(stream *out, graze_context *context, const char *path);
void stream_close(stream *l);
/** 1 if the file can be opened and read a second time. */
int stream_repeatable(const stream *l);

/**
 * The next line without its end (LF or CRLF) and without a byte order mark; borrowed until the next
 * call. Its start is NULL at the end of the file.
 * @return GRAZE_ELIMIT it is longer than the limit `line`; GRAZE_EINPUT it holds a byte 0;
 * GRAZE_ESYSTEM reading failed; GRAZE_ECANCELED
 */
graze_status stream_next(stream *l, field *out);

#endif
