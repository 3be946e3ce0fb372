/* A text file line by line, one buffer's worth of it in memory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DELIMITED_STREAM_H
#define GRAZE_DELIMITED_STREAM_H

#include "base/number/text.h"
#include "graze/core.h"
#include "input/delimited/field.h"

typedef struct stream {
    graze_context *context;
    const char *name; /* for messages */
    int fd;           /* -1 while there is no open file */
    int reopened;     /* the file is open only while it is read from */
    int own;          /* the file is one that Graze has written */
    int ended;        /* nothing is left to read */
    int whole;        /* the line handed out last had a line end */
    char *buffer;
    size_t capacity, from, to; /* bytes from..to are read and not yet used */
    long long offset;          /* of the file, behind `to` */
    unsigned long line;        /* number of the line handed out last, from 1 */
    unsigned long limit;       /* bytes of a line */
} stream;

/** Open a file that others wrote, or standard input for `-`. Lines end with LF or CRLF, a byte
 * order mark is skipped, and the limit `line` holds. `path` is borrowed. stream_close in any case.
 * @return GRAZE_ESYSTEM it cannot be opened, is a directory or a device, or memory is short */
graze_status stream_open(stream *out, graze_context *context, const char *path);
/** Open a file that Graze has written: lines end with LF, their length has no limit. With
 * `reopened` the file is open only while it is read from, so that there is no limit to how many
 * streams there are. */
graze_status stream_open_own(stream *out, graze_context *context, const char *path, int reopened);
/** Lines of a text in memory, which is borrowed: those of stream_open without the limit. */
void stream_of_text(stream *out, graze_context *context, const char *name, const char *text,
                    size_t length);
void stream_close(stream *s);

/** 1 if the file can be opened and read a second time. */
int stream_repeatable(const stream *s);
/** 1 if stream_next would return without waiting. May read. */
int stream_ready(stream *s);

/**
 * The next line without its end; borrowed until the next call. Its start is NULL at the end of the
 * file. While nothing is there to read, the cancel callback is asked.
 * @return GRAZE_ELIMIT it is longer than the limit `line`; GRAZE_ESYSTEM reading failed;
 * GRAZE_ECANCELED
 */
graze_status stream_next(stream *s, field *out);

/** Add a line of stream_next to a text as it stands in the file, with the end it has there. */
void stream_copy_line(text *to, const stream *s, field line);

/** The place in the file of the next line, and to go on from another; lines are counted on. */
long long stream_tell(const stream *s);
graze_status stream_seek(stream *s, long long offset);

/** Read the first bytes of a file, at most `room` less one for the NUL behind them.
 * @return GRAZE_ESYSTEM; GRAZE_ECANCELED */
graze_status stream_beginning(char *text, size_t room, size_t *length, graze_context *context,
                              const char *path);

#endif
