/* Handles: NULL, wrong arguments, limits, roundings, and what the getters say.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

static void null_is_harmless(void **state) {
    (void)state;
    graze_context_destroy(NULL);
    graze_solid_destroy(NULL);
    graze_motion_destroy(NULL);
    graze_scene_destroy(NULL);
    graze_trace_destroy(NULL);
    graze_free(NULL);
    assert_int_equal(graze_solid_dimension(NULL), 0);
    assert_int_equal(graze_solid_vertex_count(NULL), 0);
    assert_int_equal(graze_solid_facet_count(NULL), 0);
    assert_int_equal(graze_solid_component_count(NULL), 0);
    assert_int_equal(graze_scene_dimension(NULL), 0);
    assert_int_equal(graze_scene_ends_meet(NULL), 0);
    graze_options options = {.size = sizeof options, .folds = GRAZE_FOLDS_COMBINED};
    graze_scene_options(&options, NULL);
    assert_int_equal(options.folds, GRAZE_FOLDS_SEPARATE);
    assert_int_equal(graze_scene_hashes(NULL).scene[0], 0);
    assert_string_equal(graze_trace_word(NULL), "");
    assert_int_equal(graze_trace_verdict(NULL).pmc, GRAZE_PMC_NONE);
    assert_int_equal(graze_trace_contact_count(NULL), 0);
    assert_int_equal(graze_trace_contact(NULL, 0).cell_count, 0);
    assert_int_equal(graze_time_degree(NULL), 0);
    mpq_t q;
    mpq_init(q);
    assert_int_equal(graze_time_rational(q, NULL), 0);
    mpq_clear(q);
}

/* Every function that fails on NULL says so, sets its output to NULL, and leaves a message where
 * there is a context. */
static void null_is_wrong_use(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    graze_solid *solid = s.solid;
    graze_scene *made = s.scene;
    graze_trace *trace = (graze_trace *)&s;
    char *text = (char *)&s;
    size_t length;
    mpq_t x[2];
    mpq_init(x[0]);
    mpq_init(x[1]);
    assert_int_equal(graze_solid_read(NULL, s.context, "a.off", 0), GRAZE_EUSE);
    assert_int_equal(graze_solid_read(&solid, s.context, NULL, 0), GRAZE_EUSE);
    assert_null(solid);
    assert_int_equal(graze_solid_read(&solid, NULL, "a.off", 0), GRAZE_EUSE);
    assert_int_equal(graze_solid_read(&solid, s.context, "a.off", 2), GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(s.context), "flag"));
    assert_int_equal(graze_scene_create(&made, s.context, NULL, s.motion, NULL), GRAZE_EUSE);
    assert_null(made);
    graze_options odd = {.size = sizeof odd, .operation = (graze_operation)7};
    assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &odd), GRAZE_EUSE);
    assert_int_equal(graze_scene_box(NULL, x, s.context, s.scene), GRAZE_EUSE);
    assert_int_equal(graze_trace_create(&trace, s.context, s.scene, NULL), GRAZE_EUSE);
    assert_null(trace);
    assert_int_equal(graze_report_header(&text, s.context, NULL, NULL, NULL, NULL), GRAZE_EUSE);
    assert_null(text);
    assert_int_equal(graze_report_row(&text, s.context, s.scene, x, NULL, NULL, NULL), GRAZE_EUSE);
    assert_int_equal(graze_report_point(&text, s.context, s.scene, NULL, NULL, NULL), GRAZE_EUSE);
    assert_int_equal(
        graze_report_points(&text, &length, NULL, NULL, s.context, s.scene, x, 1, NULL, NULL),
        GRAZE_EUSE);
    assert_int_equal(graze_report_explain(&text, s.context, s.scene, x, NULL, NULL), GRAZE_EUSE);
    assert_int_equal(graze_time_decimal(&text, s.context, NULL, 5), GRAZE_EUSE);
    assert_int_equal(graze_number_parse(x[0], s.context, NULL, 0), GRAZE_EUSE);
    assert_int_equal(graze_classify(NULL, s.context, s.scene, NULL, 1, GRAZE_COLUMNS_ALL),
                     GRAZE_EUSE);
    assert_int_equal(graze_classify(NULL, s.context, s.scene, NULL, 0, GRAZE_COLUMNS_ALL),
                     GRAZE_OK);
    mpq_clear(x[0]);
    mpq_clear(x[1]);
    scene_close(&s);
}

static void null_motion(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    graze_motion *motion = s.motion;
    assert_int_equal(graze_motion_read(&motion, s.context, NULL), GRAZE_EUSE);
    assert_null(motion);
    motion = s.motion;
    assert_int_equal(graze_motion_from_json(&motion, s.context, NULL, 3), GRAZE_EUSE);
    assert_null(motion);
    assert_int_equal(graze_motion_read(&motion, NULL, "a.json"), GRAZE_EUSE);
    assert_int_equal(graze_motion_from_json(NULL, s.context, slide, strlen(slide)), GRAZE_EUSE);
    assert_int_equal(graze_motion_dimension(NULL), 0);
    assert_int_equal(graze_motion_piece_count(NULL), 0);
    scene_close(&s);
}

static void null_context(void **state) {
    (void)state;
    assert_int_equal(graze_context_create(NULL), GRAZE_EUSE);
    assert_string_equal(graze_context_message(NULL), "");
    assert_int_equal(graze_context_limit(NULL, GRAZE_LIMIT_DIGITS), 0);
    assert_int_equal(graze_context_set_limit(NULL, GRAZE_LIMIT_DIGITS, 1), GRAZE_EUSE);
    assert_int_equal(graze_context_set_rounding(NULL, GRAZE_ROUND_NONE), GRAZE_EUSE);
    graze_context_set_cancel(NULL, NULL, NULL);
}

static void limits_and_roundings(void **state) {
    (void)state;
    graze_context *c;
    assert_int_equal(graze_context_create(&c), GRAZE_OK);
    assert_string_equal(graze_context_message(c), "");
    for (int k = 0; k < GRAZE_LIMIT_COUNT; k++) {
        assert_non_null(graze_limit_name((graze_limit)k));
        assert_int_equal(graze_context_set_limit(c, (graze_limit)k, 7), GRAZE_OK);
        assert_int_equal(graze_context_limit(c, (graze_limit)k), 7);
    }
    assert_null(graze_limit_name(GRAZE_LIMIT_COUNT));
    assert_int_equal(graze_context_set_limit(c, GRAZE_LIMIT_COUNT, 7), GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(c), "limit 12: expected 0 to 11"));
    assert_int_equal(graze_context_set_rounding(c, (graze_rounding)9), GRAZE_EUSE);
    assert_non_null(
        strstr(graze_context_message(c), "rounding 9: expected none, binary64 or binary32"));
    mpq_t x;
    mpq_init(x);
    assert_int_equal(graze_number_parse(x, c, "12345678", 8), GRAZE_ELIMIT);
    assert_int_equal(graze_number_parse(x, c, "1/3", 3), GRAZE_OK);
    assert_int_equal(mpq_cmp_si(x, 1, 3), 0);
    assert_int_equal(graze_context_set_rounding(c, GRAZE_ROUND_BINARY32), GRAZE_OK);
    assert_int_equal(graze_number_parse(x, c, "1/3", 3), GRAZE_OK);
    assert_int_equal(mpq_cmp_ui(x, 11184811, 33554432), 0); /* 2^-25 * 11184811, as IEEE has it */
    assert_int_equal(graze_number_parse(x, c, "one", 3), GRAZE_EINPUT);
    mpq_clear(x);
    graze_context_destroy(c);
}

/* Rings of E^2 in either orientation; a square with a square hole, and one in the hole. */
static void rings_nest(void **state) {
    (void)state;
    static const double v[] = {0, 0, 9, 0, 9, 9, 0, 9, 1, 1, 8, 1,
                               8, 8, 1, 8, 2, 2, 3, 2, 3, 3, 2, 3};
    static const size_t sizes[] = {4, 4, 4};
    static const size_t turned[] = {11, 10, 9, 8, 4, 5, 6, 7, 0, 3, 2, 1};
    scene s;
    scene_open(&s, slide, NULL);
    graze_solid *rings;
    graze_scene *made;
    assert_int_equal(graze_solid_from_doubles(&rings, s.context, 2, v, 12, sizes, 3, turned, 0),
                     GRAZE_OK);
    assert_int_equal(graze_solid_vertex_count(rings), 12);
    assert_int_equal(graze_solid_facet_count(rings), 12);
    assert_int_equal(graze_solid_component_count(rings), 3);
    graze_options unsweep = {.size = sizeof unsweep, .operation = GRAZE_UNSWEEP};
    graze_motion *still;
    static const char rest[] = "{\"dimension\":2,\"pieces\":[{\"t\":[0,1],\"transform\":"
                               "{\"translate\":[0,0]}}]}";
    assert_int_equal(graze_motion_from_json(&still, s.context, rest, strlen(rest)), GRAZE_OK);
    assert_int_equal(graze_scene_create(&made, s.context, rings, still, &unsweep), GRAZE_OK);
    static const double p[] = {0.5, 4, 1.5, 4, 2.5, 2.5, 8, 4, 10, 10};
    static const graze_pmc expected[] = {GRAZE_IN, GRAZE_OUT, GRAZE_IN, GRAZE_ON, GRAZE_OUT};
    graze_verdict verdict[5];
    assert_int_equal(graze_classify_doubles(verdict, s.context, made, p, 5, GRAZE_COLUMNS_ALL),
                     GRAZE_OK);
    for (int k = 0; k < 5; k++)
        assert_int_equal(verdict[k].pmc, expected[k]);
    graze_scene_destroy(made);
    graze_motion_destroy(still);
    graze_solid_destroy(rings);
    scene_close(&s);
}

static void wrong_arrays(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    graze_solid *solid;
    static const size_t two[] = {2}, wild[] = {0, 1, 2, 4}, flat[] = {0, 1, 0, 1},
                        crossed[] = {0, 2, 1, 3};
    static const double nan_square[] = {0, 0, 2, 0, 2, 2, 0, NAN};
    const struct {
        const double *v;
        const size_t *sizes, *index;
        int dimension;
        size_t facets;
        graze_status status;
        const char *says;
    } cases[] = {
        {square, two, square_ring, 2, 1, GRAZE_EINPUT, "facet 0 has 2 vertices"},
        {square, square_sizes, wild, 2, 1, GRAZE_EINPUT, "names vertex 4; expected below 4"},
        {square, square_sizes, flat, 2, 1, GRAZE_EILLEGAL, "facet 0: the ring's area is zero"},
        {square, square_sizes, crossed, 2, 1, GRAZE_EILLEGAL,
         "facet 0: edges 0-2 and 1-3 cross; edges may touch in vertices only, and these meet at "
         "(1, 1)"},
        {nan_square, square_sizes, square_ring, 2, 1, GRAZE_EINPUT, "vertex 3, coordinate 1"},
        {square, square_sizes, square_ring, 4, 1, GRAZE_EUSE, "dimension must be 2 or 3"},
        {square, square_sizes, square_ring, 2, 0, GRAZE_EILLEGAL, "empty interior"},
        {NULL, square_sizes, square_ring, 2, 1, GRAZE_EUSE, "no array must be NULL"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        assert_int_equal(graze_solid_from_doubles(&solid, s.context, cases[k].dimension, cases[k].v,
                                                  4, cases[k].sizes, cases[k].facets,
                                                  cases[k].index, 0),
                         cases[k].status);
        assert_null(solid);
        if (!strstr(graze_context_message(s.context), cases[k].says))
            fail_msg("case %zu says: %s", k, graze_context_message(s.context));
    }
    scene_close(&s);
}

/* A file is trusted by its hash: with the right one the scene is the same, to its own hash. */
static void trusted_by_hash(void **state) {
    (void)state;
    const char *path = "cases/bracket/solid.off";
    graze_context *context;
    graze_motion *motion;
    graze_hashes hashes[2];
    graze_solid *solid;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(graze_motion_read(&motion, context, "cases/bracket/motion.json"), GRAZE_OK);
    for (int trusted = 0; trusted < 2; trusted++) {
        graze_scene *scene;
        graze_status read =
            trusted ? graze_solid_read_trusted(&solid, context, path, hashes[0].solid, 0)
                    : graze_solid_read(&solid, context, path, 0);
        assert_int_equal(read, GRAZE_OK);
        assert_int_equal(graze_solid_component_count(solid), 1);
        assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
        hashes[trusted] = graze_scene_hashes(scene);
        graze_scene_destroy(scene);
        graze_solid_destroy(solid);
    }
    assert_memory_equal(&hashes[0], &hashes[1], sizeof hashes[0]);
    hashes[1].solid[31] ^= 1;
    assert_int_equal(graze_solid_read_trusted(&solid, context, path, hashes[1].solid, 0),
                     GRAZE_EINPUT);
    assert_null(solid);
    assert_non_null(strstr(graze_context_message(context), path));
    assert_int_equal(graze_solid_read_trusted(&solid, context, path, NULL, 0), GRAZE_EUSE);
    assert_int_equal(graze_solid_read_trusted(&solid, context, path, hashes[0].solid, 2),
                     GRAZE_EUSE);
    graze_motion_destroy(motion);
    graze_context_destroy(context);
}

static void version_names_libraries(void **state) {
    (void)state;
    assert_non_null(strstr(graze_version(), "graze " GRAZE_VERSION "\n"));
    assert_non_null(strstr(graze_version(), "GMP "));
    assert_non_null(strstr(graze_version(), "FLINT "));
    assert_non_null(strstr(graze_version(), "CGAL "));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_is_harmless),
        cmocka_unit_test(null_is_wrong_use),
        cmocka_unit_test(null_motion),
        cmocka_unit_test(null_context),
        cmocka_unit_test(limits_and_roundings),
        cmocka_unit_test(rings_nest),
        cmocka_unit_test(trusted_by_hash),
        cmocka_unit_test(wrong_arrays),
        cmocka_unit_test(version_names_libraries),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
