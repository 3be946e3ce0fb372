/* The text of a row: its form, its parts and its numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_RUN_ROW_TEXT_H
#define GRAZE_RUN_ROW_TEXT_H

#include "program/run/coordinates.h"
#include "program/run/lines.h"
#include "graze.h"

/** The form of the rows of a file, from its head. */
typedef struct row_form {
    result_kind kind;
    char separator; /* between the parts of a row: a comma, or a blank in a certificate */
    int dimension;
    graze_options options;       /* operation, folds and columns */
    size_t others;               /* further columns of a table */
    int sites, snap;             /* it is of contact points, and they were moved */
    int topo;                    /* rows end with a position */
    int sdf;                     /* before it with an enclosure */
    int certain;                 /* and behind that with whether the answer is certain */
    coordinate_form coordinates; /* not of contact points, which are exact */
    field end;                   /* of a certificate: the last time, in the head */
    int contacts;                /* of a certificate: rows have their contacts */
} row_form;

/** A row's point, word, further columns and position, as they stand in it; without the commas
 * beside the answers. Without a word the field is empty. */
typedef struct row_parts {
    field point, word, rest, topo;
    field shift; /* of a contact point that was moved */
    int missed;  /* its cell has no contact */
} row_parts;

/** Take the bytes before the next separator, or up to the end. */
field row_take(field *rest, char separator);
/** An integer or a ratio as graze writes it. */
int row_is_number(field f);

#endif
