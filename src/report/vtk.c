/* Tables as legacy VTK files, binary, version 3.0.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A grid is written as structured points; other points as an unstructured grid of vertices, which
 * readers take that do not know VTK's polygonal data. Names become numbers: pmc in 1, on 2, out 3;
 * classes 1 to 5 in the order of Definitions 5 to 9; definition 0 for ext. The format has no texts
 * that all its readers take, so words and other texts are numbered from 0 in the order in which
 * they first occur in their column.
 */
#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "report/cut_table.h"
#include "report/decimal.h"

/* Big-endian, as the format wants it. */
static void put_int(text *t, uint32_t value) {
    const char bytes[] = {(char)(value >> 24), (char)(value >> 16), (char)(value >> 8),
                          (char)value};
    text_bytes(t, bytes, 4);
}

static void put_double(text *t, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_int(t, (uint32_t)(bits >> 32));
    put_int(t, (uint32_t)bits);
}

/* A number of a header line; decimals do not depend on the locale here. */
static void put_decimal(text *t, const fmpq_t value) {
    text_put(t, " ");
    text_owned(t, decimal_of_rational(NULL, value, 17));
}

static void put_grid(text *t, const cut_table *c) {
    fmpq_t step;
    fmpz_t parts;
    fmpq_init(step);
    fmpz_init(parts);
    text_format(t, "DATASET STRUCTURED_POINTS\nDIMENSIONS %zu %zu %zu\nORIGIN", c->grid[0],
                c->grid[1], c->grid[2]);
    for (int k = 0; k < 3; k++)
        put_decimal(t, c->low + k);
    text_put(t, "\nSPACING");
    for (int k = 0; k < 3; k++) {
        fmpq_sub(step, c->high + k, c->low + k);
        fmpz_set_ui(parts, c->grid[k] - 1);
        if (fmpz_is_zero(parts))
            fmpq_one(step); /* an axis of one point, where the format wants a number above 0 */
        else
            fmpq_div_fmpz(step, step, parts);
        put_decimal(t, step);
    }
    text_put(t, "\n");
    fmpq_clear(step);
    fmpz_clear(parts);
}

static void put_vertices(text *t, graze_context *context, const cut_table *c) {
    size_t n = c->row_count;
    text_format(t, "DATASET UNSTRUCTURED_GRID\nPOINTS %zu double\n", n);
    for (size_t r = 0; r < n; r++)
        for (size_t k = 0; k < 3; k++)
            put_double(t, k < (size_t)c->dimension
                              ? cut_table_number(context, cut_table_field(c, r, k))
                              : 0);
    text_format(t, "\nCELLS %zu %zu\n", n, 2 * n);
    for (size_t r = 0; r < n; r++) {
        put_int(t, 1);
        put_int(t, (uint32_t)r);
    }
    text_format(t, "\nCELL_TYPES %zu\n", n);
    for (size_t r = 0; r < n; r++)
        put_int(t, 1);
    text_put(t, "\n");
}

/* A text and the row it stands in. */
typedef struct numbered {
    token field;
    size_t row, number;
} numbered;

static int compare_texts(const void *a, const void *b) {
    const numbered *p = a, *q = b;
    size_t shorter = p->field.length < q->field.length ? p->field.length : q->field.length;
    int order = memcmp(p->field.start, q->field.start, shorter);
    if (order)
        return order;
    if (p->field.length != q->field.length)
        return p->field.length < q->field.length ? -1 : 1;
    return p->row < q->row ? -1 : p->row > q->row;
}

static int compare_rows(const void *a, const void *b) {
    const numbered *p = a, *q = b;
    return p->row < q->row ? -1 : p->row > q->row;
}

/* Equal texts stand together once sorted, the first of them by row in front; back in the order of
 * rows each first one gets the next number, and the others that of their first. */
static void put_texts(text *t, const cut_table *c, size_t index) {
    numbered *all = malloc((c->row_count + 1) * sizeof *all);
    if (!all) {
        t->failed = 1;
        return;
    }
    for (size_t r = 0; r < c->row_count; r++)
        all[r] = (numbered){cut_table_field(c, r, index), r, r};
    qsort(all, c->row_count, sizeof *all, compare_texts);
    for (size_t k = 1; k < c->row_count; k++) {
        const token *a = &all[k - 1].field, *b = &all[k].field;
        if (a->length == b->length && memcmp(a->start, b->start, a->length) == 0)
            all[k].number = all[k - 1].number;
    }
    qsort(all, c->row_count, sizeof *all, compare_rows);
    size_t next = 0;
    for (size_t r = 0; r < c->row_count; r++)
        all[r].number = all[r].number == r ? next++ : all[all[r].number].number;
    for (size_t r = 0; r < c->row_count; r++)
        put_int(t, (uint32_t)all[r].number);
    free(all);
}

/* A name without blanks, which the format cuts lines at; `_2` and so on after a name that was. */
static void put_name(text *t, const cut_table *c, size_t index) {
    const token *name = &c->column[index].name;
    size_t same = 1;
    for (size_t k = 0; k < name->length; k++) {
        char byte = isspace((unsigned char)name->start[k]) ? '_' : name->start[k];
        text_bytes(t, &byte, 1);
    }
    if (!name->length)
        text_put(t, "column");
    for (size_t k = 0; k < index; k++)
        same += c->column[k].name.length == name->length &&
                memcmp(c->column[k].name.start, name->start, name->length) == 0;
    if (same > 1)
        text_format(t, "_%zu", same);
}

static void put_column(text *t, graze_context *context, const cut_table *c, size_t index) {
    const column *from = &c->column[index];
    int number = from->kind == COLUMN_NUMBER;
    text_put(t, "SCALARS ");
    put_name(t, c, index);
    text_put(t, number ? " double 1\nLOOKUP_TABLE default\n" : " int 1\nLOOKUP_TABLE default\n");
    if (from->kind == COLUMN_WORD || from->kind == COLUMN_TEXT)
        put_texts(t, c, index);
    else
        for (size_t r = 0; r < c->row_count; r++) {
            token field = cut_table_field(c, r, index);
            if (number)
                put_double(t, cut_table_number(context, field));
            else
                put_int(t, (uint32_t)cut_table_code(from->kind, field));
        }
    text_put(t, "\n");
}

graze_status export_vtk(text *out, graze_context *context, const cut_table *c) {
    if (c->row_count > INT32_MAX)
        return context_fail(context, GRAZE_ELIMIT,
                            "a VTK file numbers its points with 32 bits; right are at most "
                            "2147483647 rows");
    text_put(out, "# vtk DataFile Version 3.0\ngraze " GRAZE_VERSION
                  ": pmc in 1 on 2 out 3; class regular 1 fold 2 fold_boundary 3 boundary 4 "
                  "exterior 5; texts by first occurrence\nBINARY\n");
    if (c->grid[0])
        put_grid(out, c);
    else
        put_vertices(out, context, c);
    text_format(out, "POINT_DATA %zu\n", c->row_count);
    for (size_t k = (size_t)c->dimension; k < c->column_count; k++)
        put_column(out, context, c, k);
    return GRAZE_OK;
}
