/* Reads the `#` lines of a finished table that its columns and rows are held to.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/typed_head.h"

#include "base/number/rational.h"

static graze_status read_dimension(typed_table *t, field value) {
    unsigned long d;
    if (t->dimension)
        return typed_broken(t->context, "# dimension stands there twice");
    if (!field_count(&d, value, 3) || d < 2)
        return typed_broken(t->context, "# dimension %.*s: expected 2 or 3", FIELD_SHOWN(value));
    t->dimension = (int)d;
    return GRAZE_OK;
}

/* Cut a value into exactly `count` fields; 0 if it has more or fewer. */
static int cut_list(field *out, field value, int count) {
    int k = 0;
    for (; k < count && value.start && field_take(&out[k], &value); k++)
        out[k] = field_content(out[k]);
    return k == count && !value.start;
}

static graze_status read_grid(typed_table *t, field value) {
    field size[3];
    unsigned long n[3] = {1, 1, 1};
    if (t->grid[0])
        return typed_broken(t->context, "# grid stands there twice");
    int good = cut_list(size, value, t->dimension);
    for (int k = 0; k < t->dimension && good; k++)
        good = field_count(&n[k], size[k], ~0ul) && n[k] >= 2;
    if (!good)
        return typed_broken(t->context, "# grid %.*s: expected %d whole numbers from 2 up",
                            FIELD_SHOWN(value), t->dimension);
    for (int k = 0; k < 3; k++)
        t->grid[k] = n[k];
    return GRAZE_OK;
}

static graze_status read_box(typed_table *t, field value) {
    field number[6];
    int d = t->dimension;
    graze_status status = GRAZE_OK;
    if (t->boxed)
        return typed_broken(t->context, "# box stands there twice");
    if (!cut_list(number, value, 2 * d))
        return typed_broken(t->context, "# box %.*s: expected %d numbers", FIELD_SHOWN(value),
                            2 * d);
    for (int k = 0; k < 2 * d && !status; k++)
        status = rational_parse(k < d ? t->low + k : t->high + (k - d), t->context, number[k].start,
                                number[k].length);
    if (status)
        return context_at(t->context, status, "# box");
    for (int k = 0; k < d; k++)
        if (fmpq_cmp(t->low + k, t->high + k) >= 0)
            return typed_broken(t->context, "# box %.*s: the box is empty along axis %d",
                                FIELD_SHOWN(value), k);
    t->boxed = 1;
    return GRAZE_OK;
}

static graze_status read_answers(typed_table *t, field value) {
    if (t->pmc_alone)
        return typed_broken(t->context, "# columns stands there twice");
    if (!field_is(value, "pmc"))
        return typed_broken(t->context, "# columns %.*s: expected pmc", FIELD_SHOWN(value));
    t->pmc_alone = 1;
    return GRAZE_OK;
}

graze_status typed_head_line(typed_table *t, field line) {
    field value;
    if (field_behind(&value, line, "# dimension "))
        return read_dimension(t, value);
    if (field_behind(&value, line, "# columns "))
        return read_answers(t, value);
    int grid = field_behind(&value, line, "# grid "), box = field_behind(&value, line, "# box ");
    if ((grid || box) && !t->dimension)
        return typed_broken(t->context, "# grid or # box stands before # dimension");
    return grid ? read_grid(t, value) : box ? read_box(t, value) : GRAZE_OK;
}

graze_status typed_head_end(const typed_table *t) {
    if (!t->dimension)
        return typed_broken(t->context, "the table does not say its dimension");
    if (!t->grid[0] != !t->boxed)
        return typed_broken(t->context, "the table has # %s without # %s",
                            t->boxed ? "box" : "grid", t->boxed ? "grid" : "box");
    return GRAZE_OK;
}

int typed_grid_fits(const typed_table *t) {
    size_t rows = t->row_count;
    for (int k = 0; k < 3 && t->grid[0]; k++) {
        if (rows % t->grid[k])
            return 0;
        rows /= t->grid[k];
    }
    return !t->grid[0] || rows == 1;
}
