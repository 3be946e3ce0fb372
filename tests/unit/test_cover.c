/* Ways along edges (questions/topo/cover.h): directions opposite to that of a side, and those along
 * the cell, of a cube's corner, edge and face. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * u lies opposite to e where u + s e, s > 0, is a direction of the cell: 0 alone at a corner, a
 * multiple of (0, 0, 1) on the edge along z, any (0, y, z) on the face x = 0.
 */
#include "input/solid/solid.h"
#include "questions/topo/cover.h"
#include "questions/topo/topo.h"
#include "fixture.h"

enum { CORNER, EDGE, FACE };

static const fmpz place[][4] = {{0, 0, 0, 1}, {0, 0, 1, 1}, {0, 1, 1, 1}};

typedef struct row {
    int at;
    fmpz e[3], u[3];
    int is_way;
} row;

static const row rows[] = {
    {CORNER, {1, 2, 0}, {-1, -2, 0}, 1},  {CORNER, {1, 2, 0}, {-3, -6, 0}, 1},
    {CORNER, {3, 6, 0}, {-1, -2, 0}, 1},  {CORNER, {1, 2, 0}, {1, 2, 0}, 0}, /* e itself */
    {CORNER, {1, 2, 0}, {-1, -2, 1}, 0},                                     /* askew in z alone */
    {CORNER, {1, 2, 0}, {-1, -3, 0}, 0},  {CORNER, {1, 2, 0}, {-1, 2, 0}, 0},
    {CORNER, {0, 0, 1}, {0, 0, -1}, 1},   {CORNER, {0, 0, 1}, {1, 0, -1}, 0},
    {CORNER, {0, 0, 1}, {0, -1, -1}, 0},  {CORNER, {0, 0, 1}, {0, 0, 1}, 0},
    {CORNER, {1, 0, 0}, {-1, 0, 0}, 1},   {CORNER, {1, 0, 0}, {0, 1, 0}, 0},
    {CORNER, {-1, -1, -1}, {1, 1, 1}, 1}, {CORNER, {-1, -1, -1}, {1, 1, -1}, 0},
    {EDGE, {1, 1, 0}, {-1, -1, 0}, 1},    {EDGE, {1, 1, 0}, {-2, -2, 5}, 1},
    {EDGE, {1, 1, 7}, {-1, -1, 0}, 1},    {EDGE, {1, 1, 0}, {1, 1, -5}, 0},
    {EDGE, {1, 1, 0}, {0, 0, 1}, 0}, /* along the edge, which e is not */
    {EDGE, {0, 1, 0}, {1, -1, 0}, 0},     {FACE, {1, 0, 0}, {-1, 5, 5}, 1},
    {FACE, {1, 0, 0}, {1, -5, 0}, 0},     {FACE, {1, 3, 0}, {0, -3, 0}, 0},
};
/* With e zero: of a germ that covers an edge on both sides. */
static const row along_cell[] = {
    {EDGE, {0, 0, 0}, {0, 0, 1}, 1},
    {EDGE, {0, 0, 0}, {0, 0, -2}, 1},
    {EDGE, {0, 0, 0}, {1, 0, 1}, 0},
    {EDGE, {0, 0, 0}, {0, -1, 0}, 0},
};

static graze_solid *cube(void) {
    static const double at[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0,
                                0, 0, 2, 2, 0, 2, 0, 2, 2, 2, 2, 2};
    static const size_t sizes[] = {4, 4, 4, 4, 4, 4};
    static const size_t index[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                   2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    graze_solid *solid;
    assert_int_equal(graze_solid_from_doubles(&solid, context, 3, at, 8, sizes, 6, index, 0),
                     GRAZE_OK);
    return solid;
}

static void check_row(const graze_solid *solid, const plane_list *planes, const row *r, size_t k) {
    germ g = {.side_count = 1};
    germ_cover cover = {0, 0, 0, 0};
    fmpz u[3] = {r->u[0], r->u[1], r->u[2]};
    int has_side = r->e[0] || r->e[1] || r->e[2];
    memcpy(g.side[0].e, r->e, sizeof r->e);
    g.side_count = g.side[0].edge_way = has_side;
    g.covers_edge = !has_side;
    assert_int_equal(cone_make(&g.cone, context, solid, 0, planes, place[r->at]), GRAZE_OK);
    assert_int_equal(germ_cover_body(&cover, &g, context, u, 0), GRAZE_OK);
    if (cover.edge_way != r->is_way || (r->is_way && !cover.covered))
        fail_msg("row %zu: edge_way %d, covered %d", k, cover.edge_way, cover.covered);
    cone_clear(&g.cone);
}

static void ways(void **state) {
    (void)state;
    plane_list planes;
    graze_solid *solid = cube();
    assert_int_equal(planes_find(&planes, NULL, solid, NULL, solid->cut.count), 0);
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        check_row(solid, &planes, &rows[k], k);
    for (size_t k = 0; k < sizeof along_cell / sizeof *along_cell; k++)
        check_row(solid, &planes, &along_cell[k], k);
    planes_clear(&planes);
    graze_solid_destroy(solid);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ways)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
