/* Verdicts and traces through the public functions: worked examples, doubles against rationals,
 * cancelling, threads.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"
#include "../lib/random.h"
#include <pthread.h>

enum { MANY = 400, THREADS = 2 };

/* Examples 1 to 9 of tests/examples/examples.txt, derived by hand. */
static void worked_examples(void **state) {
    (void)state;
    static const struct {
        double x, y;
        const char *word;
        unsigned long i, t;
        int case_;
        graze_class class_;
        graze_pmc pmc;
    } expected[] = {
        {5, 1, "OBIBO", 2, 0, 1, GRAZE_REGULAR, GRAZE_IN},
        {1, 1, "IBO", 1, 0, 7, GRAZE_REGULAR, GRAZE_IN},
        {9, 1, "OBI", 1, 0, 3, GRAZE_REGULAR, GRAZE_IN},
        {5, 3, "O", 0, 0, 1, GRAZE_EXTERIOR, GRAZE_OUT},
        {5, 2, "OBO", 0, 1, 1, GRAZE_BOUNDARY, GRAZE_ON},
        {2, 1, "BIBO", 2, 0, 4, GRAZE_REGULAR, GRAZE_IN},
        {0, 1, "BO", 0, 1, 4, GRAZE_BOUNDARY, GRAZE_ON},
        {8, 1, "OBIB", 2, 0, 2, GRAZE_REGULAR, GRAZE_IN},
        {10, 1, "OB", 0, 1, 2, GRAZE_BOUNDARY, GRAZE_ON},
    };
    scene s;
    scene_open(&s, slide, NULL);
    assert_int_equal(graze_scene_ends_meet(s.scene), 0);
    mpq_t p[2];
    mpq_init(p[0]);
    mpq_init(p[1]);
    for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
        graze_trace *trace;
        graze_verdict by_double;
        double point[2] = {expected[k].x, expected[k].y};
        mpq_set_d(p[0], point[0]);
        mpq_set_d(p[1], point[1]);
        assert_int_equal(graze_trace_create(&trace, s.context, s.scene, p), GRAZE_OK);
        graze_verdict v = graze_trace_verdict(trace);
        assert_string_equal(graze_trace_word(trace), expected[k].word);
        assert_int_equal(v.i, expected[k].i);
        assert_int_equal(v.t, expected[k].t);
        assert_int_equal(v.case_, expected[k].case_);
        assert_int_equal(v.class_, expected[k].class_);
        assert_int_equal(v.pmc, expected[k].pmc);
        assert_int_equal(v.definition, expected[k].class_ == GRAZE_REGULAR    ? 5
                                       : expected[k].class_ == GRAZE_BOUNDARY ? 8
                                                                              : 9);
        assert_int_equal(graze_trace_contact_count(trace), v.i + v.t);
        assert_int_equal(
            graze_classify_doubles(&by_double, s.context, s.scene, point, 1, GRAZE_COLUMNS_ALL),
            GRAZE_OK);
        assert_int_equal(memcmp(&by_double, &v, sizeof v), 0);
        const graze_verdict only = {.pmc = expected[k].pmc};
        assert_int_equal(
            graze_classify_doubles(&by_double, s.context, s.scene, point, 1, GRAZE_COLUMNS_PMC),
            GRAZE_OK);
        assert_int_equal(memcmp(&by_double, &only, sizeof only), 0);
        graze_trace_destroy(trace);
    }
    mpq_clear(p[0]);
    mpq_clear(p[1]);
    scene_close(&s);
}

/* The way back is (10 x - 10 y + 1, y / (4 * 10^18)): at x = y = 6 * 10^18 the products of 10 x and
 * 10 y are longer than a word and cancel, what is added to them is not, and (1, 3/2) is in the
 * square. */
static void long_products_cancel(void **state) {
    (void)state;
    static const char shear[] =
        "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {"
        "\"matrix\": [[\"1/10\", \"4e18\", \"-1/10\"], [0, \"4e18\", 0]]}}]}";
    scene s;
    scene_open(&s, shear, NULL);
    mpq_t p[2];
    mpq_inits(p[0], p[1], NULL);
    mpq_set_str(p[0], "6000000000000000000", 10);
    mpq_set(p[1], p[0]);
    for (int filter = 0; filter < 2; filter++) {
        graze_trace *trace;
        graze_context_set_filter(s.context, filter);
        assert_int_equal(graze_trace_create(&trace, s.context, s.scene, p), GRAZE_OK);
        assert_string_equal(graze_trace_word(trace), "I");
        graze_trace_destroy(trace);
    }
    mpq_clears(p[0], p[1], NULL);
    scene_close(&s);
}

/* The block [2,4]x[-1,1] turning by 2 atan t meets (0,3) at t = sqrt(2)/2
 * (tests/examples/examples.txt, 40).
 */
static void irrational_time(void **state) {
    (void)state;
    static const double block[] = {2, -1, 4, -1, 4, 1, 2, 1};
    static const char turn[] = "{\"dimension\":2,\"pieces\":[{\"t\":[0,1],\"transform\":"
                               "{\"rotate\":{\"tan_half\":\"t\"}}}]}";
    scene s;
    scene_open(&s, turn, NULL);
    graze_solid *solid;
    graze_scene *made;
    assert_int_equal(
        graze_solid_from_doubles(&solid, s.context, 2, block, 4, square_sizes, 1, square_ring, 0),
        GRAZE_OK);
    assert_int_equal(graze_scene_create(&made, s.context, solid, s.motion, NULL), GRAZE_OK);
    mpq_t p[2], low, high;
    mpz_t c;
    mpq_inits(p[0], p[1], low, high, NULL);
    mpz_init(c);
    mpq_set_ui(p[1], 3, 1);
    graze_trace *trace;
    assert_int_equal(graze_trace_create(&trace, s.context, made, p), GRAZE_OK);
    assert_string_equal(graze_trace_word(trace), "OBI");
    graze_contact contact = graze_trace_contact(trace, 0);
    assert_int_equal(contact.kind, GRAZE_INTERSECTION);
    assert_int_equal(contact.left, GRAZE_STATE_O);
    assert_int_equal(contact.right, GRAZE_STATE_I);
    assert_ptr_equal(contact.from, contact.to);
    assert_int_equal(contact.cell_count, 1);
    assert_int_equal(contact.cells[0].kind, GRAZE_CELL_EDGE);
    assert_int_equal(contact.cells[0].a, 2);
    assert_int_equal(contact.cells[0].b, 3);
    /* 2t^2 - 1; of its roots +-0.7071 the widest dyadic interval around this one alone is (0, 1).
     */
    assert_int_equal(graze_time_degree(contact.from), 2);
    static const long coefficients[] = {-1, 0, 2, 0};
    for (int k = 0; k < 4; k++) {
        graze_time_coefficient(c, contact.from, k);
        assert_int_equal(mpz_get_si(c), coefficients[k]);
    }
    assert_int_equal(graze_time_rational(low, contact.from), 0);
    graze_time_interval(low, high, contact.from);
    assert_int_equal(mpq_cmp_ui(low, 0, 1), 0);
    assert_int_equal(mpq_cmp_ui(high, 1, 1), 0);
    char *decimal;
    assert_int_equal(graze_time_decimal(&decimal, s.context, contact.from, 30), GRAZE_OK);
    assert_string_equal(decimal, "0.707106781186547524400844362105");
    graze_free(decimal);
    assert_int_equal(graze_time_decimal(&decimal, s.context, contact.from, 0), GRAZE_EUSE);
    assert_int_equal(graze_time_decimal(&decimal, s.context, contact.from, 1001), GRAZE_EUSE);
    assert_null(graze_trace_contact(trace, 1).from);
    graze_trace_destroy(trace);
    mpq_clears(p[0], p[1], low, high, NULL);
    mpz_clear(c);
    graze_scene_destroy(made);
    graze_solid_destroy(solid);
    scene_close(&s);
}

static void random_points(double *points, ulong seed) {
    random_start(seed);
    for (int k = 0; k < 2 * MANY; k++)
        points[k] = (double)(draw_below(97) - 8) / 8;
}

/* A point on one eighth steps is exact in both ways, so the verdicts are the same bytes. */
static void doubles_are_exact(void **state) {
    (void)state;
    static double points[2 * MANY];
    static graze_verdict a[MANY], b[MANY];
    mpq_t *exact = malloc(sizeof *exact * 2 * MANY);
    scene s;
    scene_open(&s, slide, NULL);
    random_points(points, 20);
    for (int k = 0; k < 2 * MANY; k++) {
        mpq_init(exact[k]);
        mpq_set_d(exact[k], points[k]);
    }
    assert_int_equal(graze_classify_doubles(a, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
                     GRAZE_OK);
    assert_int_equal(graze_classify(b, s.context, s.scene, exact, MANY, GRAZE_COLUMNS_ALL),
                     GRAZE_OK);
    int seen[4] = {0, 0, 0, 0};
    for (int k = 0; k < MANY; k++) {
        /* The sweep is [0,10] x [0,2], and every one of its inner points is inside some S^t. */
        double x = points[2 * k], y = points[2 * k + 1];
        graze_pmc expected = x < 0 || x > 10 || y < 0 || y > 2   ? GRAZE_OUT
                             : x > 0 && x < 10 && y > 0 && y < 2 ? GRAZE_IN
                                                                 : GRAZE_ON;
        if (a[k].pmc != expected || memcmp(&a[k], &b[k], sizeof a[k]) != 0)
            fail_msg("point %g, %g: %d, %d, expected %d", x, y, a[k].pmc, b[k].pmc, expected);
        seen[expected]++;
    }
    assert_true(seen[GRAZE_IN] && seen[GRAZE_ON] && seen[GRAZE_OUT]);
    points[2 * 3] = NAN;
    assert_int_equal(graze_classify_doubles(a, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
                     GRAZE_EINPUT);
    assert_non_null(strstr(graze_context_message(s.context), "point 3"));
    assert_int_equal(memcmp(a, b, 3 * sizeof *a), 0);
    assert_int_equal(a[3].pmc, GRAZE_PMC_NONE);
    for (int k = 0; k < 2 * MANY; k++)
        mpq_clear(exact[k]);
    free(exact);
    scene_close(&s);
}

static void points_must_be_canonical(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    graze_verdict verdict;
    mpq_t p[2];
    mpq_init(p[0]);
    mpq_init(p[1]);
    mpz_set_ui(mpq_numref(p[1]), 2);
    mpz_set_ui(mpq_denref(p[1]), 4);
    assert_int_equal(graze_classify(&verdict, s.context, s.scene, p, 1, GRAZE_COLUMNS_ALL),
                     GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(s.context), "lowest terms"));
    mpz_set_ui(mpq_denref(p[1]), 0);
    assert_int_equal(graze_classify(&verdict, s.context, s.scene, p, 1, GRAZE_COLUMNS_ALL),
                     GRAZE_EUSE);
    assert_non_null(strstr(graze_context_message(s.context), "point 0, coordinate 1"));
    mpz_set_ui(mpq_denref(p[1]), 1);
    mpz_ui_pow_ui(mpq_numref(p[1]), 10, 20000);
    assert_int_equal(graze_classify(&verdict, s.context, s.scene, p, 1, GRAZE_COLUMNS_ALL),
                     GRAZE_ELIMIT);
    assert_int_equal(verdict.pmc, GRAZE_PMC_NONE);
    mpq_clear(p[0]);
    mpq_clear(p[1]);
    scene_close(&s);
}

static int stop_later(void *data) {
    int *left = data;
    return --*left < 0;
}

/* The verdicts given before the callback asks to stop are exact, the others zeroed. */
static void cancel_keeps_what_is_done(void **state) {
    (void)state;
    static double points[2 * MANY];
    static graze_verdict all[MANY], some[MANY];
    scene s;
    scene_open(&s, slide, NULL);
    random_points(points, 21);
    assert_int_equal(
        graze_classify_doubles(all, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL), GRAZE_OK);
    int left = 100;
    graze_context_set_cancel(s.context, stop_later, &left);
    assert_int_equal(
        graze_classify_doubles(some, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
        GRAZE_ECANCELED);
    assert_non_null(strstr(graze_context_message(s.context), "canceled by the caller"));
    int done = 0;
    while (done < MANY && some[done].pmc)
        done++;
    assert_in_range(done, 1, 100);
    assert_int_equal(memcmp(all, some, (size_t)done * sizeof *all), 0);
    for (int k = done; k < MANY; k++)
        assert_int_equal(some[k].pmc, GRAZE_PMC_NONE);
    graze_context_set_cancel(s.context, NULL, NULL);
    assert_int_equal(
        graze_classify_doubles(some, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
        GRAZE_OK);
    assert_int_equal(memcmp(all, some, sizeof all), 0);
    scene_close(&s);
}

/* The callback is asked once for each point, at its beginning. */
static void cancel_countdown(void **state) {
    (void)state;
    static double points[2 * MANY];
    static graze_verdict some[MANY];
    scene s;
    scene_open(&s, slide, NULL);
    random_points(points, 22);
    int left = MANY;
    graze_context_set_cancel(s.context, graze_cancel_countdown, &left);
    assert_int_equal(
        graze_classify_doubles(some, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
        GRAZE_OK);
    assert_int_equal(left, 0);
    assert_int_equal(
        graze_classify_doubles(some, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
        GRAZE_ECANCELED);
    assert_int_equal(some[0].pmc, GRAZE_PMC_NONE);
    assert_int_equal(graze_cancel_countdown(NULL), 0);
    scene_close(&s);
}

typedef struct job {
    const graze_scene *scene;
    const double *points;
    graze_verdict verdicts[MANY];
    graze_status status;
} job;

static void *work(void *data) {
    job *j = data;
    graze_context *context;
    j->status = graze_context_create(&context);
    if (!j->status)
        j->status = graze_classify_doubles(j->verdicts, context, j->scene, j->points, MANY,
                                           GRAZE_COLUMNS_ALL);
    graze_context_destroy(context);
    graze_thread_finish();
    return NULL;
}

static void threads_share_a_scene(void **state) {
    (void)state;
    static double points[2 * MANY];
    static job jobs[THREADS];
    static graze_verdict alone[MANY];
    pthread_t threads[THREADS];
    scene s;
    scene_open(&s, slide, NULL);
    random_points(points, 22);
    assert_int_equal(
        graze_classify_doubles(alone, s.context, s.scene, points, MANY, GRAZE_COLUMNS_ALL),
        GRAZE_OK);
    for (int k = 0; k < THREADS; k++) {
        jobs[k].scene = s.scene;
        jobs[k].points = points;
        assert_int_equal(pthread_create(&threads[k], NULL, work, &jobs[k]), 0);
    }
    for (int k = 0; k < THREADS; k++) {
        pthread_join(threads[k], NULL);
        assert_int_equal(jobs[k].status, GRAZE_OK);
        assert_int_equal(memcmp(jobs[k].verdicts, alone, sizeof alone), 0);
    }
    scene_close(&s);
}

/* Moved by 4t the square sweeps [0,6] x [0,2]: with dyadic corners the box is that set itself. */
static void box_holds_the_sweep(void **state) {
    (void)state;
    static const char shift[] = "{\"dimension\":2,\"pieces\":[{\"t\":[0,1],\"transform\":"
                                "{\"translate\":[\"4*t\",0]}}]}";
    static const char turn[] = "{\"dimension\":2,\"pieces\":[{\"t\":[0,1],\"transform\":"
                               "{\"rotate\":{\"tan_half\":\"t\"}}}]}";
    scene s;
    mpq_t low[2], high[2];
    mpq_inits(low[0], low[1], high[0], high[1], NULL);
    scene_open(&s, shift, NULL);
    assert_int_equal(graze_scene_box(low, high, s.context, s.scene), GRAZE_OK);
    assert_int_equal(mpq_cmp_ui(low[0], 0, 1) || mpq_cmp_ui(low[1], 0, 1), 0);
    assert_int_equal(mpq_cmp_ui(high[0], 6, 1) || mpq_cmp_ui(high[1], 2, 1), 0);
    scene_close(&s);
    /* A quarter turn about the origin carries (2,2) along a circle of radius sqrt(8): the box is
     * [-2, 2] x [0, sqrt(8)] but for its slack of about 2^-11 of its longest side, 4. */
    scene_open(&s, turn, NULL);
    assert_int_equal(graze_scene_box(low, high, s.context, s.scene), GRAZE_OK);
    assert_true(mpq_get_d(low[0]) <= -2 && mpq_get_d(low[0]) > -2.004);
    assert_true(mpq_get_d(high[0]) >= 2 && mpq_get_d(high[0]) < 2.004);
    assert_true(mpq_get_d(low[1]) <= 0 && mpq_get_d(low[1]) > -0.004);
    mpq_mul(high[1], high[1], high[1]);
    assert_true(mpq_cmp_ui(high[1], 8, 1) >= 0 && mpq_get_d(high[1]) < 8.03);
    scene_close(&s);
    mpq_clears(low[0], low[1], high[0], high[1], NULL);
}

/* [0,2]^2 against its image: touching counts, a gap does not, one inside the other does. */
static void ends_that_meet(void **state) {
    (void)state;
    static const struct {
        const char *transform;
        int meet;
    } cases[] = {
        {"{\"translate\":[\"2*t\",0]}", 1},          {"{\"translate\":[\"2*t\",\"2*t\"]}", 1},
        {"{\"translate\":[\"(2+1/2^60)*t\",0]}", 0}, {"{\"scale\":\"1-t/2\",\"center\":[1,1]}", 1},
        {"{\"scale\":\"1+t\",\"center\":[1,1]}", 1}, {"{\"translate\":[\"t\",\"t\"]}", 1},
        {"{\"translate\":[\"3*t\",\"3*t\"]}", 0},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char motion[256];
        snprintf(motion, sizeof motion,
                 "{\"dimension\":2,\"pieces\":[{\"t\":[0,1],\"transform\":%s}]}",
                 cases[k].transform);
        scene s;
        scene_open(&s, motion, NULL);
        if (graze_scene_ends_meet(s.scene) != cases[k].meet)
            fail_msg("%s: expected %d", cases[k].transform, cases[k].meet);
        graze_options reject = {.size = sizeof reject, .overlap = GRAZE_OVERLAP_REJECT};
        graze_scene *made;
        assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &reject),
                         cases[k].meet ? GRAZE_EILLEGAL : GRAZE_OK);
        graze_scene_destroy(made);
        reject.operation = GRAZE_UNSWEEP;
        assert_int_equal(graze_scene_create(&made, s.context, s.solid, s.motion, &reject),
                         GRAZE_OK);
        graze_scene_destroy(made);
        scene_close(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_examples),          cmocka_unit_test(long_products_cancel),
        cmocka_unit_test(irrational_time),          cmocka_unit_test(doubles_are_exact),
        cmocka_unit_test(points_must_be_canonical), cmocka_unit_test(cancel_keeps_what_is_done),
        cmocka_unit_test(cancel_countdown),         cmocka_unit_test(threads_share_a_scene),
        cmocka_unit_test(box_holds_the_sweep),      cmocka_unit_test(ends_that_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
