/* Reports through the public functions: the canonical hash, rows, refusals.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"
#include <sha256.h>

static void scene_line(char *out, size_t size, const char *canonical) {
    unsigned char hash[32];
    SHA2_CTX sha;
    SHA256Init(&sha);
    SHA256Update(&sha, (const uint8_t *)canonical, strlen(canonical));
    SHA256Final(hash, &sha);
    int at = snprintf(out, size, "# scene-sha256 ");
    for (int k = 0; k < 32; k++)
        at += snprintf(out + at, size - (size_t)at, "%02x", hash[k]);
    snprintf(out + at, size - (size_t)at, "\n");
}

static void expect_hash(const scene *s, const graze_scene *made, const char *canonical) {
    char line[128], *head;
    scene_line(line, sizeof line, canonical);
    assert_int_equal(graze_report_header(&head, s->context, made, NULL, NULL, NULL), GRAZE_OK);
    if (!strstr(head, line))
        fail_msg("%s lacks %s", head, line);
    graze_free(head);
}

#define MOTION "p 0 1\nm 1\nm\nm 0 8\nm\nm 1\nm\nw 1\n"

/* The canonical text written by hand from its description, hashed here. */
static void hash_of_the_canonical_text(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    expect_hash(&s, s.scene, "d 2\nv 0 0\nv 2 0\nv 2 2\nv 0 2\nf 0 1 2 3\n" MOTION);
    scene_close(&s);
}

/* Non-planar facets that are fanned add their triangles: a cube with one corner pulled out. */
static void hash_of_a_fanned_solid(void **state) {
    (void)state;
    static const double v[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0,
                               0, 0, 2, 2, 0, 2, 0, 2, 2, 3, 3, 3};
    static const size_t sizes[] = {4, 4, 4, 4, 4, 4};
    static const size_t cube[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                  2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    static const char slide3[] = "{\"dimension\":3,\"pieces\":[{\"t\":[0,1],\"transform\":"
                                 "{\"translate\":[\"8*t\",0,0]}}]}";
    scene s;
    scene_open(&s, slide, NULL);
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *made;
    assert_int_equal(graze_solid_from_doubles(&solid, s.context, 3, v, 8, sizes, 6, cube, 0),
                     GRAZE_EILLEGAL);
    assert_int_equal(graze_solid_from_doubles(&solid, s.context, 3, v, 8, sizes, 6, cube,
                                              GRAZE_SOLID_TRIANGULATE),
                     GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, s.context, slide3, strlen(slide3)), GRAZE_OK);
    assert_int_equal(graze_scene_create(&made, s.context, solid, motion, NULL), GRAZE_OK);
    expect_hash(&s, made,
                "d 3\nv 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 0 0 2\nv 2 0 2\nv 0 2 2\nv 3 3 3\n"
                "f 0 2 3 1\nf 4 5 7 6\nf 0 1 5 4\nf 2 6 7 3\nf 0 4 6 2\nf 1 3 7 5\n"
                "t 4 5 7\nt 4 7 6\nt 2 6 7\nt 2 7 3\nt 1 3 7\nt 1 7 5\n"
                "p 0 1\nm 1\nm\nm\nm 0 8\nm\nm 1\nm\nm\nm\nm\nm 1\nm\nw 1\n");
    graze_scene_destroy(made);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    scene_close(&s);
}

static void rows_and_explanation(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    mpq_t p[2];
    graze_trace *trace;
    char *text;
    mpq_inits(p[0], p[1], NULL);
    mpq_set_ui(p[0], 16, 3);
    mpq_set_ui(p[1], 2, 1);
    assert_int_equal(graze_trace_create(&trace, s.context, s.scene, p), GRAZE_OK);
    assert_int_equal(graze_report_row(&text, s.context, s.scene, p, trace,
                                      &(graze_row_texts){NULL, "a,b"}, NULL),
                     GRAZE_OK);
    assert_string_equal(text, "16/3,2,on,boundary,8,1,0,1,OBO,a,b\n");
    graze_free(text);
    /* 16/3 - 8t runs over [0, 2] for t from 5/12 to 2/3, along the edge between vertices 2 and 3.
     */
    assert_int_equal(graze_report_row(&text, s.context, s.scene, p, trace, NULL, &as_jsonl),
                     GRAZE_OK);
    assert_string_equal(text, "{\"point\":[\"16/3\",\"2\"],\"pmc\":\"on\",\"class\":\"boundary\","
                              "\"definition\":8,\"case\":1,\"i\":0,\"t\":1,\"word\":\"OBO\","
                              "\"contacts\":[{\"kind\":\"tangency\",\"left\":\"O\",\"right\":\"O\","
                              "\"from\":\"5/12\",\"to\":\"2/3\",\"features\":[{\"edge\":[2,3]},"
                              "{\"vertex\":2},{\"vertex\":3}]}]}\n");
    graze_free(text);
    assert_int_equal(
        graze_report_row(&text, s.context, s.scene, p, trace, NULL,
                         &(graze_row_options){.size = sizeof(graze_row_options), .moments = 1}),
        GRAZE_OK);
    assert_string_equal(
        text,
        "16/3,2,on,boundary,8,1,0,1,OBO,5/12,0.41666666666666667,0,2/3,0.66666666666666667,0\n");
    graze_free(text);
    assert_int_equal(graze_report_row(&text, s.context, s.scene, p, trace, NULL,
                                      &(graze_row_options){.size = sizeof(graze_row_options),
                                                           .format = (graze_format)5}),
                     GRAZE_EUSE);
    assert_int_equal(graze_report_explain(&text, s.context, s.scene, p, trace, NULL), GRAZE_OK);
    assert_non_null(strstr(text, "  B  from t = 5/12, about 0.416666666667\n"
                                 "     to t = 2/3, about 0.666666666667\n"
                                 "       it meets edge 2-3, vertex 2, vertex 3\n"
                                 "       tangency: O before and after"));
    graze_free(text);
    mpz_set_ui(mpq_denref(p[0]), 2);
    assert_int_equal(graze_report_explain(&text, s.context, s.scene, p, trace, NULL), GRAZE_EUSE);
    assert_null(text);
    graze_trace_destroy(trace);
    mpq_clears(p[0], p[1], NULL);
    scene_close(&s);
}

/* (5, 1) is inside for 3 < 8t < 5; (16/3, 2) slides along the upper edge; (-1, -1) is below. */
static void number_as_decimal(void **state) {
    (void)state;
    graze_context *context = NULL;
    char *text;
    mpq_t x;
    mpq_init(x);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    mpq_set_si(x, -22, 7);
    assert_int_equal(graze_number_decimal(&text, context, x, 4), GRAZE_OK);
    assert_string_equal(text, "-3.143");
    graze_free(text);
    assert_int_equal(graze_number_decimal(&text, context, x, 0), GRAZE_EINPUT);
    assert_string_equal(graze_context_message(context), "the number has no finite decimal");
    assert_null(text);
    mpq_set_si(x, 1, 8);
    assert_int_equal(graze_number_decimal(&text, context, x, 0), GRAZE_OK);
    assert_string_equal(text, "0.125");
    graze_free(text);
    mpq_set_si(x, 123456, 1);
    assert_int_equal(graze_number_decimal(&text, context, x, 2), GRAZE_OK);
    assert_string_equal(text, "1.2e5");
    graze_free(text);
    mpz_set_ui(mpq_denref(x), 0);
    assert_int_equal(graze_number_decimal(&text, context, x, 0), GRAZE_EUSE);
    mpq_clear(x);
    graze_context_destroy(context);
}

static void rows_of_many_points(void **state) {
    (void)state;
    static const char inside[] = "5,1,in,regular,5,1,2,0,OBIBO,a\n";
    static const char all[] = "5,1,in,regular,5,1,2,0,OBIBO,a\n16/3,2,on,boundary,8,1,0,1,OBO\n"
                              "-1,-1,out,exterior,9,1,0,0,O,\n";
    static const graze_row_texts rest[] = {{NULL, "a"}, {NULL, NULL}, {NULL, ""}};
    scene s;
    mpq_t p[6];
    char *text;
    size_t length, done;
    scene_open(&s, slide, NULL);
    for (int k = 0; k < 6; k++)
        mpq_init(p[k]);
    mpq_set_ui(p[0], 5, 1);
    mpq_set_ui(p[1], 1, 1);
    mpq_set_ui(p[2], 16, 3);
    mpq_set_ui(p[3], 2, 1);
    mpq_set_si(p[4], -1, 1);
    mpq_set_si(p[5], -1, 1);
    assert_int_equal(
        graze_report_points(&text, &length, &done, NULL, s.context, s.scene, p, 3, rest, NULL),
        GRAZE_OK);
    assert_string_equal(text, all);
    assert_int_equal(length, strlen(all));
    assert_int_equal(done, 3);
    graze_free(text);
    assert_int_equal(
        graze_report_point(&text, s.context, s.scene, p, &(graze_row_texts){NULL, "a"}, NULL),
        GRAZE_OK);
    assert_string_equal(text, inside);
    graze_free(text);
    assert_int_equal(graze_report_points(&text, &length, &done, NULL, s.context, s.scene, NULL, 0,
                                         NULL, &as_jsonl),
                     GRAZE_OK);
    assert_null(text);
    assert_int_equal(length + done, 0);
    mpz_set_ui(mpq_numref(p[2]), 15); /* 15/3 is not in lowest terms */
    assert_int_equal(
        graze_report_points(&text, &length, &done, NULL, s.context, s.scene, p, 3, rest, NULL),
        GRAZE_EUSE);
    assert_string_equal(text, inside);
    assert_int_equal(done, 1);
    graze_free(text);
    assert_int_equal(graze_report_points(&text, &length, &done, NULL, s.context, s.scene, p, 3,
                                         rest,
                                         &(graze_row_options){.size = sizeof(graze_row_options),
                                                              .format = (graze_format)5}),
                     GRAZE_EUSE);
    assert_null(text);
    for (int k = 0; k < 6; k++)
        mpq_clear(p[k]);
    scene_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hash_of_the_canonical_text), cmocka_unit_test(hash_of_a_fanned_solid),
        cmocka_unit_test(rows_and_explanation),       cmocka_unit_test(number_as_decimal),
        cmocka_unit_test(rows_of_many_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
