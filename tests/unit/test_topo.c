/* Leading directions against curves, in the plane: two methods that share only traces (topo.h), on
 * generated points of every pair of the examples' solids and motions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "questions/topo/near.h"
#include "questions/topo/topo.h"
#include "fixture.h"
#include "graze.h"

enum { POINTS = 25 };

static const char *const solids[] = {"q2", "dd", "ll", "rg", "tt", "bl", "bar", "diamond_block"};
static const char *const motions[] = {
    "seam",    "seam_ends", "diagonal_up", "bent_diagonal",    "notch",  "apex_28",
    "apex_29", "apex_30",   "pivot_2",     "pivot_3",          "rotate", "rotate_and_slide",
    "quartic", "cubic",     "parabola",    "leave_and_return", "shrink", "dive"};

typedef struct tally {
    int on, leading, interior;
} tally;

/* An `on` point by both levels. */
static void compare_levels(tally *t, const graze_scene *scene, const fmpq *p, const char *name) {
    const plane_list *planes;
    topo_finding by_leading, by_curves;
    finding_init(&by_leading);
    finding_init(&by_curves);
    assert_int_equal(topo_planes(&planes, context, scene), GRAZE_OK);
    assert_int_equal(leading_decide(&by_leading, context, scene, planes, p), GRAZE_OK);
    assert_int_equal(topo_by_curves(&by_curves, context, scene, p), GRAZE_OK);
    t->on++;
    assert_int_not_equal(by_curves.position, GRAZE_TOPO_UNDECIDED);
    t->interior += by_curves.position == GRAZE_TOPO_INTERIOR;
    if (by_leading.position != GRAZE_TOPO_UNDECIDED) {
        t->leading++;
        if (by_leading.position != by_curves.position) {
            flint_printf("%s: ", name);
            _fmpq_vec_print(p, 2);
            fail_msg(" is %s by leading directions and %s by curves",
                     graze_topo_name(by_leading.position), graze_topo_name(by_curves.position));
        }
    }
    finding_clear(&by_leading);
    finding_clear(&by_curves);
}

static void compare_on_points(tally *t, const graze_scene *scene, const char *name) {
    graze_generator *made = NULL;
    graze_sample how;
    mpq_t point[2], time;
    fmpq *p = _fmpq_vec_init(2);
    mpq_inits(point[0], point[1], time, NULL);
    assert_int_equal(graze_generator_create(&made, context, scene, 12, NULL, 0), GRAZE_OK);
    for (unsigned long long row = 0; row < POINTS; row++) {
        graze_verdict verdict;
        assert_int_equal(graze_generator_point(point, time, &how, context, made, row), GRAZE_OK);
        for (int k = 0; k < 2; k++)
            fmpq_set_mpq(p + k, point[k]);
        assert_int_equal(classify_verdict(&verdict, context, scene, (query_point){.rational = p}),
                         GRAZE_OK);
        if (verdict.pmc == GRAZE_ON)
            compare_levels(t, scene, p, name);
    }
    mpq_clears(point[0], point[1], time, NULL);
    _fmpq_vec_clear(p, 2);
    graze_generator_destroy(made);
}

static void levels_agree(void **state) {
    (void)state;
    tally t = {0, 0, 0};
    for (size_t i = 0; i < sizeof solids / sizeof *solids; i++)
        for (size_t j = 0; j < sizeof motions / sizeof *motions; j++) {
            char solid_path[80], motion_path[80], name[80];
            graze_solid *solid = NULL;
            graze_motion *motion = NULL;
            graze_scene *scene = NULL;
            snprintf(solid_path, sizeof solid_path, "tests/examples/solids/%s.wkt", solids[i]);
            snprintf(motion_path, sizeof motion_path, "tests/examples/motions/%s.json", motions[j]);
            snprintf(name, sizeof name, "%s %s", solids[i], motions[j]);
            assert_int_equal(graze_solid_read(&solid, context, solid_path, 0), GRAZE_OK);
            assert_int_equal(graze_motion_read(&motion, context, motion_path), GRAZE_OK);
            assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
            compare_on_points(&t, scene, name);
            graze_scene_destroy(scene);
            graze_motion_destroy(motion);
            graze_solid_destroy(solid);
        }
    printf("%d on points, %d by leading directions, %d interior\n", t.on, t.leading, t.interior);
    assert_true(t.on > 500);
    assert_true(t.leading > t.on / 2);
    assert_true(t.interior > 10);
}

/* The top edge of a square slides along the point, and a side stood 2^-100 beside it at t0. */
static void limit(void **state) {
    (void)state;
    graze_solid *solid = NULL;
    graze_motion *motion = NULL;
    graze_scene *scene = NULL;
    topo_finding found;
    fmpq *p = _fmpq_vec_init(2);
    assert_int_equal(graze_solid_read(&solid, context, "tests/examples/solids/q2.wkt", 0),
                     GRAZE_OK);
    assert_int_equal(graze_motion_read(&motion, context, "tests/examples/motions/right8.json"),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
    fmpq_one(p);
    fmpq_div_2exp(p, p, 100);
    fmpq_add_si(p, p, 2);
    fmpq_set_si(p + 1, 2, 1);
    finding_init(&found);
    assert_int_equal(topo_by_curves(&found, context, scene, p), GRAZE_OK);
    assert_int_equal(found.position, GRAZE_TOPO_BOUNDARY);
    finding_clear(&found);
    finding_init(&found);
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_BITS, 50), GRAZE_OK);
    assert_int_equal(topo_by_curves(&found, context, scene, p), GRAZE_OK);
    assert_int_equal(found.position, GRAZE_TOPO_UNDECIDED);
    assert_non_null(strstr(found.reason, "`bits`"));
    finding_clear(&found);
    _fmpq_vec_clear(p, 2);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
}

/* A square's right side, x = 1, comes to the origin at t = 0, with speed 0, and goes back, by a
 * motion of degree 21: its curves are made only where the limit allows it. */
static void degree(void **state) {
    (void)state;
    static const char motion_text[] =
        "{\"dimension\": 2, \"pieces\": [{\"t\": [-1, 1], \"transform\": {\"translate\": "
        "[\"-1-t^21-t^2\", \"t\"]}}]}";
    graze_solid *solid = NULL;
    graze_motion *motion = NULL;
    graze_scene *scene = NULL;
    topo_finding found;
    fmpq *p = _fmpq_vec_init(2);
    const double corner[] = {0, -1, 1, -1, 1, 1, 0, 1};
    const size_t sizes[] = {4}, ring[] = {0, 1, 2, 3};
    assert_int_equal(graze_solid_from_doubles(&solid, context, 2, corner, 4, sizes, 1, ring, 0),
                     GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, context, motion_text, sizeof motion_text - 1),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
    finding_init(&found);
    assert_int_equal(topo_by_curves(&found, context, scene, p), GRAZE_OK);
    assert_int_equal(found.position, GRAZE_TOPO_UNDECIDED);
    assert_non_null(strstr(found.reason, "the limit `curve`"));
    finding_clear(&found);
    finding_init(&found);
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_CURVE, 21), GRAZE_OK);
    assert_int_equal(topo_by_curves(&found, context, scene, p), GRAZE_OK);
    assert_int_equal(found.position, GRAZE_TOPO_BOUNDARY);
    finding_clear(&found);
    _fmpq_vec_clear(p, 2);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(limit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(degree, set_up, tear_down),
        cmocka_unit_test_setup_teardown(levels_agree, set_up, tear_down)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
