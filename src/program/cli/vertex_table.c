/* Writes the signed distances of vertices of meshes, and their answers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "base/context/scope.h"
#include "program/cli/values.h"

static output out;

static const vtk lines = {{output_sink, &out}, 0};

/* Put a bound, moved outwards by one double, so that rounding to 17 digits leaves it a bound. */
static void put_outward(double bound, double out_there, const char *behind) {
    output_format(&out, "%.17g%s", bound == 0 ? 0 : nextafter(bound, out_there), behind);
}

static void put_row_point(graze_rationals point) {
    for (int k = 0; k < 3; k++) {
        output_number(&out, point[k]);
        output_put(&out, ",");
    }
}

static void put_vertex_rows(const graze_mesh *mesh, const graze_enclosure *found, size_t count) {
    HELD(rationals, point, 3);
    output_put(&out, "x,y,z,pmc,sdf_low,sdf_high\n");
    for (size_t v = 0; v < count; v++) {
        graze_mesh_vertex(point.at, mesh, v);
        put_row_point((graze_rationals)point.at);
        output_format(&out, "%s,", graze_pmc_name(found[v].pmc));
        put_outward(found[v].low, -HUGE_VAL, ",");
        put_outward(found[v].high, HUGE_VAL, "\n");
    }
}

static int put_vertex_points(const graze_mesh *mesh, graze_context *context, size_t count) {
    HELD(rationals, point, 3);
    vtk_points_begin(&lines, count);
    for (size_t v = 0; v < count; v++) {
        graze_mesh_vertex(point.at, mesh, v);
        TRY(complain_of(vtk_rational_point(&lines, context, point.at, 3), context));
    }
    return EXIT_DONE;
}

static void put_vertex_column(const char *name, const graze_enclosure *found, size_t count,
                              int high) {
    vtk_scalars_begin(&lines, (field){name, strlen(name)}, "double");
    for (size_t v = 0; v < count; v++)
        vtk_double(&lines, high ? found[v].high : found[v].low);
    vtk_end(&lines);
}

static int put_vertex_vtk(const graze_mesh *mesh, graze_context *context,
                          const graze_enclosure *found, const graze_mesh_facts *facts) {
    vtk_begin(&lines, "graze " GRAZE_VERSION " judge", "UNSTRUCTURED_GRID");
    TRY(put_vertex_points(mesh, context, facts->vertices));
    vtk_cells_begin(&lines, facts->triangles, 3);
    for (size_t k = 0; k < facts->triangles; k++) {
        size_t corner[3] = {0, 0, 0};
        graze_mesh_triangle(corner, mesh, k);
        vtk_cell(&lines, corner, 3);
    }
    vtk_cell_types(&lines, facts->triangles, VTK_TRIANGLE);
    vtk_data_begin(&lines, "POINT_DATA", facts->vertices);
    put_vertex_column("sdf_low", found, facts->vertices, 0);
    put_vertex_column("sdf_high", found, facts->vertices, 1);
    vtk_scalars_begin(&lines, (field){"pmc", 3}, "int");
    for (size_t v = 0; v < facts->vertices; v++)
        vtk_int(&lines, (uint32_t)found[v].pmc);
    vtk_end(&lines);
    return EXIT_DONE;
}

int vertex_table_write(const char *path, graze_context *context, const graze_mesh *mesh,
                       const graze_enclosure *found) {
    graze_mesh_facts facts = graze_mesh_get_facts(mesh);
    TRY(output_open(&out, path));
    if (!path_has_extension(path, ".vtk")) {
        put_vertex_rows(mesh, found, facts.vertices);
        return output_close(&out);
    }
    int status = put_vertex_vtk(mesh, context, found, &facts);
    if (status)
        output_drop(&out);
    return output_end(&out, status);
}

int answer_table_write(const char *path, int parity, graze_rationals points, const graze_pmc *found,
                       size_t count) {
    TRY(output_open(&out, path));
    output_put(&out, "# graze " GRAZE_VERSION "\n# answers-of mesh\n# inside ");
    output_put(&out, parity ? "parity\nx,y,z,pmc\n" : "winding\nx,y,z,pmc\n");
    for (size_t k = 0; k < count; k++) {
        put_row_point(points + 3 * k);
        output_format(&out, "%s\n", graze_pmc_name(found[k]));
    }
    output_format(&out, "# complete %zu\n", count);
    return output_close(&out);
}
