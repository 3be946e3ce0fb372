/* Blocks of rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include "cli/rows.h"

block *block_create(void) {
    block *b = calloc(1, sizeof *b);
    for (size_t r = 0; b && r < BLOCK_ROWS; r++)
        for (int k = 0; k < 3; k++)
            mpq_init(b->rows[r].point[k]);
    return b;
}

void block_reset(block *b) {
    for (size_t r = 0; r < b->count; r++) {
        row *line = &b->rows[r];
        free(line->rest);
        free(line->message);
        graze_free(line->text);
        line->rest = line->message = line->text = NULL;
        line->status = GRAZE_OK;
    }
    b->count = 0;
}

void block_destroy(block *b) {
    if (!b)
        return;
    block_reset(b);
    for (size_t r = 0; r < BLOCK_ROWS; r++)
        for (int k = 0; k < 3; k++)
            mpq_clear(b->rows[r].point[k]);
    free(b);
}
