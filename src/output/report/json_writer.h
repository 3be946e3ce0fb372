/* Values of a line of JSON: exact numbers are strings; counts and cell numbers are JSON integers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The caller sets memory.short_of by setjmp before json_begin, and json_memory_clear ends a line.
 */
#ifndef GRAZE_REPORT_JSON_WRITER_H
#define GRAZE_REPORT_JSON_WRITER_H

#include <yajl/yajl_gen.h>
#include "base/context/json_memory.h"
#include "base/number/text.h"
#include "decide/trace/trace.h"

/** `failed` once a value could not be written. */
typedef struct json_writer {
    text *out;
    json_memory memory;
    yajl_gen gen;
    int failed;
} json_writer;

/** Begin a line that goes to w->out. */
void json_begin(json_writer *w);
/** Note the status of a call of yajl. */
void json_check(json_writer *w, yajl_gen_status status);
void json_string(json_writer *w, const char *string);
/** A malloc'ed string, which is freed; NULL is a failure. */
void json_owned(json_writer *w, char *string);
/** A cell as an object. */
void json_cell(json_writer *w, const graze_cell *cell);
/* A key and its value. */
void json_count(json_writer *w, const char *key, unsigned long value);
void json_text(json_writer *w, const char *key, const char *value);
void json_rational(json_writer *w, const char *key, const fmpq_t value);
/** "I", "B", "O", or null beyond an end of the motion. */
void json_state(json_writer *w, const char *key, graze_state state);
/** A time (src/program/cli/formats.md, TIME); makes it canonical. */
void json_time(json_writer *w, const char *key, const graze_time *time);
/** A list of rationals. */
void json_point(json_writer *w, const char *key, const fmpq *point, int dimension);

#endif
