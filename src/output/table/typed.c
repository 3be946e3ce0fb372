/* Typed tables: begun, freed, and the names of their columns.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/typed.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

graze_status typed_broken(graze_context *context, const char *format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return context_fail(context, GRAZE_EINPUT,
                        "%s; expected a whole table as graze classify writes it", text);
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
