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

static const char title[] =
    "graze " GRAZE_VERSION
    ": pmc in 1 on 2 out 3; class regular 1 fold 2 fold_boundary 3 boundary 4 "
    "exterior 5; texts by first occurrence";

static int has_texts(const typed_column *c) {
    return c->kind == TYPED_WORD || c->kind == TYPED_TEXT;
}

static graze_status vtk_no_memory(const typed_table *t) {
    return context_fail(t->context, GRAZE_ESYSTEM, "out of memory");
}

/* Put a text of the head. */
static graze_status put_whole(sink to, const typed_table *t, const text *whole) {
    if (whole->failed)
        return vtk_no_memory(t);
    to.put(to.to, whole->data, whole->length);
    return GRAZE_OK;
}

/* Put the texts of all columns, in the order of their numbers, as field data. */
static graze_status put_texts(const vtk *w, const typed_table *t) {
    size_t count = 0;
    for (size_t k = 0; k < t->column_count; k++)
        count += has_texts(&t->column[k]) != 0;
    if (!count || !t->row_count)
        return GRAZE_OK;
    HELD(text, head);
    text_format(&head, "FIELD FieldData %zu\n", count);
    TRY(put_whole(w->to, t, &head));
    for (size_t k = 0; k < t->column_count; k++) {
        const text *bytes = &t->column[k].texts.bytes;
        if (!has_texts(&t->column[k]))
            continue;
        HELD(text, name);
        typed_name(&name, t, k);
        text_put(&name, "_texts");
        if (name.failed)
            return vtk_no_memory(t);
        vtk_bytes_begin(w, (field){name.data, name.length}, bytes->length);
        w->to.put(w->to.to, bytes->data, bytes->length);
        vtk_end(w);
    }
    return GRAZE_OK;
}

/* Decimals of the head do not depend on the locale. */
static void put_decimal(text *out, const fmpq_t value) {
    text_put(out, " ");
    text_owned(out, decimal_of_rational(NULL, value, 17));
}

/* Put the lines that say where the points of a grid are. */
static graze_status put_grid(sink to, const typed_table *t) {
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
    return put_whole(to, t, &out);
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

static graze_status put_vtk_column(const vtk *w, const typed_table *t, size_t index) {
    const typed_column *from = &t->column[index];
    HELD(text, name);
    typed_name(&name, t, index);
    if (name.failed)
        return vtk_no_memory(t);
    vtk_scalars_begin(w, (field){name.data, name.length}, from->number ? "double" : "int");
    for (size_t row = 0; row < t->row_count; row++) {
        if (from->number)
            vtk_double(w, from->number[row]);
        else
            vtk_int(w, from->code[row]);
    }
    vtk_end(w);
    return GRAZE_OK;
}

graze_status typed_write_vtk(const typed_table *t, sink to) {
    vtk w = {to, 1};
    if (t->row_count > INT32_MAX)
        return context_fail(t->context, GRAZE_ELIMIT,
                            "a VTK file numbers its points with 32 bits; expected at most "
                            "2147483647 rows");
    vtk_begin(&w, title, t->grid[0] ? "STRUCTURED_POINTS" : "UNSTRUCTURED_GRID");
    TRY(put_texts(&w, t));
    if (t->grid[0])
        TRY(put_grid(to, t));
    else
        put_vertices(&w, t);
    vtk_data_begin(&w, "POINT_DATA", t->row_count);
    for (size_t k = (size_t)t->dimension; k < t->column_count; k++)
        TRY(put_vtk_column(&w, t, k));
    return GRAZE_OK;
}
