/* Ways through pinches and along edges, by the directions around a leading direction or an edge.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/near.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* Do the lines along e through `normal` and through its opposite both meet the cone's interior? */
static graze_status look_to_both_sides(int *out, germ *g, graze_context *context,
                                       const fmpz *normal, const fmpz *e) {
    slong d = g->cone.dimension;
    LOCAL_VEC(fmpz, other, d);
    _fmpz_vec_neg(other, normal, d);
    TRY(cone_meets_line(out, &g->cone, context, normal, e));
    if (*out)
        TRY(cone_meets_line(out, &g->cone, context, other, e));
    return GRAZE_OK;
}

/* Does the line along e through each cell of directions around e meet the cone's interior? For a
 * vertex of E^3. */
static graze_status look_about(int *out, germ *g, graze_context *context, const fmpz *e) {
    HELD(borders, b, 3);
    *out = 0;
    TRY(borders_about(&b, context, g, e));
    HELD(ray_cells, cells, &b, 0);
    *out = 1;
    for (size_t k = 0; k < cells.count && *out; k++)
        TRY(cone_meets_line(out, &g->cone, context, cells.item + 3 * k, e));
    return GRAZE_OK;
}

/* A direction along the cell, which is an edge of E^3. */
static void direction_of_edge(fmpz *out, const local_cone *cone) {
    _fmpz_vec_zero(out, 3);
    for (size_t j = 1; j < cone->count && _fmpz_vec_is_zero(out, 3); j++)
        integers_cross(out, cone->normal, cone->normal + 3 * j);
}

/* Set `edge_way`: does every line or plane parallel to e and the cell, but the one through the
 * point, meet the cone's interior? */
static graze_status find_edge_way(germ *g, germ_side *side, graze_context *context, int cell) {
    int d = g->cone.dimension;
    LOCAL_VEC(fmpz, edge, 6);
    fmpz *normal = edge + 3;
    if (d == 3 && cell == 0)
        return look_about(&side->edge_way, g, context, side->e);
    if (cell != d - 2)
        return GRAZE_OK;
    if (d == 2) {
        fmpz_neg(normal, side->e + 1);
        fmpz_set(normal + 1, side->e);
    } else {
        direction_of_edge(edge, &g->cone);
        integers_cross(normal, edge, side->e);
    }
    return look_to_both_sides(&side->edge_way, g, context, normal, side->e);
}

/* Set `covers_edge`: are all directions around the edge covered by sides that keep it? */
static graze_status find_covered_edge(germ *g, graze_context *context) {
    LOCAL_VEC(fmpz, edge, 3);
    int covered = 1;
    germ_cover here = {0, 0, 0, 0};
    HELD(borders, b, 3);
    direction_of_edge(edge, &g->cone);
    TRY(borders_about(&b, context, g, edge));
    HELD(ray_cells, cells, &b, 0);
    /* full cells have even numbers; the first one is visited again at the end */
    for (size_t k = 0; k < cells.count + 2 && covered; k += 2) {
        germ_cover between = {0, 0, 0, 0}, last = here;
        here = between;
        TRY(germ_cover_body(&here, g, context, cells.item + 3 * (k % cells.count), 1));
        covered = here.open || here.edge_way || here.exact;
        if (k == 0)
            continue;
        TRY(germ_cover_body(&between, g, context, cells.item + 3 * (k - 1), 1));
        covered = covered && (between.open || between.edge_way || (last.exact && here.exact));
    }
    g->covers_edge = covered;
    return GRAZE_OK;
}

graze_status edge_ways_find(germ *g, graze_context *context) {
    int cell = cone_cell_dimension(&g->cone);
    for (int s = 0; s < g->side_count; s++)
        TRY(find_edge_way(g, &g->side[s], context, cell));
    if (g->cone.dimension == 3 && cell == 1)
        TRY(find_covered_edge(g, context));
    return GRAZE_OK;
}
