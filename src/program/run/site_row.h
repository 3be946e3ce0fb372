/* The form of the rows of a table of contact points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_SITE_ROW_H
#define GRAZE_RUN_SITE_ROW_H

#include "program/run/columns.h"
#include "program/run/row_text.h"

/** Read the columns from a line of names that begins with `time`, up to the head's end; 0 if graze
 * contact writes no such line. */
int site_form_read(row_form *out, const char *names, int snap);

/** As row_check, of a row of contact points: `point` has time, y and P. */
const char *site_row_check(row_parts *out, const row_form *form, graze_context *context, field row);

/** See that a row is of the time and point that a line of a file with these columns gave. One that
 * was moved is as far from y as it says; if P was given, of its time alone is looked at.
 * @return NULL, or what is expected */
const char *site_row_fits(const row_parts *parts, const row_form *form, const columns *c,
                          graze_context *context, graze_rationals number);

#endif
