/* The rows that a continued table or certificate has already, held to the points of this run.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Only the last one is made again (results.h). The others are checked as far as their points and
 * words go: point, further columns, the answers that belong to the word, and intervals of a
 * certificate that spell it.
 */
#ifndef GRAZE_RUN_KEPT_H
#define GRAZE_RUN_KEPT_H

#include "program/run/answer.h"
#include "program/run/certified.h"
#include "program/run/results.h"
#include "program/run/row.h"

typedef struct kept {
    graze_context *context; /* borrowed */
    row_source source;
    row_form form;
    reader reader;
    mpq_t point[4];
    certified intervals;
    text written; /* the point's coordinates as they stand in a row */
} kept;

/** For one file, table or certificate. kept_clear in any case. */
void kept_init(kept *k, graze_context *context, row_source source);
void kept_clear(kept *k);

/** Check the rows of a block against the next ones of the file. Returns an exit status and says
 * what is wrong: EXIT_INPUT they are not rows of these points, or a point cannot be read. */
int kept_check(kept *k, results *t, const block *b);

#endif
