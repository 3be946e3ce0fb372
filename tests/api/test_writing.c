/* Tests of graze_motion_write_ and graze_boundary_: wrong use, and what a caller in C gets.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "../lib/harness.h"
#include "graze.h"

static const char shift[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [\"0\", \"1\"],"
                            " \"transform\": {\"translate\": [\"4*t\", \"0\", \"0\"]}}]}";

typedef struct numbers {
    mpq_t axis[3], degrees, tolerance, radius;
} numbers;

static void numbers_init(numbers *n) {
    mpq_inits(n->axis[0], n->axis[1], n->axis[2], n->degrees, n->tolerance, n->radius, NULL);
    mpq_set_si(n->axis[2], 1, 1);
    mpq_set_si(n->degrees, 90, 1);
    mpq_set_si(n->tolerance, 1, 1000);
    mpq_set_si(n->radius, 1, 1);
}

static void numbers_clear(numbers *n) {
    mpq_clears(n->axis[0], n->axis[1], n->axis[2], n->degrees, n->tolerance, n->radius, NULL);
}

/* A quarter turn is written, can be read, and needs no report; wrong use leaves NULL behind. */
static void test_motions(void **state) {
    (void)state;
    numbers n;
    char *json = (char *)shift, *report = (char *)shift;
    graze_context *context;
    graze_motion *motion;
    numbers_init(&n);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    graze_joint turn = {GRAZE_JOINT_TURN, n.degrees, NULL, n.axis, NULL};
    graze_joint bare = {GRAZE_JOINT_TURN, NULL, NULL, n.axis, NULL};
    graze_joint slide = {GRAZE_JOINT_SLIDE, NULL, NULL, NULL, NULL};
    assert_int_equal(
        graze_motion_write_rotation(&json, NULL, context, 3, &turn, n.tolerance, n.radius),
        GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, context, json, strlen(json)), GRAZE_OK);
    graze_motion_destroy(motion);
    graze_free(json);
    const graze_joint *wrong[] = {NULL, &bare, &slide};
    for (int k = 0; k < 3; k++) {
        json = report = (char *)shift;
        assert_int_equal(graze_motion_write_rotation(&json, &report, context, 3, wrong[k],
                                                     n.tolerance, n.radius),
                         GRAZE_EUSE);
        assert_null(json);
        assert_null(report);
        assert_int_equal(graze_motion_write_joints(&json, &report, context, 3, wrong[k], 1,
                                                   n.tolerance, n.radius),
                         GRAZE_EUSE);
    }
    assert_int_equal(
        graze_motion_write_joints(&json, &report, context, 3, &turn, 0, n.tolerance, n.radius),
        GRAZE_EUSE);
    assert_int_equal(
        graze_motion_write_joints(&json, &report, context, 4, &turn, 1, n.tolerance, n.radius),
        GRAZE_EUSE);
    mpz_set_si(mpq_denref(n.degrees), -1);
    assert_int_equal(
        graze_motion_write_joints(&json, &report, context, 3, &turn, 1, n.tolerance, n.radius),
        GRAZE_EUSE);
    mpz_set_si(mpq_denref(n.degrees), 1);
    assert_int_equal(graze_motion_write_poses(&json, &report, context, NULL, n.tolerance, 0),
                     GRAZE_EUSE);
    assert_int_equal(graze_motion_write_poses(&json, &report, context, "/nowhere", n.tolerance, 0),
                     GRAZE_ESYSTEM);
    assert_null(json);
    graze_context_destroy(context);
    numbers_clear(&n);
}

/* The plain pieces of a motion, which is destroyed. */
static char *text_of(graze_context *context, graze_motion *motion) {
    char *text = NULL;
    assert_int_equal(graze_motion_text(&text, context, motion), GRAZE_OK);
    graze_motion_destroy(motion);
    return text;
}

/* Poses in memory are those of a log: doubles of one printed with 17 digits, texts of one as it is
 * written; pieces have the log's lines, or the numbers of poses. */
static void test_poses(void **state) {
    (void)state;
    static const double at[] = {0,    0.1,    -1e-300, 3, 1,   0, 0, 0, 0.25, 7.7, 1.0 / 3, 3,
                                0.96, -0.375, 0,       0, 1.5, 8, 9, 3, 0.5,  0.5, 0.5,     0.5};
    const char *texts[24];
    char words[24][40], line[1200] = "t,x,y,z,qw,qx,qy,qz", names[20];
    memcpy(names, line, sizeof names);
    for (int k = 0; k < 24; k++) {
        snprintf(words[k], sizeof words[k], "%.17g", at[k]);
        texts[k] = words[k];
        strcat(strcat(line, k % 8 ? "," : "\n"), words[k]);
    }
    graze_context *context;
    graze_motion *motion;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (int written = 0; written < 2; written++)
        for (unsigned flags = 0; flags <= GRAZE_POSES_NUMBERED; flags += GRAZE_POSES_NUMBERED) {
            char *json, *report, *again;
            graze_pose_rows rows = {.size = sizeof rows, .names = names, .count = 3};
            graze_pose_options how = {
                .size = sizeof how, .flags = flags, .text = line, .length = strlen(line)};
            rows.texts = written ? texts : NULL;
            rows.doubles = written ? NULL : at;
            assert_int_equal(graze_context_set_rounding(context, written ? GRAZE_ROUND_NONE
                                                                         : GRAZE_ROUND_BINARY64),
                             GRAZE_OK);
            assert_int_equal(graze_motion_from_poses(&motion, &report, context, &rows, &how),
                             GRAZE_OK);
            assert_non_null(strstr(report, "poses: 3, each one"));
            graze_free(report);
            char *text = text_of(context, motion);
            assert_non_null(strstr(text, flags ? "\"row\": 3" : "\"row\": 4"));
            assert_int_equal(graze_motion_write_pose_list(&json, NULL, context, "poses", &how),
                             GRAZE_OK);
            assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_NONE), GRAZE_OK);
            assert_int_equal(graze_motion_from_json(&motion, context, json, strlen(json)),
                             GRAZE_OK);
            again = text_of(context, motion);
            assert_string_equal(text, again);
            graze_free(json);
            graze_free(text);
            graze_free(again);
        }
    graze_context_destroy(context);
}

/* Poses that are refused: which one, and why; nothing is handed out. */
static void test_wrong_poses(void **state) {
    (void)state;
    static const double same[6] = {0}, infinite[] = {0, 0, 0, 1, 1, INFINITY};
    static const char *const two[] = {"0", "0", "0", "1", "1", "1,2"}, *const none[] = {"0", "0",
                                                                                        "0", "1",
                                                                                        "1", NULL};
    const struct {
        graze_pose_rows rows;
        const char *says;
    } wrong[] = {
        {{.names = "x,y,z", .count = 2, .doubles = infinite}, "pose 1: "},
        {{.names = "x,y,w", .count = 2, .doubles = same}, "poses:1: "},
        {{.names = "x,y,z", .count = 2, .texts = two}, "pose 1 has a text that is no number"},
        {{.names = "x,y,z", .count = 2, .texts = none}, "pose 1 has a text that is no"},
        {{.names = "x,y,z", .count = 1, .doubles = same}, "expected at least 2"}};
    graze_context *context;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (int k = 0; k < 5; k++) {
        graze_motion *motion = (graze_motion *)context;
        char *report = (char *)shift;
        graze_pose_rows rows = wrong[k].rows;
        rows.size = sizeof rows;
        assert_int_equal(graze_motion_from_poses(&motion, &report, context, &rows, NULL),
                         GRAZE_EINPUT);
        assert_non_null(strstr(graze_context_message(context), wrong[k].says));
        assert_null(motion);
        assert_null(report);
    }
    graze_context_destroy(context);
}

static int stop(void *data) {
    return ++*(int *)data > 3;
}

static graze_status solid_of(graze_solid **out, graze_context *context) {
    static const double corner[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0,
                                    0, 0, 2, 2, 0, 2, 0, 2, 2, 2, 2, 2};
    static const size_t sizes[] = {4, 4, 4, 4, 4, 4};
    static const size_t cycles[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                    2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    return graze_solid_from_doubles(out, context, 3, corner, 8, sizes, 6, cycles, 0);
}

/* Each vertex lies between its two points: graze_classify finds one of them out and the other not.
 * They are 2^-20 of a cell apart at most. */
static void check_vertices(graze_context *context, const graze_scene *scene,
                           const graze_boundary *b, size_t count, double cell) {
    mpq_t at[9];
    for (int k = 0; k < 9; k++)
        mpq_init(at[k]);
    for (size_t v = 0; v < count; v++) {
        graze_verdict verdict[3];
        graze_boundary_vertex(at, b, v);
        graze_boundary_vertex_between(at + 3, at + 6, b, v);
        assert_int_equal(graze_classify(verdict, context, scene, at, 3, GRAZE_COLUMNS_ALL),
                         GRAZE_OK);
        assert_int_equal(verdict[1].pmc, GRAZE_OUT);
        assert_int_not_equal(verdict[2].pmc, GRAZE_OUT);
        for (int k = 0; k < 3; k++) {
            int from = mpq_cmp(at[k], at[3 + k]), to = mpq_cmp(at[6 + k], at[k]);
            assert_true(from * to >= 0);
            mpq_sub(at[3 + k], at[3 + k], at[6 + k]);
            assert_true(fabs(mpq_get_d(at[3 + k])) <= 0x1p-20 * cell);
        }
    }
    graze_boundary_vertex_between(at, at + 3, b, count);
    graze_boundary_vertex_between(NULL, at + 3, b, 0);
    graze_boundary_vertex_between(at, NULL, b, 0);
    graze_boundary_vertex_between(at, at + 3, NULL, 0);
    for (int k = 0; k < 9; k++)
        mpq_clear(at[k]);
}

/* NULL, depths, half a box and a cancel are told apart; getters answer past the end. */
static void test_boundary(void **state) {
    (void)state;
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    graze_boundary *b = NULL;
    int calls = 0;
    mpq_t point[3];
    graze_boundary_options how = {.size = sizeof how, .coarse = 1, .depth = 3, .budget = 100000};
    for (int k = 0; k < 3; k++)
        mpq_init(point[k]);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(solid_of(&solid, context), GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, context, shift, strlen(shift)), GRAZE_OK);
    assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
    assert_int_equal(graze_boundary_create(&b, context, scene, NULL), GRAZE_EUSE);
    how.coarse = 4;
    assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_EUSE);
    how.coarse = 1;
    how.low = point;
    assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_EUSE);
    how.low = NULL;
    how.depth = 20;
    assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_EUSE);
    how.depth = 3;
    graze_context_set_cancel(context, stop, &calls);
    assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_ECANCELED);
    assert_null(b);
    graze_context_set_cancel(context, NULL, NULL);
    assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_OK);
    graze_boundary_summary s = graze_boundary_summarize(b);
    assert_true(s.complete && s.closed && s.level == 3 && s.faces > 0 && s.vertices > 0);
    check_vertices(context, scene, b, s.vertices, 27. / 32); /* the box is 27/4 long, cut into 8 */
    assert_int_equal(s.in + s.on + s.out, s.points);
    assert_int_equal(graze_boundary_point(point, b, s.points), GRAZE_PMC_NONE);
    assert_int_not_equal(graze_boundary_point(point, b, s.points - 1), GRAZE_PMC_NONE);
    assert_null(graze_boundary_face(b, s.faces));
    assert_int_equal(graze_boundary_cell_at(b, s.cells).level, 0);
    assert_int_equal(graze_boundary_summarize(NULL).points, 0);
    graze_boundary_destroy(b);
    graze_boundary_destroy(NULL);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    for (int k = 0; k < 3; k++)
        mpq_clear(point[k]);
    graze_thread_finish();
}

/* Two boundaries have the same vertices, faces and counts. */
static void check_same(const graze_boundary *a, const graze_boundary *b) {
    graze_boundary_summary s = graze_boundary_summarize(a), t = graze_boundary_summarize(b);
    mpq_t at[6];
    for (int k = 0; k < 6; k++)
        mpq_init(at[k]);
    assert_memory_equal(&s, &t, sizeof s);
    for (size_t v = 0; v < s.vertices; v++) {
        graze_boundary_vertex(at, a, v);
        graze_boundary_vertex(at + 3, b, v);
        for (int k = 0; k < 3; k++)
            assert_true(mpq_equal(at[k], at[3 + k]));
    }
    for (size_t f = 0; f < s.faces; f++)
        assert_memory_equal(graze_boundary_face(a, f), graze_boundary_face(b, f),
                            3 * sizeof(size_t));
    for (int k = 0; k < 6; k++)
        mpq_clear(at[k]);
}

/* Vertices at edges and corners of sweeps, straight and turning ones, are between two such points
 * too. Six threads place them as one does. */
static void test_sharp(void **state) {
    (void)state;
    static const char turn[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [\"0\", \"1\"], "
                               "\"transform\": {\"compose\": [{\"rotate\": {\"axis\": [\"0\", "
                               "\"0\", \"1\"], \"center\": [\"0\", \"0\", \"0\"], "
                               "\"tan_half\": \"s\"}}, {\"translate\": [\"t\", \"0\", "
                               "\"t/3\"]}]}}]}";
    const char *const motions[] = {shift, turn};
    graze_context *context;
    graze_solid *solid;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(solid_of(&solid, context), GRAZE_OK);
    for (int k = 0; k < 2; k++) {
        graze_motion *motion;
        graze_scene *scene;
        graze_boundary *b = NULL;
        graze_boundary_options how = {
            .coarse = 3, .depth = 3, .budget = 100000, .sharp = 1, .size = sizeof how};
        assert_int_equal(graze_motion_from_json(&motion, context, motions[k], strlen(motions[k])),
                         GRAZE_OK);
        assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
        how.middles = 1;
        assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_EUSE);
        how.middles = 0;
        assert_int_equal(graze_boundary_create(&b, context, scene, &how), GRAZE_OK);
        graze_boundary_summary s = graze_boundary_summarize(b);
        assert_true(s.closed && s.features >= 8 && s.features < s.vertices);
        graze_boundary *again = NULL;
        how.threads = 1025;
        assert_int_equal(graze_boundary_create(&again, context, scene, &how), GRAZE_EUSE);
        how.threads = 6;
        assert_int_equal(graze_boundary_create(&again, context, scene, &how), GRAZE_OK);
        check_same(b, again);
        graze_boundary_destroy(again);
        check_vertices(context, scene, b, s.vertices, 27. / 32); /* no box is longer than 27/4 */
        graze_boundary_destroy(b);
        graze_scene_destroy(scene);
        graze_motion_destroy(motion);
    }
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    graze_thread_finish();
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_motions), cmocka_unit_test(test_poses),
                                       cmocka_unit_test(test_wrong_poses),
                                       cmocka_unit_test(test_boundary),
                                       cmocka_unit_test(test_sharp)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
