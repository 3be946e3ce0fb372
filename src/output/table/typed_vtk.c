/* Tables as legacy VTK files, binary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A grid is written as structured points; other points as an unstructured grid of vertices, which
 * readers take that do not know VTK's polygonal data. Names become numbers: pmc in 1, on 2, out 3;
 * classes 1 to 5 in the order of Definitions 5 to 9; definition 0 for ext. The format has no texts
 * that all its readers take, so words and other texts are numbered from 0 in the order in which
 * they first occur in their column; the field data COLUMN_texts has the texts themselves as bytes,
 * one after another, each with a newline behind it.
 */
#include "output/table/table.h"

#include "base/context/scope.h"
#include "base/number/decimal.h"
#include "input/delimited/delimited.h"

static const char title[] =
    "graze " GRAZE_VERSION
    ": pmc in 1 on 2 out 3; class regular 1 fold 2 fold_boundary 3 boundary 4 "
    "exterior 5; texts by first occurrence";

static int has_texts(const typed_column *c) {
    return c->kind == TYPED_WORD || c->kind == TYPED_TEXT;
}

/* The name of a column with `behind` at its end, initialised and filled. */
static field name_of(text *name, const typed_table *t, size_t index, const char *behind) {
    text_init(name);
    typed_name(name, t, index);
    text_put(name, behind);
    return (field){name->data, name->length};
}

/* Put the texts of all columns, in the order of their numbers, as field data; 0 when out of memory.
 */
static int put_texts(const vtk *w, const typed_table *t) {
    text name;
    size_t count = 0;
    int failed = 0;
    for (size_t k = 0; k < t->column_count; k++)
        count += has_texts(&t->column[k]) != 0;
    if (!count || !t->row_count)
        return 1;
    HELD(text, head);
    text_format(&head, "FIELD FieldData %zu\n", count);
    failed = head.failed;
    if (!failed)
        w->to.put(w->to.to, head.data, head.length);
    for (size_t k = 0; k < t->column_count && !failed; k++) {
        const text *bytes = &t->column[k].texts.bytes;
        if (!has_texts(&t->column[k]))
            continue;
        field shown = name_of(&name, t, k, "_texts");
        failed = name.failed;
        if (!failed) {
            vtk_bytes_begin(w, shown, bytes->length);
            w->to.put(w->to.to, bytes->data, bytes->length);
            vtk_end(w);
        }
        text_clear(&name);
    }
    return !failed;
}

/* Decimals of the head do not depend on the locale. */
static void put_decimal(text *out, const fmpq_t value) {
    text_put(out, " ");
    text_owned(out, decimal_of_rational(NULL, value, 17));
}

/* The lines that say where the points of a grid are; 0 without memory. */
static int put_grid(sink to, const typed_table *t) {
    HELD(text, out);
    LOCAL(fmpq, step);
    LOCAL(fmpz, parts);
    text_format(&out, "DIMENSIONS %zu %zu %zu\nORIGIN", t->grid[0], t->grid[1], t->grid[2]);
    for (int k = 0; k < 3; k++)
        put_decimal(&out, t->low + k);
    text_put(&out, "\nSPACING");
    for (int k = 0; k < 3; k++) {
        fmpq_sub(step, t->high + k, t->low + k);
        fmpz_set_ui(parts, t->grid[k] - 1);
        if (fmpz_is_zero(parts))
            fmpq_one(step); /* an axis of one point, where the format wants a number above 0 */
        else
            fmpq_div_fmpz(step, step, parts);
        put_decimal(&out, step);
    }
    text_put(&out, "\n");
    int good = !out.failed;
    if (good)
        to.put(to.to, out.data, out.length);
    return good;
}

static void put_vertices(const vtk *w, const typed_table *t) {
    size_t count = t->row_count;
    vtk_points_begin(w, count);
    for (size_t row = 0; row < count; row++) {
        double at[3] = {0, 0, 0};
        for (int k = 0; k < t->dimension; k++)
            at[k] = t->column[k].number[row];
        vtk_point(w, at);
    }
    vtk_end(w);
    vtk_cells_begin(w, count, 1);
    for (size_t row = 0; row < count; row++)
        vtk_cell(w, &row, 1);
    vtk_end(w);
    vtk_cell_types(w, count, VTK_VERTEX);
}

/* 0 without memory. */
static int put_vtk_column(const vtk *w, const typed_table *t, size_t index) {
    const typed_column *from = &t->column[index];
    text name;
    field shown = name_of(&name, t, index, "");
    int good = !name.failed;
    if (good)
        vtk_scalars_begin(w, shown, from->number ? "double" : "int");
    for (size_t row = 0; row < t->row_count && good; row++) {
        if (from->number)
            vtk_double(w, from->number[row]);
        else
            vtk_int(w, from->code[row]);
    }
    if (good)
        vtk_end(w);
    text_clear(&name);
    return good;
}

graze_status typed_write_vtk(const typed_table *t, sink to) {
    vtk w = {to, 1};
    if (t->row_count > INT32_MAX)
        return context_fail(t->context, GRAZE_ELIMIT,
                            "a VTK file numbers its points with 32 bits; expected at most "
                            "2147483647 rows");
    vtk_begin(&w, title, t->grid[0] ? "STRUCTURED_POINTS" : "UNSTRUCTURED_GRID");
    int good = put_texts(&w, t);
    if (good && t->grid[0])
        good = put_grid(to, t);
    else if (good)
        put_vertices(&w, t);
    vtk_data_begin(&w, "POINT_DATA", t->row_count);
    for (size_t k = (size_t)t->dimension; k < t->column_count && good; k++)
        good = put_vtk_column(&w, t, k);
    return good ? GRAZE_OK : context_fail(t->context, GRAZE_ESYSTEM, "out of memory");
}
