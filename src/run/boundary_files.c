/* Writes boundaries by sampling.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In the plane PLY and VTK have a third coordinate, which is 0.
 */
#include "run/boundary_files.h"

#include <stdio.h>
#include <string.h>
#include "run/status.h"
#include "run/output.h"

#define MISSES "sampled: parts, holes and gaps that hold no point of the sample are not seen"

static output out;

static int ends_in(const char *path, const char *extension) {
    size_t length = strlen(path), tail = strlen(extension);
    return length > tail && strcmp(path + length - tail, extension) == 0;
}

int boundary_check_names(const char *surface, const char *cells, const char *points) {
    if (surface && !ends_in(surface, ".ply") && !ends_in(surface, ".vtk"))
        return complain(EXIT_USAGE, "--surface %s: expected a name in .ply or .vtk", surface);
    if (cells && !ends_in(cells, ".vtk"))
        return complain(EXIT_USAGE, "--cells %s: expected a name in .vtk", cells);
    if (points && !ends_in(points, ".csv") && !ends_in(points, ".vtk"))
        return complain(EXIT_USAGE, "--points %s: expected a name in .csv or .vtk", points);
    return EXIT_DONE;
}

/* Counts between two texts, with blanks in between. */
static void put_counted(const char *before, const size_t *count, int counts, const char *behind) {
    char text[32];
    output_put(&out, before);
    for (int k = 0; k < counts; k++) {
        snprintf(text, sizeof text, k ? " %zu" : "%zu", count[k]);
        output_put(&out, text);
    }
    output_put(&out, behind);
}

static void put_one(const char *before, size_t count, const char *behind) {
    put_counted(before, &count, 1, behind);
}

/* A line of two counts after a word. */
static void put_sizes(const char *word, size_t items, size_t numbers) {
    size_t count[2] = {items, numbers};
    put_counted(word, count, 2, "\n");
}

static void put_coordinates(mpq_t *point, int dimension) {
    char text[128];
    double value[3] = {0, 0, 0};
    for (int k = 0; k < dimension; k++)
        value[k] = mpq_get_d(point[k]);
    snprintf(text, sizeof text, "%.17g %.17g %.17g\n", value[0], value[1], value[2]);
    output_put(&out, text);
}

typedef enum source { OF_POINTS, OF_VERTICES } source;

static void put_all_coordinates(const graze_boundary *b, int dimension, source which,
                                size_t count) {
    mpq_t point[3];
    for (int k = 0; k < 3; k++)
        mpq_init(point[k]);
    for (size_t i = 0; i < count; i++) {
        if (which == OF_VERTICES)
            graze_boundary_vertex(point, b, i);
        else
            (void)graze_boundary_point(point, b, i);
        put_coordinates(point, dimension);
    }
    for (int k = 0; k < 3; k++)
        mpq_clear(point[k]);
}

/* The head of a legacy VTK file, up to its points. meshio reads no POLYDATA, so all are this. */
static void put_vtk(const graze_boundary *b, int dimension, source which, size_t count) {
    output_put(&out, "# vtk DataFile Version 3.0\ngraze " GRAZE_VERSION " boundary; " MISSES "\n"
                     "ASCII\nDATASET UNSTRUCTURED_GRID");
    put_one("\nPOINTS ", count, " double\n");
    put_all_coordinates(b, dimension, which, count);
}

/* Numbers that VTK has for kinds of cells. */
enum { VTK_VERTEX = 1, VTK_LINE = 3, VTK_TRIANGLE = 5, VTK_QUAD = 9, VTK_HEXAHEDRON = 12 };

static void put_types(size_t count, size_t type) {
    put_one("CELL_TYPES ", count, "\n");
    for (size_t i = 0; i < count; i++)
        put_one("", type, "\n");
}

static void put_faces(const graze_boundary *b, int dimension, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const size_t *face = graze_boundary_face(b, i);
        put_counted(dimension == 3 ? "3 " : "2 ", face, dimension, "\n");
    }
}

int boundary_write_surface(const char *path, const graze_boundary *b, int dimension) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    int status = output_open(&out, path);
    if (status)
        return status;
    if (ends_in(path, ".vtk")) {
        put_vtk(b, dimension, OF_VERTICES, s.vertices);
        put_sizes("CELLS ", s.faces, s.faces * (size_t)(dimension + 1));
        put_faces(b, dimension, s.faces);
        put_types(s.faces, dimension == 3 ? VTK_TRIANGLE : VTK_LINE);
        return output_close(&out);
    }
    output_put(&out, "ply\nformat ascii 1.0\ncomment graze " GRAZE_VERSION " boundary\n"
                     "comment " MISSES "\n");
    put_one("element vertex ", s.vertices,
            "\nproperty double x\nproperty double y\nproperty double z\n");
    put_one(dimension == 3 ? "element face " : "element edge ", s.faces,
            dimension == 3 ? "\nproperty list uchar int vertex_indices\nend_header\n"
                           : "\nproperty int vertex1\nproperty int vertex2\nend_header\n");
    put_all_coordinates(b, dimension, OF_VERTICES, s.vertices);
    for (size_t i = 0; i < s.faces && dimension == 2; i++)
        put_counted("", graze_boundary_face(b, i), 2, "\n");
    if (dimension == 3)
        put_faces(b, 3, s.faces);
    return output_close(&out);
}

/* One column of the cells. */
static void put_scalars(const graze_boundary *b, size_t count, const char *name, int which) {
    output_put(&out, "SCALARS ");
    output_put(&out, name);
    output_put(&out, " int 1\nLOOKUP_TABLE default\n");
    for (size_t i = 0; i < count; i++) {
        graze_boundary_cell c = graze_boundary_cell_at(b, i);
        size_t value[3] = {c.level, (size_t)c.pmc, (size_t)c.contact};
        put_one("", value[which], "\n");
    }
}

/* VTK goes round a quadrilateral, where graze_boundary_cell has bits for x, y and z. */
int boundary_write_cells(const char *path, const graze_boundary *b, int dimension) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    static const unsigned round[8] = {0, 1, 3, 2, 4, 5, 7, 6};
    unsigned corners = 1u << dimension;
    int status = output_open(&out, path);
    if (status)
        return status;
    put_vtk(b, dimension, OF_POINTS, s.points);
    put_sizes("CELLS ", s.cells, s.cells * (corners + 1));
    for (size_t i = 0; i < s.cells; i++) {
        graze_boundary_cell c = graze_boundary_cell_at(b, i);
        size_t corner[8];
        for (unsigned k = 0; k < corners; k++)
            corner[k] = c.corners[round[k]];
        put_counted(dimension == 2 ? "4 " : "8 ", corner, (int)corners, "\n");
    }
    put_types(s.cells, dimension == 2 ? VTK_QUAD : VTK_HEXAHEDRON);
    put_one("CELL_DATA ", s.cells, "\n");
    put_scalars(b, s.cells, "level", 0);
    put_scalars(b, s.cells, "pmc", 1);
    put_scalars(b, s.cells, "contact", 2);
    return output_close(&out);
}

static void put_exact_points(const graze_boundary *b, int dimension, size_t count) {
    mpq_t point[3];
    for (int k = 0; k < 3; k++)
        mpq_init(point[k]);
    output_put(&out, dimension == 2 ? "x,y,pmc\n" : "x,y,z,pmc\n");
    for (size_t i = 0; i < count; i++) {
        graze_pmc pmc = graze_boundary_point(point, b, i);
        for (int k = 0; k < dimension; k++) {
            output_number(&out, point[k]);
            output_put(&out, ",");
        }
        output_put(&out, graze_pmc_name(pmc));
        output_put(&out, "\n");
    }
    for (int k = 0; k < 3; k++)
        mpq_clear(point[k]);
}

int boundary_write_points(const char *path, const graze_boundary *b, int dimension) {
    graze_boundary_summary s = graze_boundary_summarize(b);
    int status = output_open(&out, path);
    if (status)
        return status;
    if (ends_in(path, ".csv")) {
        output_put(&out, "# graze " GRAZE_VERSION " boundary\n# " MISSES "\n");
        put_exact_points(b, dimension, s.points);
        return output_close(&out);
    }
    put_vtk(b, dimension, OF_POINTS, s.points);
    put_sizes("CELLS ", s.points, 2 * s.points);
    for (size_t i = 0; i < s.points; i++)
        put_one("1 ", i, "\n");
    put_types(s.points, VTK_VERTEX);
    put_one("POINT_DATA ", s.points, "\nSCALARS pmc int 1\nLOOKUP_TABLE default\n");
    mpq_t point[3];
    for (int k = 0; k < 3; k++)
        mpq_init(point[k]);
    for (size_t i = 0; i < s.points; i++)
        put_one("", (size_t)graze_boundary_point(point, b, i), "\n");
    for (int k = 0; k < 3; k++)
        mpq_clear(point[k]);
    return output_close(&out);
}
