/* Memberships of boxes against the sweep of the cube [0,2]^3 by (8t, 0, 0), which is the box
 * [0,10] x [0,2]^2 (output/compare/compare.h): counts by hand, and laws on points of all strata.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include "../lib/failing.h"
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/soup/soup.h"
#include "output/compare/compare.h"
#include "output/compare/counts.h"
#include "questions/generate/generate.h"
#include "questions/judge/judge.h"
#include "fixture.h"
#include "graze.h"

enum { GENERATED = 1000 };

static graze_solid *block;
static graze_motion *slide;
static graze_scene *scene;

static const size_t quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

static int set_up_scene(void **state) {
    static const char motion[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                                 "{\"translate\": [\"8*t\", 0, 0]}}]}";
    static const size_t sizes[] = {4, 4, 4, 4, 4, 4};
    double at[24];
    for (int k = 0; k < 24; k++)
        at[k] = 2 * (k / 3 >> k % 3 & 1);
    return set_up(state) ||
           graze_solid_from_doubles(&block, context, 3, at, 8, sizes, 6, quads[0], 0) != GRAZE_OK ||
           graze_motion_from_json(&slide, context, motion, strlen(motion)) != GRAZE_OK ||
           graze_scene_create(&scene, context, block, slide, NULL) != GRAZE_OK;
}

static int tear_down_scene(void **state) {
    graze_scene_destroy(scene);
    graze_motion_destroy(slide);
    graze_solid_destroy(block);
    return tear_down(state);
}

/* The box [from, to] x [low, high]^2 without its last facets, some of them turned round. */
typedef struct box_mesh {
    soup input;
    judged_mesh mesh;
} box_mesh;

static void make_box(box_mesh *b, const slong corner[4], size_t facets, size_t turned) {
    soup_init(&b->input, 3);
    fmpq *at = _fmpq_vec_init(3);
    for (int v = 0; v < 8; v++) {
        fmpq_set_si(at, corner[v & 1], 1);
        fmpq_set_si(at + 1, corner[2 + (v >> 1 & 1)], 1);
        fmpq_set_si(at + 2, corner[2 + (v >> 2)], 1);
        assert_int_equal(soup_add_vertex(&b->input, context, at), GRAZE_OK);
    }
    _fmpq_vec_clear(at, 3);
    for (size_t f = 0; f < facets; f++) {
        size_t v[4];
        for (int k = 0; k < 4; k++)
            v[k] = quads[f][f < turned ? 3 - k : k];
        assert_int_equal(soup_add_facet(&b->input, context), GRAZE_OK);
        assert_int_equal(soup_add_cycle(&b->input, context, v, 4), GRAZE_OK);
    }
    assert_int_equal(judged_mesh_make(&b->mesh, context, &b->input, 0), GRAZE_OK);
}

static void clear_box(box_mesh *b) {
    judged_mesh_clear(&b->mesh);
    soup_clear(&b->input);
}

static graze_comparison *compare_mesh(const box_mesh *b, const mesh_points *points, int threads,
                                      const graze_compare_options *options) {
    graze_comparison *c = calloc(1, sizeof *c);
    assert_non_null(c);
    assert_int_equal(comparison_of_mesh(c, context, scene, &b->mesh, points, threads, options),
                     GRAZE_OK);
    assert_int_equal(c->rows, c->agree + c->wrong + c->undecided);
    return c;
}

/* The box [0,4] x [0,2]^2 at five points. (5,1,1) is in, and out of it: wrong whatever `on` is.
 * (4,1,1) is in, and on it: apart, or wrong where `on` is an answer or the same as out. (0,1,1) is
 * on both. (5,3,1) is out of both. (7,2,1) is on, and out of it: wrong where `on` is an answer or
 * the same as in. */
static void five_points(void **state) {
    (void)state;
    static const slong corner[4] = {0, 4, 0, 2},
                       place[5][3] = {{5, 1, 1}, {4, 1, 1}, {0, 1, 1}, {5, 3, 1}, {7, 2, 1}};
    static const unsigned long matrix[3][4] = {{0, 1, 1, 0}, {0, 1, 1, 0}, {0, 0, 1, 0}};
    static const unsigned long wrong[CONVENTIONS] = {3, 1, 2, 2};
    fmpq *at = _fmpq_vec_init(15);
    for (int k = 0; k < 15; k++)
        fmpq_set_si(at + k, place[k / 3][k % 3], 1);
    mesh_points points = {.point = at, .count = 5, .explain_options = " --triangulate"};
    box_mesh b;
    make_box(&b, corner, 6, 0);
    for (int k = 0; k < CONVENTIONS; k++) {
        graze_compare_options options = {.size = sizeof options,
                                         .on_as = (graze_on_as)k,
                                         .show = 9,
                                         .solid = "a.off",
                                         .motion = "m.json",
                                         .scene = scene};
        graze_comparison *c = compare_mesh(&b, &points, 1, &options);
        assert_memory_equal(c->confusion.pmc, matrix, sizeof matrix);
        assert_memory_equal(c->wrong_as, wrong, sizeof wrong);
        assert_int_equal(c->wrong, wrong[k]);
        assert_int_equal(c->undecided, k == GRAZE_ON_AS_ANY);
        assert_int_equal(c->apart, k == GRAZE_ON_AS_ANY);
        assert_int_equal(c->golden_on, 2);
        assert_int_equal(c->shown, wrong[k]);
        assert_int_equal(c->tallies[BY_STRATUM].count, 0);
        assert_string_equal(c->disagreements[0].point, "5 1 1");
        /* (5,1,1) lies 1 deep: the cube at t = 1/2 is [4,6] x [0,2]^2. */
        assert_non_null(strstr(c->disagreements[0].golden, "pmc=in sdf_low=-1"));
        assert_string_equal(c->disagreements[0].candidate, "pmc=out winding=0");
        assert_string_equal(c->disagreements[0].golden_row, "0,5,1,1,in");
        assert_string_equal(c->disagreements[0].candidate_row, "0,5,1,1,out,0");
        assert_int_equal(c->depth.wrong, wrong[k]);
        graze_comparison_destroy(c);
    }
    clear_box(&b);
    _fmpq_vec_clear(at, 15);
}

/* Both forms of the report, with what a mesh alone has in them. */
static void reports(void **state) {
    (void)state;
    static const slong corner[4] = {0, 4, 0, 2};
    fmpq *at = _fmpq_vec_init(6);
    for (int k = 0; k < 6; k++)
        fmpq_set_si(at + k, k == 0 ? 5 : k == 3 ? 4 : 1, 1);
    mesh_points points = {.point = at, .count = 2, .explain_options = " --triangulate"};
    graze_compare_options options = {.size = sizeof options,
                                     .on_as = GRAZE_ON_AS_ANY,
                                     .show = 9,
                                     .solid = "a.off",
                                     .motion = "m.json"};
    box_mesh b;
    char *report;
    make_box(&b, corner, 6, 2); /* two opposite facets turned round: parity */
    assert_int_equal(b.mesh.rule, GRAZE_MESH_PARITY);
    graze_comparison *c = compare_mesh(&b, &points, 1, &options);
    assert_int_equal(graze_comparison_report(&report, context, c, GRAZE_COMPARISON_TEXT), GRAZE_OK);
    assert_non_null(strstr(report, "on the mesh: 1 points whose golden answer is `in` or `out`"));
    assert_non_null(strstr(report, "`graze explain a.off m.json 5 1 1 --triangulate`"));
    assert_non_null(strstr(report, "    id,x,y,z,pmc\n    0,5,1,1,out\n"));
    graze_free(report);
    assert_int_equal(graze_comparison_report(&report, context, c, GRAZE_COMPARISON_JSON), GRAZE_OK);
    assert_non_null(strstr(report, "\"on-the-mesh\": 1"));
    graze_free(report);
    graze_comparison_destroy(c);
    clear_box(&b);
    _fmpq_vec_clear(at, 6);
}

static void expect_same(const graze_comparison *a, const graze_comparison *b) {
    assert_int_equal(a->wrong, b->wrong);
    assert_memory_equal(&a->confusion, &b->confusion, sizeof a->confusion);
    assert_memory_equal(a->wrong_as, b->wrong_as, sizeof a->wrong_as);
    assert_int_equal(a->tallies[BY_STRATUM].count, b->tallies[BY_STRATUM].count);
    for (size_t k = 0; k < a->tallies[BY_STRATUM].count; k++)
        assert_int_equal(a->tallies[BY_STRATUM].groups[k].wrong,
                         b->tallies[BY_STRATUM].groups[k].wrong);
    assert_int_equal(a->shown, b->shown);
    for (size_t k = 0; k < a->shown; k++)
        assert_string_equal(a->disagreements[k].golden_row, b->disagreements[k].golden_row);
}

/* The exact boundary errs nowhere under any convention: it could err at points inside that lie on
 * it alone, and has none; with two facets turned round parity says the same. A box that is too
 * large has `out` points inside, and no `in` point out; an empty mesh has each `in` point out. Two
 * threads say what one does. */
static void generated(void **state) {
    (void)state;
    static const slong exact[4] = {0, 10, 0, 2}, large[4] = {-2, 12, -2, 4};
    graze_generator *generator;
    assert_int_equal(graze_generator_create(&generator, context, scene, 1, NULL, 0), GRAZE_OK);
    mesh_points points = {.generator = generator, .count = GENERATED};
    graze_compare_options options = {.size = sizeof options, .on_as = GRAZE_ON_AS_ANY, .show = 3};
    unsigned long in = 0;
    for (size_t turned = 0; turned < 4; turned += 2) {
        box_mesh b;
        make_box(&b, exact, 6, turned);
        graze_comparison *c = compare_mesh(&b, &points, 1, &options);
        in = c->confusion.pmc[PMC_IN][PMC_IN];
        for (int k = 0; k < CONVENTIONS; k++)
            assert_int_equal(c->wrong_as[k], 0);
        assert_int_equal(c->agree, GENERATED);
        assert_true(in > GENERATED / 10 && c->confusion.pmc[PMC_ON][PMC_ON] > GENERATED / 10 &&
                    c->confusion.pmc[PMC_OUT][PMC_OUT] > GENERATED / 100);
        assert_true(c->tallies[BY_STRATUM].count > 5);
        graze_comparison_destroy(c);
        clear_box(&b);
    }
    box_mesh b;
    make_box(&b, large, 6, 0);
    graze_comparison *c = compare_mesh(&b, &points, 1, &options),
                     *d = compare_mesh(&b, &points, 2, &options);
    expect_same(c, d);
    assert_true(c->wrong > 0);
    assert_int_equal(c->wrong, c->confusion.pmc[PMC_OUT][PMC_IN]);
    assert_int_equal(c->confusion.pmc[PMC_IN][PMC_OUT], 0);
    assert_int_equal(c->shown, c->wrong < 3 ? c->wrong : 3);
    graze_comparison_destroy(c);
    graze_comparison_destroy(d);
    clear_box(&b);
    make_box(&b, exact, 0, 0);
    c = compare_mesh(&b, &points, 1, &options);
    assert_int_equal(c->wrong, in);
    assert_int_equal(c->confusion.pmc[PMC_IN][PMC_OUT], in);
    graze_comparison_destroy(c);
    clear_box(&b);
    graze_generator_destroy(generator);
}

/* A mesh, and its comparison with wrong rows that are measured; what is left until an allocation
 * fails counts down within. */
static graze_status whole(const graze_generator *generator, long fail_at) {
    static const slong corner[4] = {0, 4, 0, 2};
    mesh_points points = {.generator = generator, .count = 20};
    graze_compare_options options = {
        .size = sizeof options, .on_as = GRAZE_ON_AS_ANY, .show = 2, .scene = scene};
    box_mesh b;
    judged_mesh again;
    make_box(&b, corner, 6, 0);
    graze_comparison *c = calloc(1, sizeof *c);
    assert_non_null(c);
    left = fail_at;
    graze_status status = judged_mesh_make(&again, context, &b.input, 0);
    if (!status)
        status = comparison_of_mesh(c, context, scene, &again, &points, 1, &options);
    int failed = left < 0 && fail_at >= 0;
    left = -1;
    judged_mesh_clear(&again);
    graze_comparison_destroy(c);
    clear_box(&b);
    /* A filter that finds no memory may leave a point to the exact path. */
    assert_true(status == GRAZE_OK || (failed && status == GRAZE_ESYSTEM));
    return status;
}

/* Each allocation fails once, and all that is said is that memory ran out. */
static void faults(void **state) {
    (void)state;
    graze_generator *generator;
    assert_int_equal(graze_generator_create(&generator, context, scene, 1, NULL, 0), GRAZE_OK);
    long said = 0;
    assert_int_equal(whole(generator, -1), GRAZE_OK);
    for (long k = 0; k < 400 && !SANITIZED; k++)
        said += whole(generator, k) == GRAZE_ESYSTEM;
    assert_true(SANITIZED || said > 100);
    graze_generator_destroy(generator);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(five_points), cmocka_unit_test(reports),
                                       cmocka_unit_test(generated), cmocka_unit_test(faults)};
    return cmocka_run_group_tests(tests, set_up_scene, tear_down_scene);
}
