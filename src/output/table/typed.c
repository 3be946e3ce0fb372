/* Typed tables: begun, freed, and the names of their columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/table.h"

#include <stdlib.h>

void typed_init(typed_table *t, graze_context *context) {
    *t = (typed_table){.context = context};
    for (int k = 0; k < 3; k++) {
        fmpq_init(t->low + k);
        fmpq_init(t->high + k);
    }
}

void typed_clear(typed_table *t) {
    for (int k = 0; k < 3; k++) {
        fmpq_clear(t->low + k);
        fmpq_clear(t->high + k);
    }
    for (size_t k = 0; k < t->column_count; k++) {
        free(t->column[k].number);
        free(t->column[k].code);
        texts_clear(&t->column[k].texts);
        text_clear(&t->column[k].fields);
    }
    free(t->column);
    text_clear(&t->names);
}

void typed_set_grid(typed_table *t, int dimension, const size_t *size, graze_rationals low,
                    graze_rationals high) {
    for (int k = 0; k < 3; k++)
        t->grid[k] = k < dimension ? size[k] : 1;
    for (int k = 0; k < dimension; k++) {
        fmpq_set_mpq(t->low + k, low[k]);
        fmpq_set_mpq(t->high + k, high[k]);
    }
}

const char *typed_word(const typed_column *c, uint32_t code) {
    return c->kind == TYPED_PMC     ? graze_pmc_name((graze_pmc)code)
           : c->kind == TYPED_CLASS ? graze_class_name((graze_class)code)
                                    : NULL;
}

void typed_name(text *out, const typed_table *t, size_t index) {
    field name = t->column[index].name;
    size_t same = 1;
    text_bytes(out, name.start, name.length);
    if (!name.length)
        text_put(out, "column");
    for (size_t k = 0; k < index; k++)
        same += field_equal(t->column[k].name, name);
    if (same > 1)
        text_format(out, "_%zu", same);
}
