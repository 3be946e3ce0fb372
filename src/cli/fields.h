/* A line of CSV cut into its fields.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CLI_FIELDS_H
#define GRAZE_CLI_FIELDS_H

#include <stddef.h>

/** Bytes of a line, not ended by a NUL. */
typedef struct field {
    const char *start;
    size_t length;
} field;

/** The fields of one line, with the quotes and blanks they stand in; zeroed at first. */
typedef struct fields {
    field *item;
    size_t count, capacity;
} fields;

typedef enum fields_result { FIELDS_CUT, FIELDS_OPEN_QUOTE, FIELDS_NO_MEMORY } fields_result;

/** Cut a line at the commas outside quotes. FIELDS_OPEN_QUOTE: a quoted field does not end before a
 * comma or the line's end. The fields point into the line. */
fields_result fields_cut(fields *out, field line);
void fields_clear(fields *f);
/** How many fields a line has; 0 if a quoted one does not end. */
size_t fields_count(field line);

/** Without the blanks around it. */
field field_trimmed(field f);
/** What a field says: without blanks around it and the quotes around what is left. */
field field_content(field f);

#endif
