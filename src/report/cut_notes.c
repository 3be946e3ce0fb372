/* Reads the `#` lines of a finished table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "report/cut_notes.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "number/rational.h"

int cut_value(token *out, token line, const char *key) {
    size_t length = strlen(key);
    if (line.length <= length || memcmp(line.start, key, length) != 0)
        return 0;
    *out = (token){line.start + length, line.length - length};
    return 1;
}

int cut_count(unsigned long *out, token s, unsigned long most) {
    *out = 0;
    for (size_t k = 0; k < s.length; k++) {
        unsigned long digit = (unsigned long)s.start[k] - '0';
        if (s.start[k] < '0' || digit > 9 || *out > most / 10 || 10 * *out > most - digit)
            return 0;
        *out = 10 * *out + digit;
    }
    return s.length > 0;
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

static graze_status read_dimension(cut_table *c, graze_context *context, token value) {
    unsigned long d;
    if (c->dimension)
        return cut_broken(context, "# dimension stands there twice");
    if (!cut_count(&d, value, 3) || d < 2)
        return cut_broken(context, "# dimension %.*s: expected 2 or 3", CUT_SHOWN(value));
    c->dimension = (int)d;
    return GRAZE_OK;
}

/* Cut a value into exactly `count` fields; 0 if it has more or fewer. */
static int cut_list(token *out, token value, int count) {
    const char *at = value.start;
    int k = 0;
    while (k < count && at && csv_take(&out[k], &at, value.start + value.length))
        k++;
    return k == count && !at;
}

static graze_status read_grid(cut_table *c, graze_context *context, token value) {
    token size[3];
    unsigned long n[3] = {1, 1, 1};
    if (c->grid[0])
        return cut_broken(context, "# grid stands there twice");
    int good = cut_list(size, value, c->dimension);
    for (int k = 0; k < c->dimension && good; k++)
        good = cut_count(&n[k], size[k], ~0ul) && n[k] >= 2;
    if (!good)
        return cut_broken(context, "# grid %.*s: expected %d whole numbers from 2 up",
                          CUT_SHOWN(value), c->dimension);
    for (int k = 0; k < 3; k++)
        c->grid[k] = n[k];
    return GRAZE_OK;
}

static graze_status read_box(cut_table *c, graze_context *context, token value) {
    token number[6];
    int d = c->dimension;
    graze_status status = GRAZE_OK;
    if (c->boxed)
        return cut_broken(context, "# box stands there twice");
    if (!cut_list(number, value, 2 * d))
        return cut_broken(context, "# box %.*s: expected %d numbers", CUT_SHOWN(value), 2 * d);
    for (int k = 0; k < 2 * d && !status; k++)
        status = rational_parse(k < d ? c->low + k : c->high + (k - d), context, number[k].start,
                                number[k].length);
    if (status)
        return context_at(context, status, "# box");
    for (int k = 0; k < d; k++)
        if (fmpq_cmp(c->low + k, c->high + k) >= 0)
            return cut_broken(context, "# box %.*s: the box is empty along axis %d",
                              CUT_SHOWN(value), k);
    c->boxed = 1;
    return GRAZE_OK;
}

graze_status cut_note(cut_table *c, graze_context *context, token line) {
    token value;
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
