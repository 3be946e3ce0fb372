/* Certificates through the C interface: wrong calls, what cannot be certified, scenes without
 * files. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What certificates say is tested with graze-check in tests/check.
 */
#include "walk.h"

static graze_scene *open_files(graze_context *context, graze_solid **solid, graze_motion **motion) {
    graze_scene *out = NULL;
    assert_int_equal(graze_solid_read(solid, context, "tests/refuse/common/cube.off", 0), GRAZE_OK);
    assert_int_equal(graze_motion_read(motion, context, "tests/refuse/common/move3.json"),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&out, context, *solid, *motion, NULL), GRAZE_OK);
    return out;
}

/* Both texts of many points are those of the calls for one; a point that fails ends them. */
static void check_points(graze_context *context, const graze_certifier *c,
                         const graze_scene *scene) {
    enum { POINTS = 3 };
    mpq_t p[3 * POINTS];
    char *out, *table, *one, whole[2][4096] = {"", ""};
    const graze_row_texts rest[POINTS] = {{NULL, "a"}, {NULL, NULL}, {NULL, "c"}};
    size_t length, table_length, done;
    for (int k = 0; k < 3 * POINTS; k++) {
        mpq_init(p[k]);
        mpq_set_si(p[k], k % 3 ? 1 : k, 1);
    }
    for (int f = GRAZE_FORMAT_CSV; f <= GRAZE_FORMAT_JSONL; f++) {
        const graze_row_options form = {.size = sizeof form, .format = (graze_format)f};
        whole[0][0] = whole[1][0] = '\0';
        for (int k = 0; k < POINTS; k++) {
            assert_int_equal(graze_certificate_row(&one, context, c, p + 3 * k), GRAZE_OK);
            strcat(whole[0], one);
            graze_free(one);
            assert_int_equal(graze_report_point(&one, context, scene, p + 3 * k, &rest[k], &form),
                             GRAZE_OK);
            strcat(whole[1], one);
            graze_free(one);
        }
        assert_int_equal(graze_certificate_points(&out, &length, &table, &table_length, &done, NULL,
                                                  context, c, p, POINTS, rest, &form),
                         GRAZE_OK);
        assert_int_equal(done, POINTS);
        assert_string_equal(out, whole[0]);
        assert_string_equal(table, whole[1]);
        assert_int_equal(length, strlen(out));
        assert_int_equal(table_length, strlen(table));
        graze_free(out);
        graze_free(table);
    }
    assert_int_equal(graze_certificate_points(&out, &length, NULL, NULL, &done, NULL, context, c, p,
                                              POINTS, NULL, NULL),
                     GRAZE_OK);
    assert_string_equal(out, whole[0]);
    graze_free(out);
    mpz_set_si(mpq_denref(p[5]), -1);
    assert_int_equal(graze_certificate_points(&out, &length, &table, &table_length, &done, NULL,
                                              context, c, p, POINTS, NULL, NULL),
                     GRAZE_EUSE);
    assert_int_equal(done, 1);
    assert_int_equal(strlen(out), length);
    assert_int_equal(strncmp(out, whole[0], length), 0);
    assert_int_equal(strlen(table), table_length);
    assert_null(strchr(table, '\n')[1] ? table : NULL);
    graze_free(out);
    graze_free(table);
    assert_int_equal(graze_certificate_points(&out, &length, NULL, NULL, &done, NULL, context, c,
                                              NULL, 0, NULL, NULL),
                     GRAZE_OK);
    assert_null(out);
    assert_int_equal(graze_certificate_points(&out, &length, &table, NULL, &done, NULL, context, c,
                                              p, 1, NULL, NULL),
                     GRAZE_EUSE);
    assert_int_equal(graze_certificate_points(&out, &length, NULL, NULL, &done, NULL, context, c,
                                              NULL, 1, NULL, NULL),
                     GRAZE_EUSE);
    assert_int_equal(
        graze_certificate_points(
            &out, &length, NULL, NULL, &done, NULL, context, c, p, 1, NULL,
            &(graze_row_options){.size = sizeof(graze_row_options), .columns = GRAZE_COLUMNS_PMC}),
        GRAZE_EUSE);
    assert_int_equal(graze_certificate_points(NULL, &length, NULL, NULL, &done, NULL, context, c, p,
                                              1, NULL, NULL),
                     GRAZE_EUSE);
    assert_int_equal(graze_certificate_points(&out, &length, NULL, NULL, NULL, NULL, context, c, p,
                                              1, NULL, NULL),
                     GRAZE_EUSE);
    for (int k = 0; k < 3 * POINTS; k++) {
        if (k == 5)
            mpz_set_si(mpq_denref(p[k]), 1);
        mpq_clear(p[k]);
    }
}

static void rows(void **state) {
    (void)state;
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_certifier *c = NULL;
    graze_scene *other = NULL;
    char *text = NULL;
    mpq_t p[3];
    mpq_inits(p[0], p[1], p[2], NULL);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    graze_scene *scene = open_files(context, &solid, &motion);
    assert_int_equal(graze_certifier_create(&c, context, scene, 0), GRAZE_OK);
    assert_int_equal(graze_certificate_head(&text, context, c), GRAZE_OK);
    assert_int_equal(strncmp(text, "graze-certificate 1\n", 20), 0);
    graze_free(text);
    mpq_set_si(p[0], 20, 1); /* far beside the cube [0, 2]^3 that moves by 4 along x */
    assert_int_equal(graze_certificate_row(&text, context, c, p), GRAZE_OK);
    assert_int_equal(strncmp(text, "row 20 0 0 O out exterior 9 1 0 0 0\n", 36), 0);
    graze_free(text);
    mpz_set_si(mpq_denref(p[1]), -1);
    assert_int_equal(graze_certificate_row(&text, context, c, p), GRAZE_EUSE);
    assert_null(text);
    mpz_set_si(mpq_denref(p[1]), 1);
    assert_int_equal(graze_certificate_row(&text, context, NULL, p), GRAZE_EUSE);
    assert_int_equal(graze_certificate_row(&text, context, c, NULL), GRAZE_EUSE);
    assert_int_equal(graze_certificate_head(&text, context, NULL), GRAZE_EUSE);
    assert_int_equal(graze_certificate_head(NULL, context, c), GRAZE_EUSE);
    check_points(context, c, scene);
    graze_certifier_destroy(c);
    graze_certifier_destroy(NULL);

    assert_int_equal(graze_certifier_create(&c, context, NULL, 0), GRAZE_EUSE);
    assert_null(c);
    assert_int_equal(graze_certifier_create(&c, context, scene, GRAZE_SOLID_TRIANGULATE),
                     GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(context), "was not triangulated"));
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_BINARY64), GRAZE_OK);
    assert_int_equal(graze_certifier_create(&c, context, scene, 0), GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(context), "expected no rounding"));
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_NONE), GRAZE_OK);
    graze_scene_destroy(scene);

    /* Arrays and texts have no files that a checker could read. */
    graze_solid *cube = NULL;
    double at[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    size_t sizes[] = {3, 3, 3, 3}, index[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    assert_int_equal(graze_solid_from_doubles(&cube, context, 3, at, 4, sizes, 4, index, 0),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&other, context, cube, motion, NULL), GRAZE_OK);
    assert_int_equal(graze_certifier_create(&c, context, other, 0), GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(context), "read from files"));
    graze_scene_destroy(other);
    graze_solid_destroy(cube);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    mpq_clears(p[0], p[1], p[2], NULL);
}

/* The cube [0, 2]^3 moves by 4 along x in [0, 1]: the trajectory of (5, 1, 1) is (5 - 4 t, 1, 1).
 */
static void contacts(void **state) {
    (void)state;
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_certifier *c = NULL;
    char *text = NULL;
    mpq_t p[3];
    mpq_inits(p[0], p[1], p[2], NULL);
    mpq_set_si(p[0], 5, 1);
    mpq_set_si(p[1], 1, 1);
    mpq_set_si(p[2], 1, 1);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    graze_scene *scene = open_files(context, &solid, &motion);
    assert_int_equal(graze_certifier_create(&c, context, scene, GRAZE_CERTIFY_TIMES), GRAZE_OK);
    assert_int_equal(graze_certificate_head(&text, context, c), GRAZE_OK);
    assert_non_null(strstr(text, "\ncontacts yes\nsigns 0 1\n"));
    graze_free(text);
    assert_int_equal(graze_certificate_row(&text, context, c, p), GRAZE_OK);
    assert_int_equal(strncmp(text, "row 5 1 1 OBI in regular 5 3 1 0 1\n", 35), 0);
    assert_non_null(strstr(text, "\ncontact 3/4 face "));
    graze_free(text);
    graze_certifier_destroy(c);
    assert_int_equal(graze_certifier_create(&c, context, scene, GRAZE_CERTIFY_TIMES << 1),
                     GRAZE_EUSE);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    mpq_clears(p[0], p[1], p[2], NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rows), cmocka_unit_test(contacts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
