/* Fields of a line of CSV.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTEXT_CSV_H
#define GRAZE_CONTEXT_CSV_H

#include <stddef.h>

/** Bytes of a text, not ended by a NUL. */
typedef struct csv_field {
    const char *start;
    size_t length;
} csv_field;

/** Without the blanks around it. */
csv_field csv_trimmed(csv_field f);

/**
 * Take a field from the front of a line. A quote opens a quoted field at its beginning only.
 * @param[out] out what the field says: without blanks around it and the quotes around what is left;
 * doubled quotes stay as they are
 * @param at       where it begins; then where the next one does, NULL after the last
 * @return 0 if a quoted field does not end before a comma or the line's end
 */
int csv_take(csv_field *out, const char **at, const char *end);

#endif
