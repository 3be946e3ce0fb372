/* Reads the names of boundary cells.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <string.h>
#include "input/delimited/delimited.h"
#include "program/points/heads.h"

/* The most cells of one kind that a solid can have (src/input/solid). */
#define CELLS_MOST 0xffffffffUL

int cell_read(graze_cell *out, field text) {
    field value;
    unsigned long a, b = 0;
    if (field_behind(&value, text, "face "))
        out->kind = GRAZE_CELL_FACE;
    else if (field_behind(&value, text, "edge "))
        out->kind = GRAZE_CELL_EDGE;
    else if (field_behind(&value, text, "vertex "))
        out->kind = GRAZE_CELL_VERTEX;
    else
        return 0;
    const char *minus = out->kind == GRAZE_CELL_EDGE && value.length
                            ? memchr(value.start, '-', value.length)
                            : NULL;
    field first = {value.start, minus ? (size_t)(minus - value.start) : value.length};
    if (!field_count(&a, first, CELLS_MOST) || (out->kind == GRAZE_CELL_EDGE && !minus))
        return 0;
    if (minus &&
        (!field_count(&b, (field){minus + 1, value.length - first.length - 1}, CELLS_MOST) ||
         a >= b))
        return 0;
    out->a = a;
    out->b = b;
    return 1;
}
