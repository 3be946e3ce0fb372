/* Winding numbers of random meshes that cross themselves (questions/judge/judge.h), at points of
 * a coarse grid; many of them lie on the mesh or have rays that meet edges and vertices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The second method knows no ray and no tree. The winding number at x of a mesh that closes is the
 * sum, over its triangles, of the sign of the tetrahedron that the triangle makes with an apex
 * where x is inside that (proofs/mesh.md C115, whose 0 may be any point); of a mesh of even edges
 * the parity of their number. The apex is drawn again where x lies on a facet of a tetrahedron. x
 * is on a triangle if it is in its plane and, seen from a point off that plane, inside the three
 * planes through it and the sides.
 */
#include "../lib/random.h"
#include "input/soup/soup.h"
#include "questions/judge/cube.h"
#include "questions/judge/judge.h"
#include "fixture.h"

/* A grid of vertices that closes as a torus, and as a Klein bottle; places are whole numbers. */
enum {
    SIDE = 4,
    VERTICES = SIDE * SIDE,
    TRIANGLES = 2 * VERTICES,
    ROUNDS = 60,
    POINTS = 60,
    SPAN = 7
};

typedef struct sample_mesh {
    slong at[VERTICES][3];
    size_t triangle[TRIANGLES][3];
    soup input;
    judged_mesh mesh;
} sample_mesh;

/* The triangles of the grid; with `turned` the last column meets the first upside down. */
static void connect(sample_mesh *s, int turned) {
    size_t count = 0;
    for (size_t i = 0; i < SIDE; i++)
        for (size_t j = 0; j < SIDE; j++) {
            int flip = turned && i + 1 == SIDE;
            size_t next = (i + 1) % SIDE, up = (j + 1) % SIDE;
            size_t here = flip ? (SIDE - j) % SIDE : j, above = flip ? (SIDE - up) % SIDE : up;
            size_t a = i * SIDE + j, b = next * SIDE + here, c = next * SIDE + above;
            memcpy(s->triangle[count++], (size_t[3]){a, b, c}, sizeof *s->triangle);
            memcpy(s->triangle[count++], (size_t[3]){a, c, i * SIDE + up}, sizeof *s->triangle);
        }
}

static void make_sample(sample_mesh *s, int turned) {
    fmpq_t place[3];
    connect(s, turned);
    soup_init(&s->input, 3);
    for (int i = 0; i < 3; i++)
        fmpq_init(place[i]);
    for (size_t v = 0; v < VERTICES; v++) {
        for (int i = 0; i < 3; i++) {
            s->at[v][i] = 2 * draw_below(SPAN);
            fmpq_set_si(place[i], s->at[v][i], 2);
        }
        assert_int_equal(soup_add_vertex(&s->input, context, *place), GRAZE_OK);
    }
    for (size_t t = 0; t < TRIANGLES; t++) {
        assert_int_equal(soup_add_facet(&s->input, context), GRAZE_OK);
        assert_int_equal(soup_add_cycle(&s->input, context, s->triangle[t], 3), GRAZE_OK);
    }
    for (int i = 0; i < 3; i++)
        fmpq_clear(place[i]);
    assert_int_equal(judged_mesh_make(&s->mesh, context, &s->input, 0), GRAZE_OK);
}

/* The sign of det(b - a, c - a, d - a); all numbers are small. */
static int side_of(const slong *a, const slong *b, const slong *c, const slong *d) {
    slong m[3][3];
    const slong *row[3] = {b, c, d};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            m[k][i] = row[k][i] - a[i];
    slong value = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                  m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                  m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return (value > 0) - (value < 0);
}

/* Is x on this triangle, which no line holds? */
static int is_on(const slong *a, const slong *b, const slong *c, const slong *x) {
    slong off[3];
    if (side_of(a, b, c, x) != 0)
        return 0;
    for (int i = 0; i < 3; i++) { /* the point before a in one direction of the normal */
        int j = (i + 1) % 3, k = (i + 2) % 3;
        off[i] = a[i] + (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    }
    int s = side_of(off, a, b, x), t = side_of(off, b, c, x), u = side_of(off, c, a, x);
    return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

/* Has the triangle no area? */
static int is_flat(const slong *a, const slong *b, const slong *c) {
    int zero = 1;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        zero = zero && (b[i] - a[i]) * (c[j] - a[j]) == (b[j] - a[j]) * (c[i] - a[i]);
    }
    return zero;
}

/* Add a tetrahedron's sign to the sum if x is inside; 0 if x is on a facet of it. */
static int add_tetrahedron(long *sum, const slong *o, const slong *a, const slong *b,
                           const slong *c, const slong *x) {
    int whole = side_of(o, a, b, c);
    int s[4] = {side_of(x, a, b, c), side_of(o, x, b, c), side_of(o, a, x, c), side_of(o, a, b, x)};
    if (whole == 0)
        return 0;
    int inside = 1;
    for (int k = 0; k < 4; k++) {
        if (s[k] == -whole)
            return 1;
        inside = inside && s[k] == whole;
    }
    if (!inside)
        return 0;
    *sum += whole;
    return 1;
}

/* The place and the sum at a point off the mesh, by tetrahedra. */
static mesh_place expected_place(long *sum, const sample_mesh *s, const slong *x) {
    int general = 0;
    for (size_t t = 0; t < TRIANGLES; t++) {
        const slong *a = s->at[s->triangle[t][0]], *b = s->at[s->triangle[t][1]],
                    *c = s->at[s->triangle[t][2]];
        if (!is_flat(a, b, c) && is_on(a, b, c, x))
            return MESH_ON;
    }
    while (!general) {
        slong o[3];
        for (int i = 0; i < 3; i++)
            o[i] = random_about(10000);
        general = 1;
        *sum = 0;
        for (size_t t = 0; t < TRIANGLES && general; t++) {
            const slong *a = s->at[s->triangle[t][0]], *b = s->at[s->triangle[t][1]],
                        *c = s->at[s->triangle[t][2]];
            general = is_flat(a, b, c) || add_tetrahedron(sum, o, a, b, c, x);
        }
    }
    int inside = s->mesh.rule == GRAZE_MESH_WINDING ? *sum != 0 : *sum % 2 != 0;
    return inside ? MESH_IN : MESH_OUT;
}

/* Compare at the middle of two vertices or beside it; all coordinates are doubled here. */
static mesh_place check_point(const sample_mesh *s) {
    slong x[3];
    size_t u = (size_t)draw_below(VERTICES), v = (size_t)draw_below(VERTICES);
    int aside = draw_below(3) != 0;
    long sum = 0, found;
    fmpq_t place[3];
    for (int i = 0; i < 3; i++) {
        x[i] = (s->at[u][i] + s->at[v][i]) / 2 + (aside ? random_about(1) : 0);
        fmpq_init(place[i]);
        fmpq_set_si(place[i], x[i], 2);
    }
    mesh_place want = expected_place(&sum, s, x), got = judged_place(&found, &s->mesh, *place);
    int counted = s->mesh.rule == GRAZE_MESH_WINDING && want != MESH_ON;
    if (got != want || found != (counted ? sum : 0))
        print_message("at %ld %ld %ld halves: place %d, not %d; winding number %ld, not %ld\n",
                      (long)x[0], (long)x[1], (long)x[2], (int)got, (int)want, found, sum);
    assert_int_equal(got, want);
    assert_int_equal(found, counted ? sum : 0);
    for (int i = 0; i < 3; i++)
        fmpq_clear(place[i]);
    return got;
}

/* Planes of a cube that holds all of the mesh are too many for cells: it is of the band. */
static void check_flat(const sample_mesh *s) {
    cube all = {.centre = {3, 3, 3}, .half = 4, .kind = CUBE_FLAT};
    assert_int_equal(flat_child(&all, context, &s->mesh), GRAZE_OK);
    assert_int_equal(all.kind, CUBE_BAND);
    assert_false(all.beside);
}

static void random_meshes(graze_mesh_rule rule) {
    size_t met[3] = {0, 0, 0};
    for (int round = 0; round < ROUNDS; round++) {
        sample_mesh s;
        make_sample(&s, rule == GRAZE_MESH_PARITY);
        /* Edges cancel by chance where vertices do, on lines that several edges share. */
        assert_true(s.mesh.rule >= rule);
        for (int n = 0; n < POINTS; n++)
            met[check_point(&s)]++;
        check_flat(&s);
        judged_mesh_clear(&s.mesh);
        soup_clear(&s.input);
    }
    for (int k = 0; k < 3; k++)
        assert_true(met[k] > ROUNDS * POINTS / 20);
}

static void tori(void **state) {
    (void)state;
    random_start(20260728);
    random_meshes(GRAZE_MESH_WINDING);
}

static void klein_bottles(void **state) {
    (void)state;
    random_start(20260729);
    random_meshes(GRAZE_MESH_PARITY);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tori), cmocka_unit_test(klein_bottles)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
