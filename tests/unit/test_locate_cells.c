/* Location (input/solid/solid.h) in affine images of sets of grid cells, in E^2 and E^3: solids
 * that are not convex, with cavities, holes and several components, which may touch in edges and
 * vertices. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The second method knows no ray: of the cells around a point of the grid, all belong to the set,
 * or none, or some, and the point is in its interior, outside, or on its boundary. Under maps along
 * the axes the ray of the location runs in faces and meets edges and vertices.
 */
#include <flint/fmpq_mat.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "../lib/random.h"
#include "input/solid/solid.h"
#include "fixture.h"

enum {
    N = 4,
    SIDE = N + 1,
    CORNERS = SIDE * SIDE * SIDE,
    MOST = 6 * N * N * N,
    SETS = 160,
    POINTS = 120
};

typedef struct cells {
    int d;
    unsigned char full[N][N][N]; /* d = 2: of the last index 0 alone */
} cells;

/* The boundary as facets over corners of the grid, numbered as they come. */
typedef struct surface {
    size_t facets, indices, vertices;
    size_t size[2 * MOST], index[8 * MOST];
    int number[CORNERS]; /* of a corner, -1 where it is no vertex */
    int at[CORNERS][3];
} surface;

static int is_full(const cells *c, const int *at) {
    for (int k = 0; k < 3; k++)
        if (at[k] < 0 || at[k] >= (k < c->d ? N : 1))
            return 0;
    return c->full[at[0]][at[1]][at[2]];
}

/* The next cell in the order of the indices; 0 behind the last one. */
static int next_cell(const cells *c, int *at) {
    for (int k = 0; k < c->d; k++) {
        if (++at[k] < N)
            return 1;
        at[k] = 0;
    }
    return 0;
}

static void put_corner(surface *s, const int *at) {
    int *number = &s->number[(at[0] * SIDE + at[1]) * SIDE + at[2]];
    if (*number < 0) {
        *number = (int)s->vertices;
        memcpy(s->at[s->vertices++], at, sizeof s->at[0]);
    }
    s->index[s->indices++] = (size_t)*number;
}

/* A unit square, outward oriented, or its two triangles. */
static void put_square(surface *s, const int *cell, int axis, int side, int triangles) {
    static const int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const int whole[] = {0, 1, 2, 3}, halves[] = {0, 1, 2, 0, 2, 3};
    for (int k = 0; k < (triangles ? 6 : 4); k++) {
        int corner = triangles ? halves[k] : whole[k], at[3] = {cell[0], cell[1], cell[2]};
        const int *step = around[side ? corner : 3 - corner];
        at[axis] += side;
        at[(axis + 1) % 3] += step[0];
        at[(axis + 2) % 3] += step[1];
        put_corner(s, at);
    }
    for (int k = 0; k <= triangles; k++)
        s->size[s->facets++] = triangles ? 3 : 4;
}

static void put_squares(surface *s, const cells *c, int triangles) {
    int at[3] = {0, 0, 0};
    do {
        for (int k = 0; k < 6 && is_full(c, at); k++) {
            int beside[3] = {at[0], at[1], at[2]};
            beside[k / 2] += k % 2 ? 1 : -1;
            if (!is_full(c, beside))
                put_square(s, at, k / 2, k % 2, triangles);
        }
    } while (next_cell(c, at));
}

/* An edge of the plane's boundary, its cell on the left. */
typedef struct edge {
    int from[2], to[2], cell[2], used;
} edge;

static size_t list_edges(edge *out, const cells *c) {
    static const int corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const int side[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    size_t count = 0;
    int at[3] = {0, 0, 0};
    do {
        for (int k = 0; k < 4 && is_full(c, at); k++) {
            int beside[3] = {at[0] + side[k][0], at[1] + side[k][1], 0};
            if (is_full(c, beside))
                continue;
            const int *a = corner[k], *b = corner[(k + 1) % 4];
            out[count++] = (edge){
                {at[0] + a[0], at[1] + a[1]}, {at[0] + b[0], at[1] + b[1]}, {at[0], at[1]}, 0};
        }
    } while (next_cell(c, at));
    return count;
}

/* The unused edge that goes on from `last`, along its own cell where two cells meet in a corner. */
static edge *next_edge(edge *edges, size_t count, const edge *last) {
    edge *found = NULL;
    for (edge *e = edges; e < edges + count; e++)
        if (!e->used && memcmp(e->from, last->to, sizeof e->from) == 0 &&
            (!found || memcmp(e->cell, last->cell, sizeof e->cell) == 0))
            found = e;
    assert_non_null(found);
    return found;
}

/* The edges as rings that visit no vertex twice: a path is cut where it comes back to itself. */
static void put_rings(surface *s, const cells *c) {
    edge edges[4 * N * N], *path[4 * N * N];
    size_t count = list_edges(edges, c);
    for (size_t first = 0; first < count; first++) {
        size_t length = 0;
        for (edge *next = &edges[first]; !next->used;) {
            next->used = 1;
            path[length++] = next;
            size_t back = 0;
            while (back < length && memcmp(path[back]->from, next->to, sizeof next->to) != 0)
                back++;
            for (size_t k = back; k < length; k++)
                put_corner(s, (const int[3]){path[k]->from[0], path[k]->from[1], 0});
            if (back < length)
                s->size[s->facets++] = length - back;
            length = back;
            if (length > 0)
                next = next_edge(edges, count, next);
        }
    }
}

/* Every corner of the grid times a matrix, moved. */
typedef struct map {
    int d;
    fmpq_mat_t linear, offset;
} map;

static void map_init(map *m, int d, int kind) {
    static const ulong denominator[] = {1, 3, 7, 1024};
    m->d = d;
    fmpq_mat_init(m->linear, d, d);
    fmpq_mat_init(m->offset, d, 1);
    fmpq_t volume;
    fmpq_init(volume);
    while (fmpq_sgn(volume) <= 0) {
        for (int i = 0; i < d; i++) {
            for (int j = 0; j < d; j++) {
                int zero = kind == 0 ? i != j : kind == 1 && i > j;
                fmpq_set_si(fmpq_mat_entry(m->linear, i, j), zero ? 0 : random_about(9),
                            denominator[draw_below(4)]);
            }
            fmpq_set_si(fmpq_mat_entry(m->offset, i, 0), random_about(40),
                        denominator[draw_below(4)]);
        }
        fmpq_mat_det(volume, m->linear);
    }
    fmpq_clear(volume);
}

static void map_clear(map *m) {
    fmpq_mat_clear(m->linear);
    fmpq_mat_clear(m->offset);
}

static void map_point(fmpq *out, const map *m, const fmpq *p) {
    fmpq_t term;
    fmpq_init(term);
    for (int i = 0; i < m->d; i++) {
        fmpq_set(out + i, fmpq_mat_entry(m->offset, i, 0));
        for (int j = 0; j < m->d; j++) {
            fmpq_mul(term, fmpq_mat_entry(m->linear, i, j), p + j);
            fmpq_add(out + i, out + i, term);
        }
    }
    fmpq_clear(term);
}

static graze_solid *make_solid(const surface *s, const map *m) {
    size_t d = (size_t)m->d;
    fmpq *corner = _fmpq_vec_init(3), *image = _fmpq_vec_init(3);
    mpq_t *x = malloc(s->vertices * d * sizeof *x);
    for (size_t v = 0; v < s->vertices; v++) {
        for (int j = 0; j < m->d; j++)
            fmpq_set_si(corner + j, s->at[v][j], 1);
        map_point(image, m, corner);
        for (size_t j = 0; j < d; j++) {
            mpq_init(x[v * d + j]);
            fmpq_get_mpq(x[v * d + j], image + j);
        }
    }
    graze_solid *solid;
    graze_status status = graze_solid_from_arrays(&solid, context, m->d, x, s->vertices, s->size,
                                                  s->facets, s->index, 0);
    if (status != GRAZE_OK)
        fail_msg("%s", graze_context_message(context));
    for (size_t k = 0; k < s->vertices * d; k++)
        mpq_clear(x[k]);
    free(x);
    _fmpq_vec_clear(corner, 3);
    _fmpq_vec_clear(image, 3);
    return solid;
}

/* The state of a point of the grid by the cells around it: two at a whole coordinate, else one. */
static graze_state expected_state(const cells *c, const fmpq *p) {
    int low[3] = {0, 0, 0}, high[3] = {0, 0, 0}, full = 0, all = 0;
    fmpz_t floor;
    fmpz_init(floor);
    for (int j = 0; j < c->d; j++) {
        fmpz_fdiv_q(floor, fmpq_numref(p + j), fmpq_denref(p + j));
        high[j] = (int)fmpz_get_si(floor);
        low[j] = high[j] - (int)fmpz_is_one(fmpq_denref(p + j));
    }
    fmpz_clear(floor);
    int at[3];
    for (at[0] = low[0]; at[0] <= high[0]; at[0]++)
        for (at[1] = low[1]; at[1] <= high[1]; at[1]++)
            for (at[2] = low[2]; at[2] <= high[2]; at[2]++, all++)
                full += is_full(c, at);
    return full == all ? GRAZE_STATE_I : full == 0 ? GRAZE_STATE_O : GRAZE_STATE_B;
}

/* Halves, so that faces, edges and vertices are met, some of them moved aside by little or more. */
static void draw_point(fmpq *p, int d) {
    fmpq_t step;
    fmpq_init(step);
    int aside = draw_below(3) == 0;
    for (int j = 0; j < d; j++) {
        fmpq_set_si(p + j, draw_below(2 * N + 3) - 1, 2);
        fmpq_canonicalise(p + j);
        fmpq_set_si(step, random_about(1), draw_below(2) ? 3 : 1);
        if (fmpz_is_one(fmpq_denref(step)))
            fmpq_div_2exp(step, step, 60);
        if (aside)
            fmpq_add(p + j, p + j, step);
    }
    fmpq_clear(step);
}

/* The first sets have a known form, the others are random. */
static void draw_cells(cells *c, int d, int number) {
    *c = (cells){.d = d};
    int at[3] = {0, 0, 0}, any = 0, dense = (int)draw_below(2);
    do {
        int inner = 1, last = 1, first = 1;
        for (int k = 0; k < d; k++) {
            inner &= at[k] == 1;
            first &= at[k] == 0;
            last &= at[k] == N - 1;
        }
        int full = number == 0   ? !inner               /* a cavity; in the plane a hole */
                   : number == 1 ? first || last        /* two components apart */
                   : number == 2 ? inner || first       /* two that touch in a vertex */
                   : number == 3 ? at[0] == 0 || !at[1] /* not convex */
                                 : draw_below(8) < (dense ? 7 : 4);
        c->full[at[0]][at[1]][at[2]] = (unsigned char)full;
        any |= full;
    } while (next_cell(c, at));
    c->full[0][0][0] |= !any;
}

static graze_state locate(const graze_solid *solid, const fmpq *x, int d) {
    fmpz *at = _fmpz_vec_init(4);
    _fmpq_vec_get_fmpz_vec_fmpz(at, at + d, x, d);
    graze_state state = solid_locate(solid, at);
    _fmpz_vec_clear(at, 4);
    return state;
}

static void check_set(const cells *c, int number, size_t *met) {
    static surface s;
    map m;
    fmpq *p = _fmpq_vec_init(3), *x = _fmpq_vec_init(3);
    s.facets = s.indices = s.vertices = 0;
    memset(s.number, -1, sizeof s.number);
    if (c->d == 3)
        put_squares(&s, c, number / 3 % 2);
    else
        put_rings(&s, c);
    map_init(&m, c->d, number % 3);
    graze_solid *solid = make_solid(&s, &m);
    for (int k = 0; k < POINTS; k++) {
        draw_point(p, c->d);
        map_point(x, &m, p);
        graze_state want = expected_state(c, p), got = locate(solid, x, c->d);
        if (got != want)
            fail_msg("dimension %d, set %d, point %d: state %d, expected %d", c->d, number, k, got,
                     want);
        met[want == GRAZE_STATE_I ? 0 : want == GRAZE_STATE_B ? 1 : 2]++;
    }
    graze_solid_destroy(solid);
    map_clear(&m);
    _fmpq_vec_clear(p, 3);
    _fmpq_vec_clear(x, 3);
}

static void check_sets(int d) {
    cells c;
    size_t met[3] = {0, 0, 0};
    random_start(20260722);
    for (int number = 0; number < SETS; number++) {
        draw_cells(&c, d, number < 60 ? number / 6 : number); /* each known form under each map */
        check_set(&c, number, met);
    }
    for (int k = 0; k < 3; k++) /* all three states are met often, or the points prove little */
        assert_true(met[k] > SETS * POINTS / 20);
}

static void sets_in_the_plane(void **state) {
    (void)state;
    check_sets(2);
}

static void sets_in_space(void **state) {
    (void)state;
    check_sets(3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sets_in_the_plane),
        cmocka_unit_test(sets_in_space),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
