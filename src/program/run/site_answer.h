/* Rows of contact points. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_RUN_SITE_ANSWER_H
#define GRAZE_RUN_SITE_ANSWER_H

#include "program/run/columns.h"

/** Contact points that were read: of each the time and d coordinates, the cell where rows have one,
 * and the further columns where there are any. All is borrowed. */
typedef struct site_rows {
    const columns *columns;
    graze_rationals number;
    const graze_cell *cell;
    const graze_row_texts *texts;
    size_t count;
} site_rows;

/**
 * Write the rows of contact points as one text.
 * @param[out] r its text of the table, and `done`, the number of rows in it
 * @return why row `done` has no answer
 */
graze_status site_answer(row_run *r, graze_context *context, const graze_scene *scene,
                         const site_rows *rows, graze_format format);

#endif
