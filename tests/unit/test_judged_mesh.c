/* Meshes without assumptions (questions/judge/judge.h): what they lack, their volume, and
 * their winding numbers, for shapes whose values are evident.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _DEFAULT_SOURCE /* mkstemps */
#include <unistd.h>
#include <flint/fmpq_vec.h>
#include "input/read/read.h"
#include "input/soup/soup.h"
#include "input/validate/validate.h"
#include "questions/judge/judge.h"
#include "fixture.h"

enum { MOST_VERTICES = 64, MOST_FACETS = 128 };

/* A mesh as tests write it: vertices, and facets of up to 5 of them. */
typedef struct shape {
    size_t vertices, facets;
    fmpq at[MOST_VERTICES][3];
    size_t facet[MOST_FACETS][5], size[MOST_FACETS];
} shape;

static shape *shape_new(void) {
    shape *s = calloc(1, sizeof *s);
    assert_non_null(s);
    for (size_t v = 0; v < MOST_VERTICES; v++)
        for (int i = 0; i < 3; i++)
            fmpq_init(&s->at[v][i]);
    return s;
}

static void shape_free(shape *s) {
    for (size_t v = 0; v < MOST_VERTICES; v++)
        for (int i = 0; i < 3; i++)
            fmpq_clear(&s->at[v][i]);
    free(s);
}

static size_t add_vertex(shape *s, slong x, slong y, slong z) {
    slong at[3] = {x, y, z};
    for (int i = 0; i < 3; i++)
        fmpq_set_si(&s->at[s->vertices][i], at[i], 1);
    return s->vertices++;
}

static void add_triangle(shape *s, size_t a, size_t b, size_t c) {
    memcpy(s->facet[s->facets], (size_t[5]){a, b, c, 0, 0}, sizeof s->facet[0]);
    s->size[s->facets++] = 3;
}

static void add_quad(shape *s, size_t a, size_t b, size_t c, size_t d) {
    memcpy(s->facet[s->facets], (size_t[5]){a, b, c, d, 0}, sizeof s->facet[0]);
    s->size[s->facets++] = 4;
}

/* The cube [low, low + side]^3, outward: vertex k of it has bit i of k for its coordinate i. */
static size_t add_cube(shape *s, slong low, slong side, int quads) {
    static const size_t face[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    size_t first = s->vertices;
    for (int k = 0; k < 8; k++)
        add_vertex(s, low + side * (k & 1), low + side * (k >> 1 & 1), low + side * (k >> 2));
    for (int f = 0; f < 6; f++) {
        size_t v[4];
        for (int k = 0; k < 4; k++)
            v[k] = first + face[f][k];
        if (quads) {
            add_quad(s, v[0], v[1], v[2], v[3]);
        } else {
            add_triangle(s, v[0], v[1], v[2]);
            add_triangle(s, v[0], v[2], v[3]);
        }
    }
    return first;
}

static void turn_facet(shape *s, size_t facet) {
    size_t swap = s->facet[facet][0];
    s->facet[facet][0] = s->facet[facet][2];
    s->facet[facet][2] = swap;
}

/* A mesh with the soup that it borrows. */
typedef struct made {
    soup input;
    judged_mesh mesh;
    graze_status status;
} made;

static void make(made *m, const shape *s, unsigned flags) {
    soup_init(&m->input, 3);
    for (size_t v = 0; v < s->vertices; v++)
        assert_int_equal(soup_add_vertex(&m->input, context, s->at[v]), GRAZE_OK);
    for (size_t f = 0; f < s->facets; f++) {
        assert_int_equal(soup_add_facet(&m->input, context), GRAZE_OK);
        assert_int_equal(soup_add_cycle(&m->input, context, s->facet[f], s->size[f]), GRAZE_OK);
    }
    m->status = judged_mesh_make(&m->mesh, context, &m->input, flags);
}

static void clear(made *m) {
    judged_mesh_clear(&m->mesh);
    soup_clear(&m->input);
}

/* Make a mesh and check its rule, and how many edges are odd and open. */
static void expect(made *m, const shape *s, graze_mesh_rule rule, size_t odd, size_t unbalanced) {
    make(m, s, 0);
    assert_int_equal(m->status, GRAZE_OK);
    assert_int_equal(m->mesh.rule, rule);
    assert_int_equal(m->mesh.open.odd_count, odd);
    assert_int_equal(m->mesh.open.unbalanced_count, unbalanced);
}

static void expect_volume(const made *m, const char *want) {
    fmpq_t volume;
    fmpq_init(volume);
    set_rational(volume, want);
    assert_true(fmpq_equal(volume, m->mesh.volume));
    fmpq_clear(volume);
}

/* A cube of triangles, of quads, of triangles that name vertices of their own: 8 of volume. */
static void cubes(void **state) {
    (void)state;
    for (int quads = 0; quads < 2; quads++) {
        made m;
        shape *s = shape_new();
        add_cube(s, -1, 2, quads);
        expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
        assert_int_equal(m.mesh.cut.count, 12);
        assert_int_equal(m.mesh.cut.component_count, 1);
        expect_volume(&m, "8");
        clear(&m);
        shape_free(s);
    }
    made m;
    shape *s = shape_new(), *apart = shape_new();
    add_cube(s, -1, 2, 0);
    for (size_t f = 0; f < s->facets; f++)
        for (int k = 0; k < 3; k++) {
            fmpq *to = apart->at[apart->vertices];
            for (int i = 0; i < 3; i++)
                fmpq_set(to + i, &s->at[s->facet[f][k]][i]);
            apart->facet[f][k] = apart->vertices++;
            apart->size[f] = 3;
            apart->facets = f + 1;
        }
    expect(&m, apart, GRAZE_MESH_WINDING, 0, 0);
    assert_int_equal(m.mesh.cut.component_count, 1);
    expect_volume(&m, "8");
    clear(&m);
    shape_free(apart);
    shape_free(s);
}

/* A cube without one triangle has three odd edges, those of the triangle; a turned one makes them
 * even, run through twice one way; a vertex that no facet has changes nothing. */
static void cubes_with_faults(void **state) {
    (void)state;
    made m;
    shape *s = shape_new();
    add_cube(s, -1, 2, 0);
    add_vertex(s, 9, 9, 9);
    turn_facet(s, 11);
    expect(&m, s, GRAZE_MESH_PARITY, 0, 3);
    assert_int_equal(m.mesh.open.kept_count, 3);
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(m.mesh.open.kept[k].forward, 2);
        assert_int_equal(m.mesh.open.kept[k].backward, 0);
    }
    clear(&m);
    s->facets--; /* the last is vertices 4, 7, 6 of the cube */
    expect(&m, s, GRAZE_MESH_NONE, 3, 3);
    assert_int_equal(m.mesh.open.kept_count, 3);
    const uint32_t want[3][2] = {{4, 6}, {7, 4}, {6, 7}}; /* as the neighbours run */
    for (size_t k = 0; k < 3; k++) {
        const loose_edge *e = &m.mesh.open.kept[k];
        assert_int_equal(e->from, want[k][0]);
        assert_int_equal(e->to, want[k][1]);
        assert_int_equal(e->forward, 1);
        assert_int_equal(e->backward, 0);
    }
    clear(&m);
    shape_free(s);
}

/* Check a point, written `x y z`; the winding number is 0 unless the rule is of winding numbers. */
static void expect_place(const made *m, const char *point, mesh_place want, long winding) {
    fmpq *at = _fmpq_vec_init(3);
    char text[200], *rest = text;
    long found;
    snprintf(text, sizeof text, "%s", point);
    for (int i = 0; i < 3; i++)
        set_rational(at + i, strtok_r(i ? NULL : text, " ", &rest));
    mesh_place place = judged_place(&found, &m->mesh, at);
    if (place != want || found != winding)
        print_message("%s: place %d, winding number %ld\n", point, (int)place, found);
    assert_int_equal(place, want);
    assert_int_equal(found, winding);
    _fmpq_vec_clear(at, 3);
}

/* Points of the cube [-1, 1]^3 by their coordinates: one of size 1 and none larger is on it. The
 * rays of those beside faces, edges, vertices and diagonals meet them. */
static void places_by_a_cube(void **state) {
    (void)state;
    static const char *const on[] = {"1 0 0",   "-1 1/3 1/7", "0 0 1",   "0 1 0",     "1 1 0",
                                     "-1 -1 0", "1 1 1",      "-1 1 -1", "1/3 1/3 -1"};
    static const char *const in[] = {"0 0 0", "0 1/2 1/2", "-999999/1000000 0 0",
                                     "1e-400 -1e-400 1e-400", "1/3 999/1000 -999/1000"};
    static const char *const out[] = {"-2 0 0",    "-2 1 1",  "-2 1 0",
                                      "-2 -1 -1",  "-2 -1 1", "-3 0 1",
                                      "2 0 0",     "-5 2 2",  "0 0 1.0000000000000000000001",
                                      "0 -1e300 0"};
    made m;
    shape *s = shape_new();
    add_cube(s, -1, 2, 0);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    for (size_t k = 0; k < sizeof on / sizeof *on; k++)
        expect_place(&m, on[k], MESH_ON, 0);
    for (size_t k = 0; k < sizeof in / sizeof *in; k++)
        expect_place(&m, in[k], MESH_IN, 1);
    for (size_t k = 0; k < sizeof out / sizeof *out; k++)
        expect_place(&m, out[k], MESH_OUT, 0);
    clear(&m);
    for (size_t f = 0; f < s->facets; f++)
        turn_facet(s, f);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    expect_volume(&m, "-8");
    expect_place(&m, "0 0 0", MESH_IN, -1);
    expect_place(&m, "-2 0 0", MESH_OUT, 0);
    clear(&m);
    turn_facet(s, 0);
    turn_facet(s, 7); /* four edges that no other turned one has, and two diagonals */
    expect(&m, s, GRAZE_MESH_PARITY, 0, 6);
    assert_true(fmpq_is_zero(m.mesh.volume));
    expect_place(&m, "0 0 0", MESH_IN, 0);
    expect_place(&m, "-2 0 0", MESH_OUT, 0);
    expect_place(&m, "-1 0 0", MESH_ON, 0);
    clear(&m);
    shape_free(s);
}

/* Cubes upon one another. Twice the same: 2 inside. [0,2]^3 and [1,3]^3: 2 in [1,2]^3, of volume
 * 8 + 8 all the same; a point of one's face is on the mesh even inside the other. [0,4]^3 and
 * [1,2]^3 turned round: a cavity, 64 - 1. */
static void several_cubes(void **state) {
    (void)state;
    made m;
    shape *s = shape_new();
    add_cube(s, 0, 2, 0);
    add_cube(s, 0, 2, 0);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    assert_int_equal(m.mesh.cut.component_count, 1);
    expect_volume(&m, "16");
    expect_place(&m, "1 1 1", MESH_IN, 2);
    expect_place(&m, "0 1 1", MESH_ON, 0);
    clear(&m);
    s->vertices = s->facets = 0;
    add_cube(s, 0, 2, 0);
    add_cube(s, 1, 2, 1);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    assert_int_equal(m.mesh.cut.component_count, 2);
    expect_volume(&m, "16");
    expect_place(&m, "3/2 3/2 3/2", MESH_IN, 2);
    expect_place(&m, "1/2 1/2 1/2", MESH_IN, 1);
    expect_place(&m, "5/2 5/2 5/2", MESH_IN, 1);
    expect_place(&m, "2 3/2 3/2", MESH_ON, 0);
    expect_place(&m, "1/2 5/2 1", MESH_OUT, 0);
    clear(&m);
    s->vertices = s->facets = 0;
    add_cube(s, 0, 4, 0);
    add_cube(s, 1, 1, 0);
    for (size_t f = 12; f < 24; f++)
        turn_facet(s, f);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    expect_volume(&m, "63");
    expect_place(&m, "3/2 3/2 3/2", MESH_OUT, 0);
    expect_place(&m, "3 3 3", MESH_IN, 1);
    clear(&m);
    shape_free(s);
}

/* A band of 2 n triangles around the z axis, `twisted` by half a turn or not, as quads i, i + 1 of
 * a polygon: vertex 2 i at its foot, 2 i + 1 above. */
static shape *twisted_band(int twisted) {
    static const slong ring[6][2] = {{4, 0}, {2, 3}, {-2, 3}, {-4, 0}, {-2, -3}, {2, -3}};
    shape *s = shape_new();
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 2; k++)
            add_vertex(s, ring[i][0], ring[i][1], k);
    for (size_t i = 0; i < 6; i++) {
        int last = i == 5 && twisted;
        size_t a = 2 * i, b = a + 1, c = 2 * ((i + 1) % 6) + (size_t)last,
               d = c + 1 - 2 * (size_t)last;
        add_triangle(s, a, c, d);
        add_triangle(s, a, d, b);
    }
    return s;
}

/* Bands have rims: 6 edges above and 6 below, and a Moebius strip runs twice one way through the
 * edge at which its facets meet turned round besides. Off it there is no membership. */
static void bands(void **state) {
    (void)state;
    for (int twisted = 0; twisted < 2; twisted++) {
        made m;
        shape *s = twisted_band(twisted);
        expect(&m, s, GRAZE_MESH_NONE, 12, 12 + (size_t)twisted);
        assert_int_equal(m.mesh.open.kept_count, LOOSE_EDGES_KEPT);
        for (size_t k = 0; k < LOOSE_EDGES_KEPT; k++) { /* odd ones alone, though 0-1 is not */
            assert_int_equal(m.mesh.open.kept[k].forward, 1);
            assert_int_equal(m.mesh.open.kept[k].backward, 0);
        }
        assert_int_equal(m.mesh.cut.component_count, 1);
        expect_place(&m, "0 0 1/2", MESH_UNTOLD, 0);
        expect_place(&m, "0 3 1/2", MESH_ON, 0);
        expect_place(&m, "4 0 0", MESH_ON, 0);
        clear(&m);
        shape_free(s);
    }
}

/* A closed surface without two sides: a grid of n x n vertices on which rows close turned round (a
 * Klein bottle), at places that no two share. All edges have two triangles; those across which it
 * is turned do not cancel, n of them. Far points are out, by parity. */
static void klein_bottle(void **state) {
    (void)state;
    enum { N = 5 };
    made m;
    shape *s = shape_new();
    for (slong i = 0; i < N; i++)
        for (slong j = 0; j < N; j++)
            add_vertex(s, i * i - 3 * j, 7 * j + i, (i * 5 + j * j * 3) % 11);
    for (size_t i = 0; i < N; i++)
        for (size_t j = 0; j < N; j++) {
            /* the last column meets the first with the rows in the opposite order */
            size_t next = (i + 1) % N, up = (j + 1) % N;
            size_t here = i + 1 < N ? j : (N - j) % N, above = i + 1 < N ? up : (N - up) % N;
            size_t a = i * N + j, b = next * N + here, c = next * N + above, d = i * N + up;
            add_triangle(s, a, b, c);
            add_triangle(s, a, c, d);
        }
    expect(&m, s, GRAZE_MESH_PARITY, 0, N);
    assert_int_equal(m.mesh.cut.component_count, 1);
    assert_int_equal(m.mesh.cut.count + m.mesh.flat_count, 2 * N * N);
    assert_int_equal(m.mesh.open.kept_count, N);
    for (size_t k = 0; k < N; k++)
        assert_int_equal(m.mesh.open.kept[k].forward, 2);
    expect_place(&m, "-1000 1 1", MESH_OUT, 0);
    expect_place(&m, "1000 1/3 1/7", MESH_OUT, 0);
    clear(&m);
    shape_free(s);
}

/* A file without facets is a mesh, and no solid. */
static void empty_file(void **state) {
    (void)state;
    char path[] = "/tmp/graze-test-mesh-XXXXXX.off";
    soup input;
    judged_mesh mesh;
    int file = mkstemps(path, 4);
    assert_true(file >= 0 && write(file, "OFF\n1 0 0\n0 0 0\n", 16) == 16 && close(file) == 0);
    assert_int_equal(soup_read(&input, context, path), GRAZE_EILLEGAL);
    assert_int_equal(soup_read_any(&input, context, path), GRAZE_OK);
    assert_int_equal(judged_mesh_make(&mesh, context, &input, 0), GRAZE_OK);
    assert_int_equal(mesh.rule, GRAZE_MESH_WINDING);
    judged_mesh_clear(&mesh);
    soup_clear(&input);
    unlink(path);
}

/* No facet at all: it closes, is of volume 0, and has everything outside. */
static void empty(void **state) {
    (void)state;
    made m;
    shape *s = shape_new();
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    expect_volume(&m, "0");
    expect_place(&m, "0 0 0", MESH_OUT, 0);
    clear(&m);
    add_vertex(s, 0, 0, 0);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    expect_place(&m, "0 0 0", MESH_OUT, 0);
    clear(&m);
    shape_free(s);
}

/* Edges that lie on one another without being one edge. A tetrahedron one of whose facets is cut at
 * the middle of an edge that the facet beyond keeps whole closes all the same, and so it does with
 * a facet without area there instead, which is left out; without the cut's second half three edges
 * stay open, named by the parts of the edge. `way` is 1 or, for the mirror image, -1. */
static void tetrahedron_with_a_cut_edge(slong way) {
    made m;
    shape *s = shape_new();
    for (int k = 0; k < 4; k++)
        add_vertex(s, k == 1 ? 2 * way : 0, k == 2 ? 2 : 0, k == 3 ? 2 : 0);
    add_vertex(s, way, 0, 0); /* the middle of 0-1 */
    add_triangle(s, 0, 1, 3);
    add_triangle(s, 1, 2, 3);
    add_triangle(s, 2, 0, 3);
    add_triangle(s, 2, 1, 4);
    add_triangle(s, 2, 4, 0);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    expect_volume(&m, way > 0 ? "4/3" : "-4/3");
    expect_place(&m, way > 0 ? "1/4 1/4 1/4" : "-1/4 1/4 1/4", MESH_IN, way);
    expect_place(&m, "-3 0 0", MESH_OUT, 0);
    clear(&m);
    add_triangle(s, 0, 4, 1);
    add_triangle(s, 3, 3, 3);
    expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
    assert_int_equal(m.mesh.flat_count, 2);
    assert_int_equal(m.mesh.cut.count, 5);
    clear(&m);
    s->facets = 4;
    expect(&m, s, GRAZE_MESH_NONE, 3, 3);
    const uint32_t want[3][2] = {{2, 0}, {0, 4}, {4, 2}};
    for (size_t k = 0; k < 3; k++) {
        const loose_edge *e = &m.mesh.open.kept[k];
        assert_int_equal(e->from, want[k][0]);
        assert_int_equal(e->to, want[k][1]);
        assert_int_equal(e->forward, 1);
        assert_int_equal(e->backward, 0);
    }
    clear(&m);
    shape_free(s);
}

static void edges_on_edges(void **state) {
    (void)state;
    for (slong way = -1; way <= 1; way += 2)
        tetrahedron_with_a_cut_edge(way);
}

/* Sizes at which doubles fail: a cube of side 2 10^400 and one of 2 10^-400, at thirds, and one
 * that is 10^-30 of its distance from 0. */
static void sizes(void **state) {
    (void)state;
    static const char *const scale[] = {"1e400", "1e-400", "1/3"}, *const offset[] = {"0", "0",
                                                                                      "1e30"};
    for (int k = 0; k < 3; k++) {
        made m;
        fmpq_t by, to, volume;
        fmpq *at = _fmpq_vec_init(3);
        shape *s = shape_new();
        fmpq_init(by);
        fmpq_init(to);
        fmpq_init(volume);
        set_rational(by, scale[k]);
        set_rational(to, offset[k]);
        add_cube(s, -1, 2, 1);
        for (size_t v = 0; v < 8; v++)
            for (int i = 0; i < 3; i++) {
                fmpq_mul(&s->at[v][i], &s->at[v][i], by);
                fmpq_add(&s->at[v][i], &s->at[v][i], to);
            }
        expect(&m, s, GRAZE_MESH_WINDING, 0, 0);
        fmpq_pow_si(volume, by, 3);
        fmpq_mul_ui(volume, volume, 8);
        assert_true(fmpq_equal(volume, m.mesh.volume));
        for (int n = 0; n < 5; n++) { /* 0, 3/4, 1, 5/4 and -2 of half a side along an axis each */
            static const slong quarter[] = {0, 3, 4, 5, -8};
            static const mesh_place want[] = {MESH_IN, MESH_IN, MESH_ON, MESH_OUT, MESH_OUT};
            long winding;
            for (int i = 0; i < 3; i++)
                fmpq_set(at + i, to);
            fmpq_set_si(volume, quarter[n], 4);
            fmpq_addmul(at + n % 3, volume, by);
            assert_int_equal(judged_place(&winding, &m.mesh, at), want[n]);
            assert_int_equal(winding, want[n] == MESH_IN);
        }
        fmpq_clear(by);
        fmpq_clear(to);
        fmpq_clear(volume);
        _fmpq_vec_clear(at, 3);
        clear(&m);
        shape_free(s);
    }
}

/* A cube one of whose vertices is moved off three faces: they are named; as fans it is a mesh, of
 * its volume and a tetrahedron more or less at each of the three, by which diagonal the fan has. */
static void facets_off_planes(void **state) {
    (void)state;
    made m;
    shape *s = shape_new();
    add_cube(s, 0, 1, 1);
    for (int i = 0; i < 3; i++)
        fmpq_set_si(&s->at[7][i], 2, 1);
    make(&m, s, 0);
    assert_int_equal(m.status, GRAZE_EILLEGAL);
    assert_non_null(strstr(graze_context_message(context), "facet 1 is not planar"));
    assert_non_null(strstr(graze_context_message(context), "3 such facets in all: 1, 3, 5"));
    clear(&m);
    make(&m, s, GRAZE_SOLID_TRIANGULATE);
    assert_int_equal(m.status, GRAZE_OK);
    assert_int_equal(m.mesh.rule, GRAZE_MESH_WINDING);
    /* Each of the three fans has its diagonal 1-7, 2-7 or 4-7: through the moved vertex. The
     * pyramids of vertex 0 over the two triangles of such a face have the volumes |1 0 0; 1 1 0; 2
     * 2 2| / 6 = 1/3 each, and the other three faces hold vertex 0. */
    expect_volume(&m, "2");
    clear(&m);
    /* The fan of 0, 1, 2, 3, 4, where 0, 1 and 2 are on a line: one triangle has no area. */
    static const slong at[5][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 0}};
    s->facets = s->vertices = 0;
    for (int v = 0; v < 5; v++)
        add_vertex(s, at[v][0], at[v][1], at[v][2]);
    s->size[0] = 5;
    for (size_t k = 0; k < 5; k++)
        s->facet[0][k] = k;
    s->facets = 1;
    make(&m, s, GRAZE_SOLID_TRIANGULATE);
    assert_int_equal(m.status, GRAZE_OK);
    assert_int_equal(m.mesh.flat_count, 1);
    assert_int_equal(m.mesh.cut.count, 2);
    assert_int_equal(m.mesh.open.odd_count, 4);
    clear(&m);
    shape_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(cubes),
                                       cmocka_unit_test(cubes_with_faults),
                                       cmocka_unit_test(places_by_a_cube),
                                       cmocka_unit_test(several_cubes),
                                       cmocka_unit_test(bands),
                                       cmocka_unit_test(klein_bottle),
                                       cmocka_unit_test(empty),
                                       cmocka_unit_test(empty_file),
                                       cmocka_unit_test(edges_on_edges),
                                       cmocka_unit_test(sizes),
                                       cmocka_unit_test(facets_off_planes)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
