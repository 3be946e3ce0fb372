/* Writes legacy VTK files, version 3.0, as text or binary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The parts of a file come in the order of these functions. Each part that has values is ended by
 * vtk_end.
 */
#ifndef GRAZE_TABLE_VTK_H
#define GRAZE_TABLE_VTK_H

#include <gmp.h>
#include <stdint.h>
#include "base/context/context.h"
#include "input/delimited/field.h"
#include "output/table/sink.h"

/** Numbers of VTK for kinds of cells. */
enum { VTK_VERTEX = 1, VTK_LINE = 3, VTK_TRIANGLE = 5, VTK_QUAD = 9, VTK_HEXAHEDRON = 12 };

typedef struct vtk {
    sink to;
    int binary; /* big-endian values, else decimals */
} vtk;

/** The lines before the data. `dataset`: UNSTRUCTURED_GRID or STRUCTURED_POINTS. */
void vtk_begin(const vtk *w, const char *title, const char *dataset);

/** Begin an array of `length` bytes in field data. */
void vtk_bytes_begin(const vtk *w, field name, size_t length);
/** Begin the points; vtk_point puts each. */
void vtk_points_begin(const vtk *w, size_t count);
void vtk_point(const vtk *w, const double at[3]);
/** vtk_point for d rationals: the nearest binary64, ties to even, and 0 for z in the plane.
 * GRAZE_EINPUT past its range. */
graze_status vtk_rational_point(const vtk *w, graze_context *context, const mpq_t *point,
                                int dimension);
/** Begin the cells; vtk_cell puts each. */
void vtk_cells_begin(const vtk *w, size_t count, size_t corners);
void vtk_cell(const vtk *w, const size_t *corner, size_t corners);
/** The types of all cells, which are of one type. */
void vtk_cell_types(const vtk *w, size_t count, unsigned type);

/** Begin the data of points (POINT_DATA) or cells (CELL_DATA). */
void vtk_data_begin(const vtk *w, const char *of, size_t count);
/** Begin a column of `int` or `double`, whose values are put by vtk_int or vtk_double. Blanks in
 * its name become `_`. */
void vtk_scalars_begin(const vtk *w, field name, const char *type);
void vtk_int(const vtk *w, uint32_t value);
void vtk_double(const vtk *w, double value);

void vtk_end(const vtk *w);

#endif
