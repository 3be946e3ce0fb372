/* Values of JSON, written one after another into a text.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A value in an object has a key, one in a list or on top has none (NULL). Counts are JSON numbers,
 * exact numbers are strings.
 */
#ifndef GRAZE_NUMBER_JSON_H
#define GRAZE_NUMBER_JSON_H

#include "base/number/text.h"

/** Begins as {.out = text}; out->failed is 1 once memory has run short. With `pretty` each member
 * stands on a line of its own, indented by two blanks a level, and a newline ends the text. With
 * `spaced` a blank stands behind each comma and colon. */
typedef struct json_writer {
    text *out;
    int pretty, spaced, depth;
    int members; /* 1 once the innermost list or object has one */
    int line;    /* 1 + the blanks that json_line asked for, 0 after they are written */
} json_writer;

/** Begin an object, '{', or a list, '['. */
void json_open(json_writer *w, const char *key, char bracket);
/** End the innermost object, by '}', or list, by ']'. */
void json_close(json_writer *w, char bracket);
/** End several objects and lists, the innermost first, one for each bracket. */
void json_ends(json_writer *w, const char *brackets);

/** Let the next value, or end of a list or object, begin a line, behind `indent` blanks. */
void json_line(json_writer *w, int indent);
/** Begin a value that the caller appends to the text, which is returned. */
text *json_begin(json_writer *w, const char *key);

/** A string; null if `value` is NULL. */
void json_text(json_writer *w, const char *key, const char *value);
void json_count(json_writer *w, const char *key, unsigned long value);
/** A number, given by its text, which is not checked. */
void json_number(json_writer *w, const char *key, const char *digits);
/** A double with 17 significant digits; null unless it is finite. */
void json_double(json_writer *w, const char *key, double value);
void json_bool(json_writer *w, const char *key, int value);
/** An exact number, as a string. */
void json_rational(json_writer *w, const char *key, const fmpq_t value);
/** Append `form`, with each @ replaced by the next rational and each % by the next one in quotes.
 */
void json_form(text *out, const char *form, ...);
/** A list of rationals. */
void json_point(json_writer *w, const char *key, const fmpq *point, int dimension);
void json_integer(json_writer *w, const char *key, const fmpz_t value);
/** Write a malloc'ed string and free it; NULL, the result of a failed allocation, sets out->failed.
 */
void json_owned(json_writer *w, const char *key, char *value);

#endif
