/* Names of cells. SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/run/cell_text.h"

void text_cell(text *t, const graze_cell *cell) {
    static const char *const kinds[] = {"", "face ", "edge ", "vertex "};
    text_put(t, kinds[cell->kind]);
    if (cell->kind == GRAZE_CELL_EDGE)
        text_format(t, "%zu-%zu", cell->a, cell->b);
    else if (cell->kind)
        text_format(t, "%zu", cell->a);
}
