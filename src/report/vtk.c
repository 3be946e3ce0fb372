/* Tables as legacy VTK files, binary, version 3.0.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A grid is written as structured points; other points as an unstructured grid of vertices, which
 * readers take that do not know VTK's polygonal data. Names become numbers: pmc in 1, on 2, out 3;
 * classes 1 to 5 in the order of Definitions 5 to 9; definition 0 for ext. The format has no texts
 * that all its readers take, so words and other texts are numbered from 0 in the order in which
 * they first occur in their column; which they are stands, one after another and each with a
 * newline behind it, as bytes in the field data COLUMN_texts.
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
    text_format(t, "DIMENSIONS %zu %zu %zu\nORIGIN", c->grid[0], c->grid[1], c->grid[2]);
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

static graze_status put_vertices(text *t, graze_context *context, const cut_table *c) {
    size_t n = c->row_count;
    graze_status status = GRAZE_OK;
    text_format(t, "POINTS %zu double\n", n);
    for (size_t r = 0; r < n; r++)
        for (size_t k = 0; k < 3 && !status; k++) {
            double number = 0;
            if (k < (size_t)c->dimension)
                status = cut_table_number(&number, context, c, r, k);
            put_double(t, number);
        }
    text_format(t, "\nCELLS %zu %zu\n", n, 2 * n);
    for (size_t r = 0; r < n; r++) {
        put_int(t, 1);
        put_int(t, (uint32_t)r);
    }
    text_format(t, "\nCELL_TYPES %zu\n", n);
    for (size_t r = 0; r < n; r++)
        put_int(t, 1);
    text_put(t, "\n");
    return status;
}

/* A text and the row it stands in. */
typedef struct numbered {
    field field;
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

/* The rows of a column with the numbers of their texts; NULL without memory. Equal texts stand
 * together once sorted, the first of them by row in front; back in the order of rows each first one
 * gets the next number, and the others that of their first. */
static numbered *number_texts(const cut_table *c, size_t index) {
    numbered *all = malloc((c->row_count + 1) * sizeof *all);
    if (!all)
        return NULL;
    for (size_t r = 0; r < c->row_count; r++)
        all[r] = (numbered){cut_table_field(c, r, index), r, r};
    qsort(all, c->row_count, sizeof *all, compare_texts);
    for (size_t k = 1; k < c->row_count; k++) {
        const field *a = &all[k - 1].field, *b = &all[k].field;
        if (a->length == b->length && memcmp(a->start, b->start, a->length) == 0)
            all[k].number = all[k - 1].number;
    }
    qsort(all, c->row_count, sizeof *all, compare_rows);
    size_t next = 0;
    for (size_t r = 0; r < c->row_count; r++)
        all[r].number = all[r].number == r ? next++ : all[all[r].number].number;
    return all;
}

/* A name without blanks, which the format cuts lines at; `_2` and so on after a name that was. */
static void put_name(text *t, const cut_table *c, size_t index) {
    const field *name = &c->column[index].name;
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

static int has_texts(const cut_table *c, size_t index) {
    return c->column[index].kind == COLUMN_WORD || c->column[index].kind == COLUMN_TEXT;
}

/* The texts of a column in the order of their numbers. */
static void put_texts(text *t, const cut_table *c, size_t index, const numbered *all) {
    size_t length = 0, next = 0;
    for (size_t r = 0; r < c->row_count; r++)
        if (all[r].number == next) {
            length += all[r].field.length + 1;
            next++;
        }
    put_name(t, c, index);
    text_format(t, "_texts 1 %zu unsigned_char\n", length);
    next = 0;
    for (size_t r = 0; r < c->row_count; r++)
        if (all[r].number == next) {
            text_bytes(t, all[r].field.start, all[r].field.length);
            text_put(t, "\n");
            next++;
        }
    text_put(t, "\n");
}

/* The field data, and the numbers of each column with texts, which the caller frees. */
static void put_all_texts(text *t, const cut_table *c, numbered **all) {
    size_t count = 0;
    for (size_t k = (size_t)c->dimension; k < c->column_count; k++)
        count += has_texts(c, k) != 0;
    if (!count || !c->row_count)
        return;
    text_format(t, "FIELD FieldData %zu\n", count);
    for (size_t k = (size_t)c->dimension; k < c->column_count && !t->failed; k++) {
        if (!has_texts(c, k))
            continue;
        all[k] = number_texts(c, k);
        t->failed |= !all[k];
        if (all[k])
            put_texts(t, c, k, all[k]);
    }
}

static graze_status put_column(text *t, graze_context *context, const cut_table *c, size_t index,
                               const numbered *texts) {
    const column *from = &c->column[index];
    graze_status status = GRAZE_OK;
    int number = from->kind == COLUMN_NUMBER;
    text_put(t, "SCALARS ");
    put_name(t, c, index);
    text_put(t, number ? " double 1\nLOOKUP_TABLE default\n" : " int 1\nLOOKUP_TABLE default\n");
    for (size_t r = 0; r < c->row_count && !status; r++) {
        double value = 0;
        if (number) {
            status = cut_table_number(&value, context, c, r, index);
            put_double(t, value);
        } else {
            put_int(t, texts ? (uint32_t)texts[r].number
                             : (uint32_t)cut_table_code(from->kind, cut_table_field(c, r, index)));
        }
    }
    text_put(t, "\n");
    return status;
}

graze_status export_vtk(text *out, graze_context *context, const cut_table *c) {
    if (c->row_count > INT32_MAX)
        return context_fail(context, GRAZE_ELIMIT,
                            "a VTK file numbers its points with 32 bits; right are at most "
                            "2147483647 rows");
    text_put(out, "# vtk DataFile Version 3.0\ngraze " GRAZE_VERSION
                  ": pmc in 1 on 2 out 3; class regular 1 fold 2 fold_boundary 3 boundary 4 "
                  "exterior 5; texts by first occurrence\nBINARY\n");
    numbered **texts = calloc(c->column_count, sizeof *texts);
    if (!texts) {
        out->failed = 1;
        return GRAZE_OK;
    }
    graze_status status = GRAZE_OK;
    text_put(out, c->grid[0] ? "DATASET STRUCTURED_POINTS\n" : "DATASET UNSTRUCTURED_GRID\n");
    put_all_texts(out, c, texts);
    if (c->grid[0])
        put_grid(out, c);
    else
        status = put_vertices(out, context, c);
    text_format(out, "POINT_DATA %zu\n", c->row_count);
    for (size_t k = (size_t)c->dimension; k < c->column_count && !out->failed && !status; k++)
        status = put_column(out, context, c, k, texts[k]);
    for (size_t k = 0; k < c->column_count; k++)
        free(texts[k]);
    free(texts);
    return status;
}
