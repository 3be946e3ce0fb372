/* Writes legacy VTK files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/table/table.h"

#include <ctype.h>
#include <stdio.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

static void vtk_put(const vtk *w, const char *text) {
    w->to.put(w->to.to, text, strlen(text));
}

/* Put the text `before`, and counts with blanks between them. */
static void put_dimensions(const vtk *w, const char *before, const size_t *count, size_t counts,
                           const char *behind) {
    char text[32];
    vtk_put(w, before);
    for (size_t k = 0; k < counts; k++) {
        snprintf(text, sizeof text, k ? " %zu" : "%zu", count[k]);
        vtk_put(w, text);
    }
    vtk_put(w, behind);
}

/* Put a name with `_` for each blank, as a blank would end the name. */
static void put_vtk_name(const vtk *w, field name) {
    for (size_t k = 0; k < name.length; k++) {
        char byte = isspace((unsigned char)name.start[k]) ? '_' : name.start[k];
        w->to.put(w->to.to, &byte, 1);
    }
}

static void put_big_endian(const vtk *w, uint64_t value, size_t count) {
    char bytes[8];
    for (size_t k = 0; k < count; k++)
        bytes[k] = (char)(value >> 8 * (count - 1 - k));
    w->to.put(w->to.to, bytes, count);
}

static void put_binary_double(const vtk *w, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_big_endian(w, bits, 8);
}

void vtk_begin(const vtk *w, const char *title, const char *dataset) {
    vtk_put(w, "# vtk DataFile Version 3.0\n");
    vtk_put(w, title);
    vtk_put(w, w->binary ? "\nBINARY\nDATASET " : "\nASCII\nDATASET ");
    vtk_put(w, dataset);
    vtk_put(w, "\n");
}

void vtk_bytes_begin(const vtk *w, field name, size_t length) {
    put_vtk_name(w, name);
    put_dimensions(w, " 1 ", &length, 1, " unsigned_char\n");
}

void vtk_points_begin(const vtk *w, size_t count) {
    put_dimensions(w, "POINTS ", &count, 1, " double\n");
}

void vtk_point(const vtk *w, const double at[3]) {
    char text[128];
    for (int k = 0; k < 3 && w->binary; k++)
        put_binary_double(w, at[k]);
    if (!w->binary) {
        snprintf(text, sizeof text, "%.17g %.17g %.17g\n", at[0], at[1], at[2]);
        vtk_put(w, text);
    }
}

graze_status vtk_rational_point(const vtk *w, graze_context *context, const mpq_t *point,
                                int dimension) {
    double at[3] = {0, 0, 0};
    graze_status status = GRAZE_OK;
    LOCAL(fmpq, value);
    for (int k = 0; k < dimension && !status; k++) {
        fmpq_set_mpq(value, point[k]);
        status = rational_nearest(&at[k], context, value);
    }
    if (status)
        return context_fail(
            context, status,
            "a coordinate is past the range of binary64; expected one below 2^1024");
    vtk_point(w, at);
    return GRAZE_OK;
}

void vtk_cells_begin(const vtk *w, size_t count, size_t corners) {
    size_t sizes[2] = {count, count * (corners + 1)};
    put_dimensions(w, "CELLS ", sizes, 2, "\n");
}

void vtk_cell(const vtk *w, const size_t *corner, size_t corners) {
    if (!w->binary) {
        put_dimensions(w, "", &corners, 1, " ");
        put_dimensions(w, "", corner, corners, "\n");
        return;
    }
    put_big_endian(w, corners, 4);
    for (size_t k = 0; k < corners; k++)
        put_big_endian(w, corner[k], 4);
}

void vtk_cell_types(const vtk *w, size_t count, unsigned type) {
    put_dimensions(w, "CELL_TYPES ", &count, 1, "\n");
    for (size_t k = 0; k < count; k++)
        vtk_int(w, type);
    vtk_end(w);
}

void vtk_data_begin(const vtk *w, const char *of, size_t count) {
    vtk_put(w, of);
    put_dimensions(w, " ", &count, 1, "\n");
}

void vtk_scalars_begin(const vtk *w, field name, const char *type) {
    vtk_put(w, "SCALARS ");
    put_vtk_name(w, name);
    vtk_put(w, " ");
    vtk_put(w, type);
    vtk_put(w, " 1\nLOOKUP_TABLE default\n");
}

void vtk_int(const vtk *w, uint32_t value) {
    size_t count = value;
    if (w->binary)
        put_big_endian(w, value, 4);
    else
        put_dimensions(w, "", &count, 1, "\n");
}

void vtk_double(const vtk *w, double value) {
    char text[40];
    if (w->binary) {
        put_binary_double(w, value);
        return;
    }
    snprintf(text, sizeof text, "%.17g\n", value);
    vtk_put(w, text);
}

void vtk_end(const vtk *w) {
    if (w->binary)
        vtk_put(w, "\n");
}
