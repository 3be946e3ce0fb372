/* Meshes of which nothing is assumed (questions/judge/judged_mesh.h): what they lack, their volume,
 * and their winding numbers, of shapes of which all is evident.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fixture.h"
#include <flint/fmpq_vec.h>
#include "questions/judge/judged_mesh.h"

enum { MOST_VERTICES = 64, MOST_FACETS = 128 };

/* A mesh as tests write it: vertices, and facets of up to 4 of them. */
typedef struct shape {
    size_t vertices, facets;
    fmpq at[MOST_VERTICES][3];
    size_t facet[MOST_FACETS][4], size[MOST_FACETS];
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
    memcpy(s->facet[s->facets], (size_t[4]){a, b, c, 0}, sizeof s->facet[0]);
    s->size[s->facets++] = 3;
}

static void add_quad(shape *s, size_t a, size_t b, size_t c, size_t d) {
    memcpy(s->facet[s->facets], (size_t[4]){a, b, c, d}, sizeof s->facet[0]);
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
static void expect(made *m, const shape *s, mesh_rule rule, size_t odd, size_t unbalanced) {
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
        expect(&m, s, MESH_RULE_WINDING, 0, 0);
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
    expect(&m, apart, MESH_RULE_WINDING, 0, 0);
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
    expect(&m, s, MESH_RULE_PARITY, 0, 3);
    assert_int_equal(m.mesh.open.kept_count, 3);
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(m.mesh.open.kept[k].forward, 2);
        assert_int_equal(m.mesh.open.kept[k].backward, 0);
    }
    clear(&m);
    s->facets--; /* the last is vertices 4, 7, 6 of the cube */
    expect(&m, s, MESH_RULE_NONE, 3, 3);
    assert_int_equal(m.mesh.open.kept_count, 3);
    const uint32_t want[3][2] = {{6, 4}, {4, 7}, {7, 6}}; /* as the neighbours run */
    for (size_t k = 0; k < 3; k++) {
        const loose_edge *e = &m.mesh.open.kept[k];
        int found = 0;
        for (int j = 0; j < 3; j++)
            found += (e->from == want[j][1] && e->to == want[j][0]) ||
                     (e->from == want[j][0] && e->to == want[j][1]);
        assert_int_equal(found, 1);
        assert_int_equal(e->forward, 1);
        assert_int_equal(e->backward, 0);
    }
    clear(&m);
    shape_free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(cubes),
                                       cmocka_unit_test(cubes_with_faults)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
