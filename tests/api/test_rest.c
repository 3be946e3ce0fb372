/* Solids that do not move through the public functions: points, scenes at rest, their rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The square [0, 2]^2 and the unit disk about the origin: answers are evident.
 */
#include "walk.h"

static const char disk[] = "{\"dimension\": 2, \"solid\": {\"ball\": {\"radius\": 1, \"center\": "
                           "[0, 0]}}}";
enum { POINTS = 4 };
static const long asked[POINTS][4] = {{1, 1, 1, 2}, {2, 1, 1, 1}, {2, 1, 2, 1}, {3, 1, 5, 1}};
static const graze_pmc answers[POINTS] = {GRAZE_IN, GRAZE_ON, GRAZE_ON, GRAZE_OUT};

static void set_points(mpq_t *out) {
    for (int k = 0; k < 2 * POINTS; k++) {
        mpq_init(out[k]);
        mpq_set_si(out[k], asked[k / 2][k % 2 * 2], (unsigned long)asked[k / 2][k % 2 * 2 + 1]);
    }
}

static void clear_points(mpq_t *points) {
    for (int k = 0; k < 2 * POINTS; k++)
        mpq_clear(points[k]);
}

static void points_of_a_square(void **state) {
    (void)state;
    scene s;
    mpq_t points[2 * POINTS];
    double doubles[2 * POINTS];
    graze_pmc pmc[POINTS];
    scene_open(&s, slide, NULL);
    set_points(points);
    for (int k = 0; k < 2 * POINTS; k++)
        doubles[k] = mpq_get_d(points[k]);
    assert_int_equal(graze_solid_classify(pmc, s.context, s.solid, points, POINTS), GRAZE_OK);
    assert_memory_equal(pmc, answers, sizeof pmc);
    memset(pmc, 7, sizeof pmc);
    assert_int_equal(graze_solid_classify_doubles(pmc, s.context, s.solid, doubles, POINTS),
                     GRAZE_OK);
    assert_memory_equal(pmc, answers, sizeof pmc);
    assert_int_equal(graze_solid_classify(NULL, s.context, s.solid, NULL, 0), GRAZE_OK);
    doubles[5] = NAN;
    assert_int_equal(graze_solid_classify_doubles(pmc, s.context, s.solid, doubles, POINTS),
                     GRAZE_EINPUT);
    assert_memory_equal(pmc, answers, 2 * sizeof *pmc);
    assert_int_equal(pmc[2], GRAZE_PMC_NONE);
    assert_int_equal(pmc[3], GRAZE_PMC_NONE);
    assert_int_equal(graze_context_place(s.context).index, 2);
    mpz_set_si(mpq_denref(points[7]), 0);
    assert_int_equal(graze_solid_classify(pmc, s.context, s.solid, points, POINTS), GRAZE_EUSE);
    assert_int_equal(pmc[0], GRAZE_PMC_NONE);
    mpz_set_si(mpq_denref(points[7]), 1);
    clear_points(points);
    scene_close(&s);
}

static void points_of_a_disk(void **state) {
    (void)state;
    static const double doubles[] = {0.6, 0.8, 1, 0, 0.5, -0.5, 0, -1.5};
    graze_context *context;
    graze_solid *solid;
    graze_pmc pmc[4];
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(graze_solid_from_csg(&solid, context, disk, strlen(disk)), GRAZE_OK);
    assert_int_equal(graze_solid_classify_doubles(pmc, context, solid, doubles, 4), GRAZE_OK);
    /* The doubles next to 3/5 and 4/5 are below and above them; their squares add to more than 1.
     */
    assert_int_equal(pmc[0], GRAZE_OUT);
    assert_int_equal(pmc[1], GRAZE_ON);
    assert_int_equal(pmc[2], GRAZE_IN);
    assert_int_equal(pmc[3], GRAZE_OUT);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    graze_thread_finish();
}

/* A scene at rest takes the functions of scenes: distances, traces, boxes. */
static void scenes_at_rest(void **state) {
    (void)state;
    scene s;
    graze_scene *rest;
    graze_trace *trace;
    graze_enclosure found[POINTS];
    mpq_t points[2 * POINTS];
    scene_open(&s, slide, NULL);
    set_points(points);
    assert_int_equal(graze_scene_at_rest(&rest, s.context, s.solid), GRAZE_OK);
    assert_int_equal(graze_scene_dimension(rest), 2);
    assert_int_equal(graze_scene_ends(rest), GRAZE_ENDS_MEET);
    assert_int_equal(graze_distances(found, s.context, rest, points, POINTS, 1e-9), GRAZE_OK);
    static const double squares[POINTS] = {0.25, 0, 0, 10}; /* of the distances */
    for (int k = 0; k < POINTS; k++) {
        int in = answers[k] == GRAZE_IN;
        double low = in ? -found[k].high : found[k].low, high = in ? -found[k].low : found[k].high;
        assert_int_equal(found[k].pmc, answers[k]);
        assert_true(low >= 0 && low * low <= squares[k] && squares[k] <= high * high);
    }
    assert_int_equal(graze_trace_create(&trace, s.context, rest, points), GRAZE_OK);
    assert_string_equal(graze_trace_word(trace), "I");
    graze_trace_destroy(trace);
    graze_scene_destroy(rest);
    clear_points(points);
    scene_close(&s);
}

static void refuse_rows(const scene *s, const graze_scene *of, const graze_row_options *options,
                        const char *message) {
    char *head;
    assert_int_equal(graze_report_header(&head, s->context, of, NULL, NULL, options), GRAZE_EUSE);
    assert_null(head);
    assert_string_equal(graze_context_message(s->context), message);
}

static void rows_at_rest(void **state) {
    (void)state;
    static const char others[] =
        "graze_report_header: rows of a solid at rest have pmc and sdf, and no other answer";
    scene s;
    graze_scene *rest;
    char *text;
    size_t length, done;
    mpq_t points[2 * POINTS];
    graze_row_options shown = {.size = sizeof shown, .at_rest = 1};
    scene_open(&s, slide, NULL);
    set_points(points);
    assert_int_equal(graze_scene_at_rest(&rest, s.context, s.solid), GRAZE_OK);
    assert_int_equal(graze_report_points(&text, &length, &done, NULL, s.context, rest, points,
                                         POINTS, NULL, &shown),
                     GRAZE_OK);
    assert_string_equal(text, "1,1/2,in\n2,1,on\n2,2,on\n3,5,out\n");
    graze_free(text);
    shown.format = GRAZE_FORMAT_JSONL;
    shown.sdf = 1e-3;
    assert_int_equal(graze_report_point(&text, s.context, rest, points + 2, NULL, &shown),
                     GRAZE_OK);
    assert_string_equal(text,
                        "{\"point\":[\"2\",\"1\"],\"pmc\":\"on\",\"sdf_low\":0,\"sdf_high\":0}\n");
    graze_free(text);
    refuse_rows(&s, s.scene, &shown,
                "at_rest: the scene has a motion; expected one of graze_scene_at_rest");
    const graze_row_options wrong[] = {
        {.size = sizeof shown, .at_rest = 1, .topo = 1},
        {.size = sizeof shown, .at_rest = 1, .regular = 1},
        {.size = sizeof shown, .at_rest = 1, .moments = 1},
        {.size = sizeof shown, .at_rest = 1, .sdf = 1, .boundary = 1},
        {.size = sizeof shown, .at_rest = 1, .motion_error = 1}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++)
        refuse_rows(&s, rest, &wrong[k], others);
    shown.at_rest = 2;
    refuse_rows(&s, rest, &shown, "graze_report_header: an option has an unknown value");
    graze_scene_destroy(rest);
    clear_points(points);
    scene_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_of_a_square),
        cmocka_unit_test(points_of_a_disk),
        cmocka_unit_test(scenes_at_rest),
        cmocka_unit_test(rows_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
