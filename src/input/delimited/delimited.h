/* delimited: lines and fields of a text file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_DELIMITED_H
#define GRAZE_INPUT_DELIMITED_H

#include <stddef.h>
#include "base/number/text.h"
#include "graze/core.h"

/* A line of CSV cut into its fields. */

/** Bytes of a text, not ended by a NUL. */
typedef struct field {
    const char *start;
    size_t length;
} field;

/** A field's length and start for `%.*s`, cut after 40 bytes. */
#define FIELD_SHOWN(f) ((f).length > 40 ? 40 : (int)(f).length), (f).start

/** The field without the blanks and tabs around it. */
field field_trimmed(field f);
/** The content of a field: the field without the blanks around it and then without the quotes
 * around it. Doubled quotes stay doubled. */
field field_content(field f);
int field_is(field f, const char *text);
int field_equal(field a, field b);
/** Read a whole number, written in digits alone and at most `most`. Returns 0 if the field is no
 * such number. */
int field_count(unsigned long *out, field f, unsigned long most);

/** Take the next line from the front of a text, without its line end. */
field field_line(field *rest);
/** Set *a and *b to the next lines at one place of two texts that differ, and step *x and *y past
 * them. Returns 0 if there are none. */
int lines_differ(field *a, field *b, const char **x, const char **y);

/** Set *out to the bytes of a line behind the key with which it begins. Returns 0 if the line does
 * not begin with the key. */
int field_behind(field *out, field line, const char *key);

/** Set the key and the value of a line `# key value`, without the blanks around them; both may be
 * empty. */
void field_note(field *key, field *value, field line);

/**
 * Take a field from the front of a line, with the blanks and quotes around it. A quote opens a
 * quoted field only if no more than blanks stand before it.
 * @param rest the rest of the line; rest->start is NULL after the last field
 * @return 0 if a quoted field does not end before a comma or the line's end
 */
int field_take(field *out, field *rest);
/** Is a name the content of a field of this line? */
int field_is_among(field name, field line);

/** The fields of one line, with their blanks and quotes. A zeroed structure is empty. */
typedef struct fields {
    field *item;
    size_t count, capacity;
} fields;

typedef enum fields_result { FIELDS_CUT, FIELDS_OPEN_QUOTE, FIELDS_NO_MEMORY } fields_result;

/** Cut a line at the commas outside quotes. The fields point into the line. */
fields_result fields_cut(fields *out, field line);
/** The separator of a table's fields, found from its first line: a comma if the line has one
 * outside quotes, else a semicolon if it has one, else a blank if it has one, which stands for any
 * run of blanks and tabs, else a comma.
 */
char field_separator(field line);
/** Cut line `number` of the file `name` at the separators outside quotes; if the separator is a
 * blank, quotes have no meaning.
 * @return GRAZE_EINPUT a quoted field does not end, or the line holds a byte 0; GRAZE_ESYSTEM */
graze_status fields_read(fields *out, graze_context *context, const char *name,
                         unsigned long number, field line, char separator);
void fields_clear(fields *f);

/* A text file, read line by line through one buffer. */

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
    long long offset;          /* in the file, of the byte behind `to` */
    unsigned long line;        /* number of the line handed out last, from 1 */
    unsigned long limit;       /* bytes of a line */
} stream;

/** Open a file that others wrote, or standard input for `-`. Lines end with LF or CRLF, a byte
 * order mark is skipped, and the limit `line` holds. `path` is borrowed. The caller calls
 * stream_close, after a failure too.
 * @return GRAZE_ESYSTEM the file cannot be opened, is a directory or a device, or memory is short
 */
graze_status stream_open(stream *out, graze_context *context, const char *path);
/** Open a file that Graze has written: lines end with LF, their length has no limit. With
 * `reopened` the file is open only while it is read from, so that any number of streams can exist.
 */
graze_status stream_open_own(stream *out, graze_context *context, const char *path, int reopened);
/** Read lines from a text in memory, which is borrowed, as by stream_open but without the limit. */
void stream_of_text(stream *out, graze_context *context, const char *name, const char *text,
                    size_t length);
void stream_close(stream *s);

/** 1 if the file can be opened and read a second time. */
int stream_repeatable(const stream *s);
/** 1 if stream_next would return without waiting. The function may read from the file. */
int stream_ready(stream *s);

/**
 * The next line without its end; borrowed until the next call. out->start is NULL at the end of the
 * file. While the function waits for bytes, it calls the cancel callback.
 * @return GRAZE_ELIMIT the line is longer than the limit `line`; GRAZE_ESYSTEM reading failed;
 * GRAZE_ECANCELED
 */
graze_status stream_next(stream *s, field *out);

/** Append the line that stream_next returned last, with its LF if it has one. The text equals the
 * file's bytes for stream_open_own alone: stream_open drops CR and the byte order mark. */
void stream_copy_line(text *to, const stream *s, field line);

/** stream_tell gives the place of the next line in the file; stream_seek goes to such a place, and
 * the count of lines goes on. */
long long stream_tell(const stream *s);
graze_status stream_seek(stream *s, long long offset);

/** Read the first bytes of a file, at most `room` less one for the NUL behind them.
 * @return GRAZE_ESYSTEM; GRAZE_ECANCELED */
graze_status stream_beginning(char *text, size_t room, size_t *length, graze_context *context,
                              const char *path);

#endif
