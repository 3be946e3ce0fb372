/* Finds a cell by its name, and the
 * nearest point of the cell that is in contact. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/nearby.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Is `cell` one of the input's names of the cell on which a simplex's side forms `zero` vanish? */
static int has_name(const graze_solid *solid, size_t simplex, unsigned zero,
                    const graze_cell *cell) {
    size_t count;
    graze_cell given = solid_cell(solid, simplex, zero);
    if (given.kind != cell->kind)
        return 0;
    const graze_cell *name = cell_names_of(&count, &solid->cut.names, &given);
    for (size_t k = 0; k < count; k++)
        if (cell_compare(&name[k], cell) == 0)
            return 1;
    return 0;
}

/* Try the contact sets of all simplices of a facet (E^2: an edge); returns the number of the
 * simplices. */
static size_t try_facet(nearby *n, const graze_solid *solid, const graze_cell *cell,
                        const site_side side[2]) {
    size_t found = 0;
    for (size_t k = 0; k < solid->cut.count; k++)
        if (has_name(solid, k, 0, cell)) {
            facet_slice_try(n, solid, k, side);
            found++;
        }
    return found;
}

/* The side forms that vanish at corner k. */
static unsigned sides_at_corner(int k, int dimension) {
    return dimension == 2 ? 1u << k : 1u << k | 1u << (k + 2) % 3;
}

static int try_vertex(nearby *n, const graze_solid *solid, const graze_cell *cell) {
    int d = solid->input.dimension;
    for (size_t s = 0; s < solid->cut.count; s++)
        for (int k = 0; k < d; k++)
            if (has_name(solid, s, sides_at_corner(k, d), cell)) {
                nearby_try(n, solid_corner(solid, s, k));
                return 1;
            }
    return 0;
}

static graze_status try_edge(nearby *n, size_t *found, graze_context *context,
                             const graze_solid *solid, const graze_cell *cell,
                             const site_side side[2]) {
    for (size_t j = 0; j < solid->cut.count; j++)
        for (int k = 0; k < 3; k++)
            if (has_name(solid, j, 1u << k, cell)) {
                *found = 1;
                return edge_run_try(n, context, solid, solid_corner(solid, j, k),
                                    solid_corner(solid, j, (k + 1) % 3), side);
            }
    return GRAZE_OK;
}

static graze_status try_cell(nearby *n, graze_context *context, const graze_scene *scene,
                             const site_side side[2], const graze_cell *cell) {
    const graze_solid *solid = scene->solid;
    size_t found = 0;
    if (cell->kind == GRAZE_CELL_VERTEX)
        found = (size_t)try_vertex(n, solid, cell);
    else if (cell->kind == GRAZE_CELL_EDGE && solid->input.dimension == 3)
        TRY(try_edge(n, &found, context, solid, cell, side));
    else
        found = try_facet(n, solid, cell, side);
    if (!found)
        return context_fail(context, GRAZE_EINPUT,
                            "the solid has no such cell; expected one of its %svertices",
                            solid->input.dimension == 3 ? "faces, edges and " : "edges and ");
    return GRAZE_OK;
}

graze_status snap_find(nearby *n, graze_context *context, const graze_scene *scene, const fmpq_t t,
                       const graze_cell *cell) {
    LOCAL_VEC(fmpq, u, 2);
    site_side side[2] = {{.u = u}, {.u = u + 1}};
    TRY(sides_find(side, context, scene->motion, t));
    sides_add_flows(side, scene->motion);
    graze_status status = try_cell(n, context, scene, side, cell);
    for (int k = 0; k < 2; k++)
        flow_clear(&side[k].flow);
    return status;
}
