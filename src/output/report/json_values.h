/* Answers as values of JSON (src/program/cli/formats.md, JSON Lines).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_JSON_VALUES_H
#define GRAZE_REPORT_JSON_VALUES_H

#include "base/number/json.h"

/** Write a count, or null unless `is_there`. */
void json_index(json_writer *w, const char *key, int is_there, size_t value);
/** Write a cell as an object. */
void json_cell(json_writer *w, const char *key, const graze_cell *cell);
/** "intersection" or "tangency"; null for 0. */
void json_kind(json_writer *w, const char *key, graze_kind kind);
/** "I", "B", "O", or null beyond an end of the motion. */
void json_state(json_writer *w, const char *key, graze_state state);
/** A time (src/program/cli/formats.md, TIME); makes it canonical. NULL: null. */
void json_time(json_writer *w, const char *key, const graze_time *time);
/** A list of rationals. */
void json_point(json_writer *w, const char *key, const fmpq *point, int dimension);

#endif
