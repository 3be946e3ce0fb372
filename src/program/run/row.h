/* The form of the rows of a table or a certificate, and checks of a row that do not classify its
 * point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ROW_H
#define GRAZE_RUN_ROW_H

#include "program/run/row_text.h"

/** Read it from a head, up to its last line, which is borrowed; 0 if graze writes no such head for
 * that kind of file. */
int row_form_read(row_form *out, result_kind kind, const char *head);

/**
 * Check a row, or the first line of a certificate's, without its line end: a point, the answers
 * that belong to its word and to no other, or pmc alone where the table has no more, further
 * columns only where the table has some, and a position that goes with pmc. The caller checks how
 * many further columns there are.
 * @return NULL, or what is expected
 */
const char *row_check(row_parts *out, const row_form *form, graze_context *context, field row);

/** Is each coordinate written as the head says: an integer or a ratio, of which it is not looked at
 * whether it could be reduced; a decimal; any number?
 * @return NULL, or what is expected */
const char *row_point_is_written(field point, const row_form *form, graze_context *context);

/** The line of a head that says that rows end with the position relative to the closed sweep, and
 * the last line that counts those that are undecided. */
#define TOPO_LINE "# topo yes\n"
#define UNDECIDED_LINE "# undecided "

/** Is that position undecided? In a table it is the last column, in JSON a member. */
int row_is_undecided(field row);

#endif
