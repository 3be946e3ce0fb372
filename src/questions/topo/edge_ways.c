/* Ways through pinches and along edges, by the directions around a leading direction or an edge.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/topo/topo.h"

#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "questions/topo/cover.h"
#include "questions/topo/near.h"

/* Ask about a normal of a line or plane that contains e, and about its opposite. */
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

/* Ask about each cell of the circle of directions around e, at a vertex of E^3. */
static graze_status look_about(int *out, germ *g, graze_context *context, const fmpz *e) {
    fmpz *cell;
    size_t count;
    HELD(borders, b, 3);
    *out = 0;
    TRY(borders_about(&b, context, g, e));
    *out = 1;
    borders_around(&cell, &count, &b, 0);
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < count && !status && *out; k++)
        status = cone_meets_line(out, &g->cone, context, cell + 3 * k, e);
    _fmpz_vec_clear(cell, (slong)count * 3);
    return status;
}

/* A direction along the cell, which is an edge of E^3. */
static void direction_of_edge(fmpz *out, const local_cone *cone) {
    _fmpz_vec_zero(out, 3);
    for (size_t j = 1; j < cone->count && _fmpz_vec_is_zero(out, 3); j++)
        directions_cross(out, cone->normal, cone->normal + 3 * j);
}

/* Set `edge_way`: does every line or plane parallel to e and the cell, but the one through the
 * point, meet the cone's interior? */
static graze_status find_edge_way(germ *g, germ_side *side, graze_context *context, int cell) {
    int d = g->cone.dimension;
    LOCAL_VEC(fmpz, edge, 6);
    fmpz *normal = edge + 3;
    if (d == 2 && cell == 0) {
        fmpz_neg(normal, side->e + 1);
        fmpz_set(normal + 1, side->e);
        TRY(look_to_both_sides(&side->edge_way, g, context, normal, side->e));
    } else if (d == 3 && cell == 1) {
        direction_of_edge(edge, &g->cone);
        directions_cross(normal, edge, side->e);
        TRY(look_to_both_sides(&side->edge_way, g, context, normal, side->e));
    } else if (d == 3 && cell == 0) {
        TRY(look_about(&side->edge_way, g, context, side->e));
    }
    return GRAZE_OK;
}

/* Set `covers_edge`: are all directions around the edge covered by sides that keep it? */
static graze_status find_covered_edge(germ *g, graze_context *context) {
    fmpz *cell = NULL;
    LOCAL_VEC(fmpz, edge, 3);
    size_t count = 0;
    int covered = 1;
    germ_cover last = {0, 0, 0, 0}, here = last;
    HELD(borders, b, 3);
    direction_of_edge(edge, &g->cone);
    graze_status status = borders_about(&b, context, g, edge);
    if (!status)
        borders_around(&cell, &count, &b, 0);
    /* full cells have even numbers; the first one is visited again at the end */
    for (size_t k = 0; k < count + 2 && !status && covered; k += 2) {
        germ_cover between = {0, 0, 0, 0};
        last = here;
        here = (germ_cover){0, 0, 0, 0};
        status = germ_cover_body(&here, g, context, cell + 3 * (k % count), 1);
        if (!status && k > 0)
            status = germ_cover_body(&between, g, context, cell + 3 * (k - 1), 1);
        covered = here.open || here.edge_way || here.exact;
        if (k > 0)
            covered = covered && (between.open || between.edge_way || (last.exact && here.exact));
    }
    g->covers_edge = covered && !status;
    _fmpz_vec_clear(cell, (slong)count * 3);
    return status;
}

graze_status edge_ways_find(germ *g, graze_context *context) {
    int cell = cone_cell_dimension(&g->cone);
    for (int s = 0; s < g->side_count; s++)
        TRY(find_edge_way(g, &g->side[s], context, cell));
    if (g->cone.dimension == 3 && cell == 1)
        TRY(find_covered_edge(g, context));
    return GRAZE_OK;
}
