/* Reads the `#` lines of a finished table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "report/cut_notes.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "number/rational.h"

int cut_value(field *out, field line, const char *key) {
    size_t length = strlen(key);
    if (line.length <= length || memcmp(line.start, key, length) != 0)
        return 0;
    *out = (field){line.start + length, line.length - length};
    return 1;
}

graze_status cut_broken(graze_context *context, const char *format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return context_fail(context, GRAZE_EINPUT,
                        "%s; expected a whole table as graze classify writes it", text);
}

static graze_status read_dimension(cut_table *c, graze_context *context, field value) {
    unsigned long d;
    if (c->dimension)
        return cut_broken(context, "# dimension stands there twice");
    if (!field_count(&d, value, 3) || d < 2)
        return cut_broken(context, "# dimension %.*s: expected 2 or 3", FIELD_SHOWN(value));
    c->dimension = (int)d;
    return GRAZE_OK;
}

/* Cut a value into exactly `count` fields; 0 if it has more or fewer. */
static int cut_list(field *out, field value, int count) {
    int k = 0;
    for (; k < count && value.start && field_take(&out[k], &value); k++)
        out[k] = field_content(out[k]);
    return k == count && !value.start;
}

static graze_status read_grid(cut_table *c, graze_context *context, field value) {
    field size[3];
    unsigned long n[3] = {1, 1, 1};
    if (c->grid[0])
        return cut_broken(context, "# grid stands there twice");
    int good = cut_list(size, value, c->dimension);
    for (int k = 0; k < c->dimension && good; k++)
        good = field_count(&n[k], size[k], ~0ul) && n[k] >= 2;
    if (!good)
        return cut_broken(context, "# grid %.*s: expected %d whole numbers from 2 up",
                          FIELD_SHOWN(value), c->dimension);
    for (int k = 0; k < 3; k++)
        c->grid[k] = n[k];
    return GRAZE_OK;
}

static graze_status read_box(cut_table *c, graze_context *context, field value) {
    field number[6];
    int d = c->dimension;
    graze_status status = GRAZE_OK;
    if (c->boxed)
        return cut_broken(context, "# box stands there twice");
    if (!cut_list(number, value, 2 * d))
        return cut_broken(context, "# box %.*s: expected %d numbers", FIELD_SHOWN(value), 2 * d);
    for (int k = 0; k < 2 * d && !status; k++)
        status = rational_parse(k < d ? c->low + k : c->high + (k - d), context, number[k].start,
                                number[k].length);
    if (status)
        return context_at(context, status, "# box");
    for (int k = 0; k < d; k++)
        if (fmpq_cmp(c->low + k, c->high + k) >= 0)
            return cut_broken(context, "# box %.*s: the box is empty along axis %d",
                              FIELD_SHOWN(value), k);
    c->boxed = 1;
    return GRAZE_OK;
}

graze_status cut_note(cut_table *c, graze_context *context, field line) {
    field value;
    if (cut_value(&value, line, "# dimension "))
        return read_dimension(c, context, value);
    int grid = cut_value(&value, line, "# grid "), box = cut_value(&value, line, "# box ");
    if ((grid || box) && !c->dimension)
        return cut_broken(context, "# grid or # box stands before # dimension");
    return grid ? read_grid(c, context, value) : box ? read_box(c, context, value) : GRAZE_OK;
}

graze_status cut_notes_end(const cut_table *c, graze_context *context) {
    if (!c->dimension)
        return cut_broken(context, "the table does not say its dimension");
    if (!c->grid[0] != !c->boxed)
        return cut_broken(context, "the table has # %s without # %s", c->boxed ? "box" : "grid",
                          c->boxed ? "grid" : "box");
    return GRAZE_OK;
}

int cut_grid_has(const cut_table *c, size_t rows) {
    for (int k = 0; k < 3 && c->grid[0]; k++) {
        if (rows % c->grid[k])
            return 0;
        rows /= c->grid[k];
    }
    return !c->grid[0] || rows == 1;
}
