/* The form of the rows of a table or a certificate, and checks of a row that do not classify its
 * point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ROW_H
#define GRAZE_RUN_ROW_H

#include "run/lines.h"
#include "graze.h"

/** The form of the rows of a file, from its head. */
typedef struct row_form {
    result_kind kind;
    char separator; /* between the parts of a row: a comma, or a blank in a certificate */
    int dimension;
    graze_options options; /* operation, folds and columns */
    size_t others;         /* further columns of a table */
    int topo;              /* rows end with a position */
    int sdf;               /* before it with an enclosure */
    field end;             /* of a certificate: the last time, in the head */
    int contacts;          /* of a certificate: rows have their contacts */
} row_form;

/** A row's point, word, further columns and position, as they stand in it; without the commas
 * beside the answers. Without a word the field is empty. */
typedef struct row_parts {
    field point, word, rest, topo;
} row_parts;

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

/** Is each coordinate an integer or a ratio as graze classify writes it? Whether a ratio could be
 * reduced is not looked at. */
int row_point_is_written(field point, const row_form *form);

/** Take the bytes before the next separator, or up to the end. */
field row_take(field *rest, char separator);
/** An integer or a ratio as graze writes it. */
int row_is_number(field f);

/** The line of a head that says that rows end with the position relative to the closed sweep, and
 * the last line that counts those that are undecided. */
#define TOPO_LINE "# topo yes\n"
#define UNDECIDED_LINE "# undecided "

/** Is that position undecided? In a table it is the last column, in JSON a member. */
int row_is_undecided(field row);

#endif
