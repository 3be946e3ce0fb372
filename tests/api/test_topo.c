/* Positions relative to the closed sweep through the public functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

/* Like `slide`, and back to (4, 0) over (9, 9): the square's right side rests at x = 6 for an
 * instant, its left side later comes to x = 6. */
static const char seam[] =
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [\"4*t\", 0]}},"
    "{\"t\": [1, 2], \"transform\": {\"translate\": [\"4-4*s\", \"8*s\"]}},"
    "{\"t\": [2, 3], \"transform\": {\"translate\": [\"12*s\", 8]}},"
    "{\"t\": [3, 4], \"transform\": {\"translate\": [\"12-6*s\", \"8-8*s\"]}}]}";
/* The top side slides along (0, 0); later the corner (0, 0) passes it along y = x^2: between both
 * is a gap where x < 0, thinner than every cone. */
static const char plane_gap[] =
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [\"8*t-5\", "
    "-2]}}, {\"t\": [1, 2], \"transform\": {\"translate\": [3, \"7*s-2\"]}},"
    "{\"t\": [2, 3], \"transform\": {\"translate\": [\"3-4*s\", 5]}},"
    "{\"t\": [3, 4], \"transform\": {\"translate\": [-1, \"5-4*s\"]}},"
    "{\"t\": [4, 5], \"transform\": {\"translate\": [\"2*s-1\", \"(2*s-1)^2\"]}}]}";
static const char turn_about[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                                 "{\"turn\": {\"quarters\": 1}}}]}";
static const char turn_less[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                                "{\"rotate\": {\"tan_half\": \"t/2\"}}}]}";

/* Two roofs, and their way: the lower ridge, along y, draws z = x^2 about the origin, the upper
 * one, along x, z = y^2. About (0, y) what is between them is covered by neither. */
static const double roofs[] = {0,  -3, 0,  -1, -3, -2, 1,  -3, -2, 0, 3, 0,  -1, 3, -2, 1, 3,  -2,
                               -3, 0,  10, -3, 1,  12, -3, -1, 12, 3, 0, 10, 3,  1, 12, 3, -1, 12};
static const size_t roof_sizes[] = {3, 3, 4, 4, 4, 3, 3, 4, 4, 4};
static const size_t roof_facets[] = {0, 1, 2, 5, 4,  3,  3, 4, 1,  0, 4, 5, 2,  1,  5, 3, 0, 2,
                                     8, 7, 6, 9, 10, 11, 6, 7, 10, 9, 7, 8, 11, 10, 8, 6, 9, 11};
static const char crossing[] =
    "{\"dimension\": 3, \"pieces\": [{\"t\": [-1, 1], \"transform\": {\"translate\": [\"t\", 0, "
    "\"t^2\"]}}, {\"t\": [1, 2], \"transform\": {\"translate\": [\"1-s\", \"-s\", \"1-10*s\"]}},"
    "{\"t\": [2, 4], \"transform\": {\"translate\": [0, \"t-3\", \"-10+(t-3)^2\"]}},"
    "{\"t\": [4, 5], \"transform\": {\"translate\": [0, \"1+10*s\", -9]}}]}";

typedef struct answer {
    graze_topo position;
    graze_topo_level level;
    int has_witness, has_ray, has_square;
    char reason[100];
} answer;

typedef graze_status (*asked)(graze_topology **, graze_context *, const graze_scene *,
                              graze_rationals, const graze_trace *);

/* The answer for a point, whose witness is out, or of whether it is regular in. */
static answer ask_by(asked question, scene *s, const char *x, const char *y) {
    graze_trace *trace = NULL;
    graze_topology *topology = NULL;
    graze_verdict verdict;
    answer out;
    mpq_t p[2], witness[2], along[4], far;
    mpq_inits(p[0], p[1], witness[0], witness[1], far, NULL);
    mpq_inits(along[0], along[1], along[2], along[3], NULL);
    assert_int_equal(mpq_set_str(p[0], x, 10) + mpq_set_str(p[1], y, 10), 0);
    assert_int_equal(graze_trace_create(&trace, s->context, s->scene, p), GRAZE_OK);
    assert_int_equal(question(&topology, s->context, s->scene, p, trace), GRAZE_OK);
    out.position = graze_topology_position(topology);
    out.level = graze_topology_level(topology);
    out.has_witness = graze_topology_witness(witness, topology);
    snprintf(out.reason, sizeof out.reason, "%s", graze_topology_reason(topology));
    out.has_ray = graze_topology_ray(along, far, topology);
    for (int k = 0; k < 2 && out.has_ray; k++) {
        mpq_mul(along[k], along[k], far);
        mpq_add(along[k], along[k], p[k]);
        assert_true(mpq_equal(along[k], witness[k]));
    }
    out.has_square = graze_topology_square(along, far, topology);
    if (out.has_square) {
        assert_true(mpq_cmp_ui(along[0], 1, 1) == 0 && mpq_sgn(along[1]) == 0);
        assert_true(mpq_sgn(along[2]) == 0 && mpq_cmp_ui(along[3], 1, 1) == 0);
        assert_true(mpq_sgn(far) > 0);
    }
    if (out.has_witness) {
        assert_int_equal(
            graze_classify(&verdict, s->context, s->scene, witness, 1, GRAZE_COLUMNS_ALL),
            GRAZE_OK);
        assert_int_equal(verdict.pmc, question == graze_trace_regular ? GRAZE_IN : GRAZE_OUT);
    }
    mpz_set_ui(mpq_denref(p[0]), 0);
    assert_int_equal(question(NULL, s->context, s->scene, p, trace), GRAZE_EUSE);
    graze_topology_destroy(topology);
    assert_int_equal(question(&topology, s->context, s->scene, p, trace), GRAZE_EUSE);
    assert_null(topology);
    mpq_clears(p[0], p[1], witness[0], witness[1], far, NULL);
    mpq_clears(along[0], along[1], along[2], along[3], NULL);
    graze_trace_destroy(trace);
    return out;
}

static answer ask(scene *s, const char *x, const char *y) {
    return ask_by(graze_trace_topo, s, x, y);
}

static void positions(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    answer a = ask(&s, "5", "1");
    assert_true(a.position == GRAZE_TOPO_INTERIOR && a.level == GRAZE_LEVEL_WORD);
    assert_true(!a.has_ray && !a.has_square);
    a = ask(&s, "5", "3");
    assert_true(a.position == GRAZE_TOPO_EXTERIOR && a.level == GRAZE_LEVEL_WORD);
    a = ask(&s, "5", "2"); /* the top edge slides along it */
    assert_true(a.position == GRAZE_TOPO_BOUNDARY && a.level > GRAZE_LEVEL_WORD && a.has_witness);
    assert_true(a.has_ray == (a.level == GRAZE_LEVEL_FIRST_ORDER) && a.has_square == !a.has_ray);
    assert_string_equal(a.reason, "");
    scene_close(&s);
    scene_open(&s, seam, NULL);
    a = ask(&s, "6", "1");
    assert_true(a.position == GRAZE_TOPO_INTERIOR && a.level > GRAZE_LEVEL_WORD && !a.has_witness);
    a = ask(&s, "6", "0"); /* below is nothing */
    assert_true(a.position == GRAZE_TOPO_BOUNDARY && a.has_witness && a.has_ray);
    scene_close(&s);
    scene_open(&s, plane_gap, NULL);
    a = ask(&s, "0", "0");
    assert_true(a.position == GRAZE_TOPO_BOUNDARY && a.level == GRAZE_LEVEL_CURVES);
    assert_true(a.has_witness && a.has_square && !a.has_ray);
    scene_close(&s);
}

/* The corner that is turned about is `on` the unsweep. A quarter turn leaves the side y = 0 alone,
 * which dangles; one by 2 atan(1/2) leaves what is between (1, 0) and (4, 3). */
static void unsweep(void **state) {
    (void)state;
    scene s;
    scene_open(&s, turn_about,
               &(graze_options){.size = sizeof(graze_options), .operation = GRAZE_UNSWEEP});
    answer a = ask(&s, "0", "0");
    assert_true(a.position == GRAZE_TOPO_BOUNDARY && a.level == GRAZE_LEVEL_WORD && !a.has_witness);
    a = ask(&s, "-1", "0");
    assert_true(a.position == GRAZE_TOPO_EXTERIOR && a.level == GRAZE_LEVEL_WORD);
    a = ask_by(graze_trace_regular, &s, "-1", "0");
    assert_true(a.position == GRAZE_TOPO_EXTERIOR && a.level == GRAZE_LEVEL_WORD);
    a = ask_by(graze_trace_regular, &s, "0", "0");
    assert_true(a.position == GRAZE_TOPO_EXTERIOR && a.level > GRAZE_LEVEL_WORD && !a.has_witness);
    scene_close(&s);
    scene_open(&s, turn_less,
               &(graze_options){.size = sizeof(graze_options), .operation = GRAZE_UNSWEEP});
    a = ask_by(graze_trace_regular, &s, "0", "0");
    assert_true(a.position == GRAZE_TOPO_BOUNDARY && a.has_witness && a.has_ray);
    a = ask_by(graze_trace_regular, &s, "1", "1/2");
    assert_true(a.position == GRAZE_TOPO_INTERIOR && a.level == GRAZE_LEVEL_WORD);
    assert_string_equal(graze_regular_name(GRAZE_TOPO_INTERIOR), "yes");
    assert_string_equal(graze_regular_name(GRAZE_TOPO_BOUNDARY), "yes");
    assert_string_equal(graze_regular_name(GRAZE_TOPO_EXTERIOR), "no");
    assert_string_equal(graze_regular_name(GRAZE_TOPO_UNDECIDED), "undecided");
    assert_string_equal(graze_regular_name(GRAZE_TOPO_NONE), "none");
    scene_close(&s);
}

/* The witness lies on a path in the plane z = 0 with a bend, at epsilon. */
static void path(void **state) {
    (void)state;
    graze_solid *solid = NULL;
    graze_motion *motion = NULL;
    graze_scene *made = NULL;
    graze_context *context = NULL;
    graze_trace *trace = NULL;
    graze_topology *topology = NULL;
    graze_verdict verdict;
    size_t order = 9;
    mpq_t p[3], x[3], n[3], witness[3], z, epsilon;
    for (int k = 0; k < 3; k++)
        mpq_inits(p[k], x[k], n[k], witness[k], NULL);
    mpq_inits(z, epsilon, NULL);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(
        graze_solid_from_doubles(&solid, context, 3, roofs, 12, roof_sizes, 10, roof_facets, 0),
        GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, context, crossing, strlen(crossing)),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&made, context, solid, motion, NULL), GRAZE_OK);
    assert_int_equal(graze_trace_create(&trace, context, made, p), GRAZE_OK);
    assert_int_equal(graze_trace_topo(&topology, context, made, p, trace), GRAZE_OK);
    assert_int_equal(graze_topology_position(topology), GRAZE_TOPO_BOUNDARY);
    assert_int_equal(graze_topology_level(topology), GRAZE_LEVEL_LEADING_TERMS);
    assert_true(graze_topology_witness(witness, topology));
    assert_false(graze_topology_ray(x, epsilon, topology));
    assert_false(graze_topology_square(x, epsilon, topology));
    assert_false(graze_topology_path(x, n, z, NULL, epsilon, topology));
    assert_true(graze_topology_path(x, n, z, &order, epsilon, topology));
    assert_true(order == 1 && mpq_sgn(epsilon) > 0);
    assert_true(mpq_sgn(x[2]) == 0 && mpq_sgn(n[0]) == 0 && mpq_sgn(n[1]) == 0 && mpq_sgn(n[2]));
    mpq_mul(z, z, epsilon);
    for (int k = 0; k < 3; k++) { /* s x + s^2 z N = s (x + s z N) */
        mpq_mul(n[k], n[k], z);
        mpq_add(x[k], x[k], n[k]);
        mpq_mul(x[k], x[k], epsilon);
        assert_true(mpq_equal(x[k], witness[k]));
    }
    assert_int_equal(graze_classify(&verdict, context, made, witness, 1, GRAZE_COLUMNS_ALL),
                     GRAZE_OK);
    assert_int_equal(verdict.pmc, GRAZE_OUT);
    for (int k = 0; k < 3; k++)
        mpq_clears(p[k], x[k], n[k], witness[k], NULL);
    mpq_clears(z, epsilon, NULL);
    graze_topology_destroy(topology);
    graze_trace_destroy(trace);
    graze_scene_destroy(made);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    graze_context_destroy(context);
    graze_thread_finish();
}

static char *row(scene *s, long x, long y, graze_format format) {
    char *text = NULL;
    mpq_t p[2];
    mpq_inits(p[0], p[1], NULL);
    mpq_set_si(p[0], x, 1);
    mpq_set_si(p[1], y, 1);
    assert_int_equal(
        graze_report_point(
            &text, s->context, s->scene, p, &(graze_row_texts){NULL, "a,b"},
            &(graze_row_options){.size = sizeof(graze_row_options), .format = format, .topo = 1}),
        GRAZE_OK);
    mpq_clears(p[0], p[1], NULL);
    return text;
}

static void rows(void **state) {
    (void)state;
    scene s;
    char *text;
    scene_open(&s, slide, NULL);
    assert_int_equal(
        graze_report_header(&text, s.context, s.scene, NULL, "m,n",
                            &(graze_row_options){sizeof(graze_row_options), .topo = 1}),
        GRAZE_OK);
    assert_non_null(strstr(text, "# topo yes\n"));
    assert_non_null(strstr(text, ",word,m,n,topo\n"));
    graze_free(text);
    text = row(&s, 5, 1, GRAZE_FORMAT_CSV);
    assert_string_equal(text, "5,1,in,regular,5,1,2,0,OBIBO,a,b,interior\n");
    graze_free(text);
    text = row(&s, 5, 2, GRAZE_FORMAT_CSV);
    assert_string_equal(text, "5,2,on,boundary,8,1,0,1,OBO,a,b,boundary\n");
    graze_free(text);
    text = row(&s, 5, 3, GRAZE_FORMAT_JSONL);
    assert_non_null(
        strstr(text, "\"contacts\":[],\"topo\":\"exterior\",\"topo_level\":\"word\"}\n"));
    graze_free(text);
    scene_close(&s);
}

static void names(void **state) {
    (void)state;
    assert_string_equal(graze_topo_name(GRAZE_TOPO_INTERIOR), "interior");
    assert_string_equal(graze_topo_name(GRAZE_TOPO_BOUNDARY), "boundary");
    assert_string_equal(graze_topo_name(GRAZE_TOPO_EXTERIOR), "exterior");
    assert_string_equal(graze_topo_name(GRAZE_TOPO_UNDECIDED), "undecided");
    assert_string_equal(graze_topo_name(GRAZE_TOPO_NONE), "none");
    assert_string_equal(graze_topo_name((graze_topo)5), "none");
    assert_string_equal(graze_topo_level_name(GRAZE_LEVEL_WORD), "word");
    assert_string_equal(graze_topo_level_name(GRAZE_LEVEL_FIRST_ORDER), "first_order");
    assert_string_equal(graze_topo_level_name(GRAZE_LEVEL_CURVES), "curves");
    assert_string_equal(graze_topo_level_name((graze_topo_level)8), "none");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(positions), cmocka_unit_test(unsweep),
                                       cmocka_unit_test(path), cmocka_unit_test(rows),
                                       cmocka_unit_test(names)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
