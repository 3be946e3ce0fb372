/* A line of CSV cut into its fields.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DELIMITED_FIELD_H
#define GRAZE_DELIMITED_FIELD_H

#include <stddef.h>
#include "graze/core.h"

/** Bytes of a text, not ended by a NUL. */
typedef struct field {
    const char *start;
    size_t length;
} field;

/** A field's length and start for `%.*s`, cut after 40 bytes. */
#define FIELD_SHOWN(f) ((f).length > 40 ? 40 : (int)(f).length), (f).start

/** Without the blanks around it. */
field field_trimmed(field f);
/** The content of a field: without the blanks around it, and without the quotes around what is
 * left. Doubled quotes stay as they are. */
field field_content(field f);
int field_is(field f, const char *text);
int field_equal(field a, field b);
/** Read a whole number of digits alone, at most `most`; 0 if the field is none. */
int field_count(unsigned long *out, field f, unsigned long most);

/** Take the next line from the front of a text, without its line end. */
field field_line(field *rest);
/** The bytes behind a key that begins a line, perhaps none; 0 if the line begins otherwise. */
int field_behind(field *out, field line, const char *key);

/** The key and the value of a line `# key value`, without the blanks around them; either may be
 * empty. */
void field_note(field *key, field *value, field line);

/**
 * Take a field from the front of a line, with the blanks and quotes it stands in. A quote opens a
 * quoted field at its beginning only.
 * @param rest what is left of the line; its start is NULL after the last field
 * @return 0 if a quoted field does not end before a comma or the line's end
 */
int field_take(field *out, field *rest);

/** The fields of one line, with their blanks and quotes; zeroed at first. */
typedef struct fields {
    field *item;
    size_t count, capacity;
} fields;

typedef enum fields_result { FIELDS_CUT, FIELDS_OPEN_QUOTE, FIELDS_NO_MEMORY } fields_result;

/** Cut a line at the commas outside quotes. The fields point into the line. */
fields_result fields_cut(fields *out, field line);
/** Separator of a table's fields, by its first line: a comma, where it has none a semicolon, where
 * it has neither a blank, which stands for any run of blanks and tabs. A line of one field: a
 * comma.
 */
char field_separator(field line);
/** Cut line `number` of the file `name` at the separators outside quotes.
 * @return GRAZE_EINPUT a quoted field does not end, or the line holds a byte 0; GRAZE_ESYSTEM */
graze_status fields_read(fields *out, graze_context *context, const char *name,
                         unsigned long number, field line, char separator);
void fields_clear(fields *f);

#endif
