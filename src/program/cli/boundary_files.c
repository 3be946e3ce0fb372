/* Writes boundaries by sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In the plane PLY and VTK have a third coordinate, which is 0. PLY and VTK have the same lines for
 * points and cells, so the functions for VTK write both.
 */
#include <math.h>
#include "base/context/scope.h"
#include "program/cli/values.h"

#define MISSES "sampled: parts, holes and gaps that hold no point of the sample are not seen"

static output out;

static const vtk lines = {{output_sink, &out}, 0};

typedef enum source { OF_POINTS, OF_VERTICES } source;

static int put_coordinates(const graze_boundary *b, graze_context *context, int dimension,
                           source which, size_t count) {
    HELD(rationals, point, 3);
    for (size_t i = 0; i < count; i++) {
        if (which == OF_VERTICES)
            graze_boundary_vertex(point.at, b, i);
        else
            (void)graze_boundary_point(point.at, b, i);
        TRY(complain_of(vtk_rational_point(&lines, context, point.at, dimension), context));
    }
    return EXIT_DONE;
}

/* Put a legacy VTK file up to the end of its points. The file is an unstructured grid, since meshio
 * reads no POLYDATA. */
static int put_vtk_points(const graze_boundary *b, graze_context *context, int dimension,
                          source which, size_t count) {
    vtk_begin(&lines, "graze " GRAZE_VERSION " boundary; " MISSES, "UNSTRUCTURED_GRID");
    vtk_points_begin(&lines, count);
    return put_coordinates(b, context, dimension, which, count);
}

static void put_faces(const graze_boundary *b, int dimension, size_t count) {
    for (size_t i = 0; i < count; i++)
        vtk_cell(&lines, graze_boundary_face(b, i), (size_t)dimension);
}

static int put_ply(const graze_boundary *b, graze_context *context, int dimension,
                   const graze_boundary_summary *s) {
    output_put(&out, "ply\nformat ascii 1.0\ncomment graze " GRAZE_VERSION " boundary\n"
                     "comment " MISSES "\n");
    output_format(&out,
                  "element vertex %zu\nproperty double x\nproperty double y\nproperty double z\n",
                  s->vertices);
    output_format(
        &out,
        dimension == 3
            ? "element face %zu\nproperty list uchar int vertex_indices\nend_header\n"
            : "element edge %zu\nproperty int vertex1\nproperty int vertex2\nend_header\n",
        s->faces);
    TRY(put_coordinates(b, context, dimension, OF_VERTICES, s->vertices));
    for (size_t i = 0; i < s->faces && dimension == 2; i++) {
        const size_t *edge = graze_boundary_face(b, i);
        output_format(&out, "%zu %zu\n", edge[0], edge[1]);
    }
    if (dimension == 3)
        put_faces(b, 3, s->faces);
    return EXIT_DONE;
}

/* Put the normal of a face; 0 0 0 if its corners in doubles give no direction. */
static void put_normal(double at[3][3]) {
    double normal[3], length = 0;
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        normal[k] = (at[1][i] - at[0][i]) * (at[2][j] - at[0][j]) -
                    (at[1][j] - at[0][j]) * (at[2][i] - at[0][i]);
        length = fmax(length, fabs(normal[k]));
    }
    double scale = 0, squares = 0;
    for (int k = 0; k < 3 && length > 0; k++)
        squares += normal[k] / length * (normal[k] / length);
    if (squares > 0)
        scale = 1 / (length * sqrt(squares));
    if (!(scale < HUGE_VAL))
        scale = 0;
    output_format(&out, "facet normal %.9g %.9g %.9g\nouter loop\n", normal[0] * scale,
                  normal[1] * scale, normal[2] * scale);
}

/* Put STL as text, since the binary form, with 32 bits for each coordinate, could make vertices
 * equal. */
static int put_stl(const graze_boundary *b, graze_context *context,
                   const graze_boundary_summary *s) {
    HELD(rationals, point, 3);
    output_put(&out, "solid graze " GRAZE_VERSION " boundary; " MISSES "\n");
    for (size_t i = 0; i < s->faces; i++) {
        const size_t *face = graze_boundary_face(b, i);
        double at[3][3];
        for (int k = 0; k < 3; k++) {
            graze_boundary_vertex(point.at, b, face[k]);
            for (int j = 0; j < 3; j++)
                at[k][j] = mpq_get_d(point.at[j]);
        }
        put_normal(at);
        for (int k = 0; k < 3; k++) {
            output_put(&out, "vertex ");
            graze_boundary_vertex(point.at, b, face[k]);
            TRY(complain_of(vtk_rational_point(&lines, context, point.at, 3), context));
        }
        output_put(&out, "endloop\nendfacet\n");
    }
    output_put(&out, "endsolid\n");
    return EXIT_DONE;
}

/* Close the file; after a failure it is emptied first. */
static int close_whole(int status) {
    if (status)
        output_drop(&out);
    return output_end(&out, status);
}

int boundary_write_surface(const char *path, const graze_boundary *b, graze_context *context,
                           int dimension) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    TRY(output_open(&out, path));
    if (path_has_extension(path, ".stl"))
        return close_whole(put_stl(b, context, &s));
    if (!path_has_extension(path, ".vtk"))
        return close_whole(put_ply(b, context, dimension, &s));
    int status = put_vtk_points(b, context, dimension, OF_VERTICES, s.vertices);
    vtk_cells_begin(&lines, s.faces, (size_t)dimension);
    put_faces(b, dimension, s.faces);
    vtk_cell_types(&lines, s.faces, dimension == 3 ? VTK_TRIANGLE : VTK_LINE);
    return close_whole(status);
}

/* Put one column of the cells: level, pmc or contact. */
static void put_column(const graze_boundary *b, size_t count, const char *name, int which) {
    vtk_scalars_begin(&lines, (field){name, strlen(name)}, "int");
    for (size_t i = 0; i < count; i++) {
        graze_boundary_cell c = graze_boundary_cell_at(b, i);
        unsigned value[3] = {c.level, (unsigned)c.pmc, (unsigned)c.contact};
        vtk_int(&lines, value[which]);
    }
}

/* VTK lists corners in order around each quadrilateral; graze_boundary_cell numbers them by bits
 * for x, y and z. `round` converts. */
int boundary_write_cells(const char *path, const graze_boundary *b, graze_context *context,
                         int dimension) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    static const unsigned round[8] = {0, 1, 3, 2, 4, 5, 7, 6};
    size_t corners = (size_t)1 << dimension;
    TRY(output_open(&out, path));
    int status = put_vtk_points(b, context, dimension, OF_POINTS, s.points);
    vtk_cells_begin(&lines, s.cells, corners);
    for (size_t i = 0; i < s.cells; i++) {
        graze_boundary_cell c = graze_boundary_cell_at(b, i);
        size_t corner[8];
        for (size_t k = 0; k < corners; k++)
            corner[k] = c.corners[round[k]];
        vtk_cell(&lines, corner, corners);
    }
    vtk_cell_types(&lines, s.cells, dimension == 2 ? VTK_QUAD : VTK_HEXAHEDRON);
    vtk_data_begin(&lines, "CELL_DATA", s.cells);
    put_column(b, s.cells, "level", 0);
    put_column(b, s.cells, "pmc", 1);
    put_column(b, s.cells, "contact", 2);
    return close_whole(status);
}

static void put_exact_points(const graze_boundary *b, int dimension, size_t count) {
    HELD(rationals, point, 3);
    output_put(&out, dimension == 2 ? "x,y,pmc\n" : "x,y,z,pmc\n");
    for (size_t i = 0; i < count; i++) {
        graze_pmc pmc = graze_boundary_point(point.at, b, i);
        for (int k = 0; k < dimension; k++) {
            output_number(&out, point.at[k]);
            output_put(&out, ",");
        }
        output_format(&out, "%s\n", graze_pmc_name(pmc));
    }
}

int boundary_write_points(const char *path, const graze_boundary *b, graze_context *context,
                          int dimension) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    TRY(output_open(&out, path));
    if (path_has_extension(path, ".csv")) {
        output_put(&out, "# graze " GRAZE_VERSION " boundary\n# " MISSES "\n");
        put_exact_points(b, dimension, s.points);
        return output_close(&out);
    }
    int status = put_vtk_points(b, context, dimension, OF_POINTS, s.points);
    vtk_cells_begin(&lines, s.points, 1);
    for (size_t i = 0; i < s.points; i++)
        vtk_cell(&lines, &i, 1);
    vtk_cell_types(&lines, s.points, VTK_VERTEX);
    vtk_data_begin(&lines, "POINT_DATA", s.points);
    vtk_scalars_begin(&lines, (field){"pmc", 3}, "int");
    HELD(rationals, point, 3);
    for (size_t i = 0; i < s.points; i++)
        vtk_int(&lines, (unsigned)graze_boundary_point(point.at, b, i));
    return close_whole(status);
}
