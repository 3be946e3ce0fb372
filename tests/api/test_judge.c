/* Meshes that are judged, through the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The cube [0, 2]^3 along x by 8 sweeps [0, 10] x [0, 2]^2. The box that ends at x = 9 has the
 * middle of that face 1 inside; the corners of x = 10 are 1 from it (C119).
 */
#include "../lib/harness.h"

#include <string.h>
#include "graze.h"

static const size_t FACES[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

static const char MOTION[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [\"0\", \"1\"], "
                             "\"transform\": {\"translate\": [\"8*t\", \"0\", \"0\"]}}]}";

typedef struct judged {
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    graze_mesh *mesh;
} judged;

/* A box from 0 to (end, 2, 2). */
static void box_vertices(double out[24], double end) {
    for (int k = 0; k < 8; k++) {
        out[3 * k] = k & 1 ? end : 0;
        out[3 * k + 1] = k & 2 ? 2 : 0;
        out[3 * k + 2] = k & 4 ? 2 : 0;
    }
}

static graze_scene *make_scene(judged *j, graze_operation operation) {
    graze_options o = {.size = sizeof o, .operation = operation};
    graze_scene *scene = NULL;
    assert_int_equal(graze_scene_create(&scene, j->context, j->solid, j->motion, &o), GRAZE_OK);
    return scene;
}

static void begin(judged *j, size_t triangles) {
    double box[24];
    size_t sizes[12];
    memset(j, 0, sizeof *j);
    assert_int_equal(graze_context_create(&j->context), GRAZE_OK);
    box_vertices(box, 2);
    for (int k = 0; k < 12; k++)
        sizes[k] = 3;
    assert_int_equal(
        graze_solid_from_doubles(&j->solid, j->context, 3, box, 8, sizes, 12, FACES, 0), GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&j->motion, j->context, MOTION, strlen(MOTION)),
                     GRAZE_OK);
    j->scene = make_scene(j, GRAZE_SWEEP);
    box_vertices(box, 9);
    assert_int_equal(graze_mesh_create(&j->mesh, j->context, box, 8, FACES, triangles), GRAZE_OK);
}

static void end(judged *j) {
    graze_mesh_destroy(j->mesh);
    graze_scene_destroy(j->scene);
    graze_motion_destroy(j->motion);
    graze_solid_destroy(j->solid);
    graze_context_destroy(j->context);
}

static void holds(const graze_judgement *j, graze_judged which, double truth) {
    graze_judged_distance d = graze_judgement_distance(j, which);
    assert_true(d.low <= truth && truth <= d.high && d.high - d.low <= 0.5 && d.reached);
}

/* A page is refused before anything is written. */
static void refuse_page(const judged *j, const graze_judgement *found, const graze_enclosure *at) {
    char title[600];
    memset(title, 'a', sizeof title - 1);
    title[sizeof title - 1] = '\0';
    assert_int_equal(graze_judgement_draw(j->context, NULL, found, "p.html", at, NULL), GRAZE_EUSE);
    assert_int_equal(graze_judgement_draw(j->context, j->scene, found, NULL, at, NULL), GRAZE_EUSE);
    assert_int_equal(graze_judgement_draw(j->context, j->scene, found, "p.svg", at, NULL),
                     GRAZE_EUSE);
    assert_int_equal(graze_judgement_draw(j->context, j->scene, found, "p.html", NULL, NULL),
                     GRAZE_EUSE);
    assert_int_equal(graze_judgement_draw(j->context, j->scene, found, "p.html", at, title),
                     GRAZE_EUSE);
    assert_int_equal(graze_judgement_draw(j->context, j->scene, found, "no/p.html", at, "a"),
                     GRAZE_ESYSTEM);
}

static void test_box(void **state) {
    (void)state;
    judged j;
    graze_judgement *found = NULL;
    graze_judge_options o = {.size = sizeof o, .within = 0.5};
    graze_enclosure at[8];
    size_t corner[3] = {9, 9, 9};
    mpq_t low, high, point[3];
    begin(&j, 12);
    mpq_inits(low, high, point[0], point[1], point[2], NULL);
    assert_int_equal(graze_judge(&found, j.context, j.scene, j.mesh, &o), GRAZE_OK);
    holds(found, GRAZE_JUDGED_OUTSIDE, 0);
    holds(found, GRAZE_JUDGED_INSIDE, 1);
    holds(found, GRAZE_JUDGED_SWEEP, 1);
    graze_judgement_volume(low, high, found);
    assert_true(mpq_cmp_ui(low, 40, 1) <= 0 && mpq_cmp_ui(high, 40, 1) >= 0);
    /* [9, 10] x [0, 2]^2 is missing */
    assert_true(graze_judgement_difference(low, high, point[0], point[1], found));
    assert_true(mpq_cmp_ui(low, 4, 1) <= 0 && mpq_cmp_ui(high, 4, 1) >= 0);
    assert_true(mpq_sgn(point[0]) == 0 && mpq_sgn(point[1]) >= 0);
    assert_true(graze_judgement_cost(found) > 0);
    assert_true(graze_mesh_volume(low, j.mesh) && mpq_cmp_ui(low, 36, 1) == 0);
    int windings[2] = {7, 7};
    assert_true(graze_mesh_windings(&windings[0], &windings[1], j.mesh));
    assert_true(windings[0] == 0 && windings[1] == 1);
    graze_mesh_triangle(corner, j.mesh, 12);
    assert_int_equal(corner[0], 9);
    graze_mesh_triangle(corner, j.mesh, 1);
    assert_true(corner[0] == 0 && corner[1] == 3 && corner[2] == 1);
    graze_mesh_vertex(point, j.mesh, 1);
    graze_mesh_vertex(point, j.mesh, 8);
    assert_true(mpq_cmp_ui(point[0], 9, 1) == 0 && mpq_sgn(point[1]) == 0);
    assert_int_equal(graze_mesh_distances(at, j.context, j.scene, j.mesh, 1e-3, 2), GRAZE_OK);
    for (int k = 0; k < 8; k++)
        assert_true(at[k].pmc == GRAZE_ON && at[k].low == 0 && at[k].high == 0);
    refuse_page(&j, found, at);
    graze_judgement_destroy(found);
    mpq_clears(low, high, point[0], point[1], point[2], NULL);
    end(&j);
}

/* Answers of the box for three points: x = 5 is in both, x = 19/2 in the sweep alone, x = 11 in
 * none.
 */
static void test_points(void **state) {
    (void)state;
    static const unsigned long numerator[9] = {5, 1, 1, 19, 1, 1, 11, 1, 1};
    judged j;
    mpq_t point[9];
    graze_comparison *c = NULL;
    graze_mesh_points p = {.size = sizeof p, .count = 3, .on_as = GRAZE_ON_AS_ANY};
    begin(&j, 12);
    for (int k = 0; k < 9; k++) {
        mpq_init(point[k]);
        mpq_set_ui(point[k], numerator[k], k == 3 ? 2 : 1);
    }
    p.points = (graze_rationals)point;
    assert_int_equal(graze_compare_mesh(&c, j.context, j.scene, j.mesh, &p), GRAZE_OK);
    graze_comparison_counts n = graze_comparison_count(c);
    assert_true(n.rows == 3 && n.agree == 2 && n.wrong == 1);
    graze_comparison_destroy(c);
    p.count = SIZE_MAX;
    assert_int_equal(graze_compare_mesh(&c, j.context, j.scene, j.mesh, &p), GRAZE_ELIMIT);
    assert_null(c);
    mpq_set_ui(point[3], 9, 1); /* on the end of the box */
    graze_pmc said[3];
    assert_int_equal(graze_mesh_answers(said, j.context, j.mesh, p.points, 3, 2), GRAZE_OK);
    assert_true(said[0] == GRAZE_IN && said[1] == GRAZE_ON && said[2] == GRAZE_OUT);
    for (int k = 0; k < 9; k++)
        mpq_clear(point[k]);
    end(&j);
}

static void test_refused(void **state) {
    (void)state;
    static const size_t beyond[3] = {0, 1, 8};
    static const double vertex[3] = {0, 0, 0};
    judged j;
    graze_judgement *found = NULL;
    graze_comparison *c = NULL;
    graze_mesh *mesh = NULL;
    graze_judge_options o = {.size = sizeof o, .within = 0.5};
    graze_mesh_points p = {.size = sizeof p, .count = 3};
    begin(&j, 11);
    assert_int_equal(graze_mesh_get_facts(j.mesh).rule, GRAZE_MESH_NONE);
    assert_int_equal(graze_mesh_get_facts(j.mesh).odd_edges, 3);
    assert_int_equal(graze_compare_mesh(&c, j.context, j.scene, j.mesh, &p), GRAZE_EINPUT);
    assert_non_null(strstr(graze_context_message(j.context), "the mesh has no inside"));
    graze_scene *unsweep = make_scene(&j, GRAZE_UNSWEEP);
    assert_int_equal(graze_judge(&found, j.context, unsweep, j.mesh, &o), GRAZE_EILLEGAL);
    assert_string_equal(graze_context_message(j.context),
                        "an unsweep; expected a sweep to judge a mesh by");
    graze_scene_destroy(unsweep);
    assert_int_equal(graze_mesh_create(&mesh, j.context, vertex, 1, beyond, 1), GRAZE_EINPUT);
    assert_non_null(strstr(graze_context_message(j.context), "vertex 1 of 1"));
    end(&j);
}

static int stop(void *data) {
    return --*(int *)data < 0;
}

/* Over by 2 between two legs of 8: x = 2 is a seam, which searches stop at. */
static const char LEGS[] =
    "{\"dimension\": 3, \"pieces\": ["
    "{\"t\": [\"0\", \"1\"], \"transform\": {\"translate\": [\"0\", \"8*t\", \"0\"]}}, "
    "{\"t\": [\"1\", \"2\"], \"transform\": {\"translate\": [\"2*t - 2\", \"8\", \"0\"]}}, "
    "{\"t\": [\"2\", \"3\"], \"transform\": {\"translate\": [\"2\", \"24 - 8*t\", \"0\"]}}]}";

/* The solid of a golden case against its own sweep: no vertex is further than the bounds say. */
static void test_bracket(void **state) {
    (void)state;
    judged j = {0};
    graze_judgement *found = NULL;
    graze_judge_options o = {.size = sizeof o, .within = 0.25, .threads = 3};
    graze_enclosure at[80];
    assert_int_equal(graze_context_create(&j.context), GRAZE_OK);
    assert_int_equal(graze_solid_read(&j.solid, j.context, "cases/bracket/solid.off", 0), GRAZE_OK);
    assert_int_equal(graze_motion_read(&j.motion, j.context, "cases/bracket/motion.json"),
                     GRAZE_OK);
    j.scene = make_scene(&j, GRAZE_SWEEP);
    assert_int_equal(graze_mesh_read(&j.mesh, j.context, "cases/bracket/solid.off", 0), GRAZE_OK);
    assert_int_equal(graze_mesh_get_facts(j.mesh).vertices, 80);
    assert_int_equal(graze_judge(&found, j.context, j.scene, j.mesh, &o), GRAZE_OK);
    assert_int_equal(graze_mesh_distances(at, j.context, j.scene, j.mesh, 0.01, 1), GRAZE_OK);
    double outside = graze_judgement_distance(found, GRAZE_JUDGED_OUTSIDE).high;
    double inside = graze_judgement_distance(found, GRAZE_JUDGED_INSIDE).high;
    for (int k = 0; k < 80; k++)
        assert_true(at[k].low <= outside && -at[k].high <= inside);
    graze_judgement_destroy(found);
    end(&j);
}

/* Wherever the caller cancels, the call ends with that and leaves nothing. */
static void test_cancel(void **state) {
    (void)state;
    judged j;
    begin(&j, 12);
    graze_scene_destroy(j.scene);
    graze_motion_destroy(j.motion);
    assert_int_equal(graze_motion_from_json(&j.motion, j.context, LEGS, strlen(LEGS)), GRAZE_OK);
    j.scene = make_scene(&j, GRAZE_SWEEP);
    for (int calls = 1; calls < 20000; calls += 1 + calls / 2) {
        int left = calls;
        graze_judgement *found = NULL;
        graze_judge_options o = {.size = sizeof o, .within = 0.5};
        graze_context_set_cancel(j.context, stop, &left);
        graze_status status = graze_judge(&found, j.context, j.scene, j.mesh, &o);
        graze_judgement_destroy(found);
        if (left >= 0) { /* it has ended before */
            assert_int_equal(status, GRAZE_OK);
            break;
        }
        assert_int_equal(status, GRAZE_ECANCELED);
        assert_null(found);
    }
    end(&j);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_box), cmocka_unit_test(test_points), cmocka_unit_test(test_refused),
        cmocka_unit_test(test_bracket), cmocka_unit_test(test_cancel)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
