/* Names of cells. SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

void text_cell(text *t, const graze_cell *cell) {
    if (cell->kind == GRAZE_CELL_EDGE)
        text_format(t, "edge %zu-%zu", cell->a, cell->b);
    else
        text_format(t, "%s %zu", cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
}
