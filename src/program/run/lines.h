/* The lines of the two files that a run makes: a table, and a certificate.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_LINES_H
#define GRAZE_RUN_LINES_H

#include "input/delimited/field.h"

typedef enum result_kind { RESULT_TABLE, RESULT_CERTIFICATE, RESULT_KINDS } result_kind;

/** "table" or "certificate". */
const char *result_name(result_kind kind);
/** The command that writes such a file. */
const char *result_command(result_kind kind);
/** The text before the key of a note (shard.h) and of the last line: "# " in a table. */
const char *result_mark(result_kind kind);

/** A row of a table is one line; one of a certificate goes on in the lines of its intervals
 * and contacts. */
typedef enum line_part { LINE_ROW, LINE_OF_ROW, LINE_NOTE } line_part;

/** The kind of a line behind the head. */
line_part line_part_of(result_kind kind, field line);
/** Is the line the last one of the head? */
int line_ends_head(result_kind kind, field line);
/** The value of a note with this key; 0 if the line is none. */
int line_note(field *value, result_kind kind, field line, const char *key);

#endif
