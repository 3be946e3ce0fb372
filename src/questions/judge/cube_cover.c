/* The planes of the facets that are near the cube, at a few times, cut the cube into cells; each
 * cell is inside or outside each position. A cell that no position covers gives the next time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/judge/cube.h"

#include "base/context/scope.h"
#include "base/number/rounding.h"

/* Bound of the number of positions. */
enum { POSITIONS = 8 };

/* Times are rounded to multiples of 1 / TIMES of a piece, so that their numbers are short; the
 * proof holds with any time. */
static const double TIMES = 0x1p16;

typedef struct covering {
    cell_asker *ask;
    cube_cells cells;
    int count;
    fmpq *map; /* for each position the map into the solid's own space */
    span near; /* places of the cube's points at the current time */
} covering;

/* The plane of a facet at a position, in the space of query points. */
static void add_position_plane(covering *c, uint32_t simplex) {
    const graze_solid *solid = c->ask->scene->solid;
    const fmpq *map = c->map + 12 * c->count;
    LOCAL_VEC(fmpz, body, 4);
    LOCAL_VEC(fmpq, plane, 5);
    (void)solid_plane(body, solid, simplex);
    fmpq_set_fmpz(plane + 3, body + 3);
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 3; i++) {
            fmpq_mul_fmpz(plane + 4, map + 4 * i + j, body + i);
            fmpq_add(plane + j, plane + j, plane + 4);
        }
    cube_cells_plane(&c->cells, plane);
}

static void add_position_planes(covering *c, const box *around, uint32_t node) {
    const graze_solid *solid = c->ask->scene->solid;
    const tree_node *here = &solid->boxes.node[node];
    if (!box_meets(&here->box, around) || c->cells.failed)
        return;
    if (here->child) {
        add_position_planes(c, around, here->child);
        add_position_planes(c, around, here->child + 1);
    } else if (chord_meets(&c->ask->tube, &c->near, solid->corners.at + (size_t)here->simplex * 9,
                           solid->corners.error) != CHORD_MISSES) {
        add_position_plane(c, here->simplex);
    }
}

/* Add a position that has the point inside; 0 if none is found. */
static int add_position(covering *c, const cube *of, const fmpq *point) {
    const graze_scene *scene = c->ask->scene;
    point_box cell = {.half = {0, 0, 0}};
    piece_time when[CERTAIN_TIMES_MOST];
    box around;
    fmpq_t at;
    for (int i = 0; i < 3; i++) {
        double unused;
        rational_bounds(&cell.centre[i], &unused, point + i);
    }
    if (c->count == POSITIONS || !cell_certain_times(when, c->ask, &cell))
        return 0;
    for (int i = 0; i < 3; i++) {
        cell.centre[i] = of->centre[i];
        cell.half[i] = of->half;
    }
    when->at = rint(when->at * TIMES) / TIMES;
    if (!point_box_begin(&c->ask->tube, &scene->filter, &cell) ||
        !point_box_places(&around, &c->ask->tube, &scene->filter, when, cell.half))
        return 0;
    fmpq_init(at);
    (void)rational_from_double(at, NULL, when->at);
    point_map_at(c->map + 12 * c->count,
                 motion_tracing(scene->motion->piece + when->piece, scene->options.operation), at);
    fmpq_clear(at);
    span_of_box(&c->near, &c->ask->tube, &around);
    add_position_planes(c, &around, 0);
    c->count++;
    return !c->cells.failed;
}

static int is_in_position(const covering *c, const fmpq *point, const fmpq *map) {
    LOCAL_VEC(fmpq, place, 3);
    LOCAL_VEC(fmpz, x, 4);
    for (int i = 0; i < 3; i++) {
        _fmpq_vec_dot(place + i, map + 4 * i, point, 3);
        fmpq_add(place + i, place + i, map + 4 * i + 3);
    }
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, place, 3);
    return solid_locate(c->ask->scene->solid, x) == GRAZE_STATE_I;
}

/* A point of a cell that no position covers; NULL if positions cover all cells. */
static const fmpq *find_uncovered(const covering *c) {
    for (size_t k = 0; k < c->cells.count; k++) {
        int covered = 0;
        for (int p = 0; p < c->count && !covered; p++)
            covered = is_in_position(c, c->cells.item[k].at, c->map + 12 * p);
        if (!covered)
            return c->cells.item[k].at;
    }
    return NULL;
}

graze_status cube_is_covered(int *done, cell_asker *ask, const cube *of) {
    covering c = {.ask = ask, .map = _fmpq_vec_init(12 * POSITIONS)};
    const fmpq *open = NULL;
    graze_status status;
    cube_cells_init(&c.cells, ask->context);
    do {
        status = cube_cells_make(&c.cells, of);
        open = status || c.cells.failed ? NULL : find_uncovered(&c);
        *done = !status && !c.cells.failed && !open;
    } while (open && add_position(&c, of, open));
    cube_cells_clear(&c.cells);
    _fmpq_vec_clear(c.map, 12 * POSITIONS);
    return status ? status : context_poll(ask->context);
}
