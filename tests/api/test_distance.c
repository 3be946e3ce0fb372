/* Enclosures of the distance to the sweep against closed forms, and laws they obey.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The solid is the square [0, 2]^2. Derivations stand beside the rows.
 */
#include "walk.h"

#define MOTION(transform)                                                                          \
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": " transform "}]}"
static const char turn[] = MOTION("{\"turn\": {\"quarters\": 1}}");
static const char grow[] = MOTION("{\"scale\": \"1+t\"}");
static const char lean[] = MOTION("{\"matrix\": [[1, \"t\", 0], [0, 1, 0]]}");
static const char step[] = MOTION("{\"translate\": [\"t\", 0]}");
static const char flat[] = MOTION("{\"scale\": [\"1+t\", \"1/(1+t)\"]}");

/* The centred square [-f, f]^2 with f from about 1e-9 to 1: the weight's values lie far apart. */
static const char burst[] =
    MOTION("{\"matrix\": [[\"13841287203/(12157665459056928801*(1-t)+13841287203*t)\", 0, "
           "\"-13841287203/(12157665459056928801*(1-t)+13841287203*t)\"],"
           "[0, \"13841287203/(12157665459056928801*(1-t)+13841287203*t)\", "
           "\"-13841287203/(12157665459056928801*(1-t)+13841287203*t)\"]]}");
/* The square on its corner (2, 2), which passes y = 0 at (8t - 4, 0). */
static const char tip[] = MOTION("{\"matrix\": [[1, -1, \"8*t-4\"], [1, 1, -4]]}");

typedef struct row {
    const char *motion;
    graze_operation operation;
    double x, y;
    graze_pmc pmc;
    double s;    /* the distance, correctly rounded but for an ulp */
    double time; /* the one time at which it is met; -1: several */
} row;

#define ROOT2 1.4142135623730951

static const row rows[] = {
    /* The sweep is [0, 10] x [0, 2], the pose at t is [8t, 8t + 2] x [0, 2]. */
    {slide, GRAZE_SWEEP, 5, 3, GRAZE_OUT, 1, -1},
    {slide, GRAZE_SWEEP, 13, 6, GRAZE_OUT, 5, 1},      /* to (10, 2): 3, 4, 5 */
    {slide, GRAZE_SWEEP, -3, 1, GRAZE_OUT, 3, 0},      /* to x = 0 */
    {slide, GRAZE_SWEEP, 5, 1, GRAZE_IN, -1, 0.5},     /* centre of the pose [4, 6] x [0, 2] */
    {slide, GRAZE_SWEEP, 5, 0.5, GRAZE_IN, -0.5, -1},  /* to y = 0, while that side is nearest */
    {slide, GRAZE_SWEEP, 0.25, 1, GRAZE_IN, -0.25, 0}, /* the left side comes nearer at once */
    {slide, GRAZE_SWEEP, 5, 2, GRAZE_ON, 0, -1},
    /* The pose at the angle a holds directions from a to a + 90 degrees about the corner (0, 0). */
    {turn, GRAZE_SWEEP, 0, 4, GRAZE_OUT, 4 - 2 * ROOT2, -1}, /* the corner (2, 2) passes below */
    {turn, GRAZE_SWEEP, 0, -5, GRAZE_OUT, 5, -1}, /* the corner (0, 0) is nearest all the time */
    {turn, GRAZE_SWEEP, -1, -3, GRAZE_OUT, 3, 1}, /* the last pose [-2, 0] x [0, 2] */
    {turn, GRAZE_SWEEP, 0, 1, GRAZE_IN, -ROOT2 / 2, -1}, /* min(sin a, cos a) at 45 degrees */
    /* The pose at t is [0, 2 + 2t]^2. */
    {grow, GRAZE_SWEEP, 5, 5, GRAZE_OUT, ROOT2, 1}, /* to (4, 4) */
    {grow, GRAZE_SWEEP, 3, 3, GRAZE_IN, -1, 1},     /* to x = 4 */
    {grow, GRAZE_SWEEP, 1, 1, GRAZE_IN, -1, -1},    /* to x = 0 */
    /* The right side runs from (2, 0) to (2 + 2t, 2): 1 / sqrt(1 + t^2) from (3, 0). */
    {lean, GRAZE_SWEEP, 3, 0, GRAZE_OUT, ROOT2 / 2, 1},
    /* The pose at t is [0, 2 + 2t] x [0, 2 / (1 + t)]. */
    {flat, GRAZE_SWEEP, 1, 3, GRAZE_OUT, 1, 0},                    /* to y = 2, highest at first */
    {flat, GRAZE_SWEEP, 3, 2, GRAZE_OUT, 0.59886639721239785, -1}, /* corner: a = 1 + t,
        2a^4 - 3a^3 + 2a - 2 = 0, a = 1.35712364..., sqrt((2a - 3)^2 + (2 - 2/a)^2) */
    /* The unsweep is [0, 1] x [0, 2], the set at t is [-t, 2 - t] x [0, 2]. */
    {step, GRAZE_UNSWEEP, 0.25, 1, GRAZE_IN, -0.25, 0},
    {step, GRAZE_UNSWEEP, 3, 1, GRAZE_OUT, 2, 1},
    {step, GRAZE_UNSWEEP, 1, 1, GRAZE_ON, 0, 1},
};

static graze_enclosure ask(const scene *s, double x, double y, double tolerance) {
    const double point[2] = {x, y};
    graze_enclosure e;
    assert_int_equal(graze_distances_doubles(&e, s->context, s->scene, point, 1, tolerance),
                     GRAZE_OK);
    return e;
}

static void check_sign(const graze_enclosure *e) {
    if (e->pmc == GRAZE_OUT)
        assert_true(e->low >= 0 && e->high > 0);
    else if (e->pmc == GRAZE_IN)
        assert_true(e->low < 0 && e->high <= 0);
    else
        assert_true(e->low == 0 && e->high == 0);
}

static void check_row(const row *r, double tolerance) {
    scene s;
    graze_options options = {.size = sizeof options, .operation = r->operation};
    scene_open(&s, r->motion, &options);
    graze_enclosure e = ask(&s, r->x, r->y, tolerance);
    assert_int_equal(e.pmc, r->pmc);
    check_sign(&e);
    double ulps = 0x1p-51 * fabs(r->s);
    if (!(e.low <= r->s + ulps && r->s - ulps <= e.high && e.high - e.low <= tolerance && !e.wide))
        fail_msg("(%g, %g) at %g: [%.17g, %.17g], expected %.17g", r->x, r->y, tolerance, e.low,
                 e.high, r->s);
    if (r->time >= 0 && !(fabs(e.time - r->time) <= 4 * tolerance))
        fail_msg("(%g, %g): time %g, expected %g", r->x, r->y, e.time, r->time);
    scene_close(&s);
}

static void closed_forms(void **state) {
    (void)state;
    const double tolerances[] = {1e-1, 1e-3, 1e-6, 1e-9, 2e-12};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        for (size_t j = 0; j < sizeof tolerances / sizeof *tolerances; j++)
            check_row(&rows[k], tolerances[j]);
}

/* Points on a line across a scene: |s(P) - s(Q)| <= |P - Q| for all pairs of neighbours. */
static void lipschitz(void **state) {
    (void)state;
    const char *motions[] = {slide, turn, grow, lean, flat};
    for (size_t m = 0; m < sizeof motions / sizeof *motions; m++) {
        scene s;
        scene_open(&s, motions[m], NULL);
        graze_enclosure before = ask(&s, -3, -2, 1e-7);
        for (int k = 1; k <= 120; k++) {
            graze_enclosure e = ask(&s, -3 + k / 16.0, -2 + k / 32.0, 1e-7);
            double step_length = hypot(1 / 16.0, 1 / 32.0);
            check_sign(&e);
            assert_true(e.low - before.high <= step_length && before.low - e.high <= step_length);
            before = e;
        }
        scene_close(&s);
    }
}

/* Largest at t = 1, where the sides are 1 from the centre. */
static void weights_far_apart(void **state) {
    (void)state;
    scene s;
    scene_open(&s, burst, NULL);
    graze_enclosure e = ask(&s, 0, 0, 1e-9);
    check_sign(&e);
    if (!(e.low <= -1 && -1 <= e.high))
        fail_msg("[%.17g, %.17g], expected -1 inside", e.low, e.high);
    scene_close(&s);
}

/* The point is inside for 2^-72 about t = (0.3 + 4) / 8, which no double is near enough to. */
static void stay_between_doubles(void **state) {
    (void)state;
    scene s;
    scene_open(&s, tip, NULL);
    graze_enclosure e = ask(&s, 0.3, -0x1p-70, 1e-9);
    assert_int_equal(e.pmc, GRAZE_IN);
    check_sign(&e);
    assert_true(e.low <= -0x1p-71 && e.high >= -0x1p-71 && fabs(e.time - 4.3 / 8) <= 0x1p-50);
    scene_close(&s);
}

static int overlap(graze_enclosure a, graze_enclosure b) {
    return a.low <= b.high && b.low <= a.high && a.pmc == b.pmc;
}

/* One set swept in another order, with another parameter, or with the motion cut: distances agree.
 */
static void same_sets(void **state) {
    (void)state;
    static const char *const same[][2] = {
        {slide, MOTION("{\"translate\": [\"8*(1-t)\", 0]}")},
        {slide, MOTION("{\"translate\": [\"8*t^3\", 0]}")},
        {slide,
         "{\"dimension\": 2, \"pieces\": [{\"t\": [0, \"1/3\"], \"transform\": {\"translate\": "
         "[\"8*t\", 0]}}, {\"t\": [\"1/3\", 1], \"transform\": {\"translate\": [\"8*t\", 0]}}]}"},
        {turn, MOTION("{\"rotate\": {\"tan_half\": \"1-t\"}}")},
        {turn, MOTION("{\"rotate\": {\"tan_half\": \"t^2\"}}")},
        {grow, MOTION("{\"scale\": \"2-t\"}")},
        {lean, MOTION("{\"matrix\": [[1, \"1-t^2\", 0], [0, 1, 0]]}")},
    };
    for (size_t m = 0; m < sizeof same / sizeof *same; m++) {
        scene a, b;
        scene_open(&a, same[m][0], NULL);
        scene_open(&b, same[m][1], NULL);
        for (int k = 0; k < 100; k++) {
            double x = -3 + (k % 10) * 1.3, y = -3 + (k / 10) * 0.9;
            if (!overlap(ask(&a, x, y, 1e-8), ask(&b, x, y, 1e-8)))
                fail_msg("motions %zu at (%.17g, %.17g)", m, x, y);
        }
        scene_close(&a);
        scene_close(&b);
    }
}

/* A turn of the world by the angle whose tangent is 3/4. */
static void rigid_maps(void **state) {
    (void)state;
    static const char turned[] =
        MOTION("{\"compose\": [{\"translate\": [\"8*t\", 0]}, {\"matrix\": "
               "[[\"4/5\", \"-3/5\", 1], [\"3/5\", \"4/5\", 2]]}]}");
    scene a, b;
    scene_open(&a, slide, NULL);
    scene_open(&b, turned, NULL);
    for (int k = 0; k < 200; k++) {
        double x = -2 + (k % 20) * 0.75, y = -2 + (k / 20) * 0.625;
        graze_enclosure e = ask(&a, x, y, 1e-9), f;
        mpq_t p[2];
        mpq_inits(p[0], p[1], NULL);
        /* x and y are eighths, so 5 times the image is whole in eighths */
        mpq_set_si(p[0], (long)(8 * (4 * x - 3 * y + 5)), 40);
        mpq_set_si(p[1], (long)(8 * (3 * x + 4 * y + 10)), 40);
        mpq_canonicalize(p[0]);
        mpq_canonicalize(p[1]);
        assert_int_equal(graze_distances(&f, b.context, b.scene, p, 1, 1e-9), GRAZE_OK);
        assert_true(overlap(e, f));
        mpq_clears(p[0], p[1], NULL);
    }
    scene_close(&a);
    scene_close(&b);
}

/* Powers of two scale every number of the search. */
static void scaling(void **state) {
    (void)state;
    static const char far[] = MOTION("{\"compose\": [{\"scale\": 1024}, {\"translate\": "
                                     "[\"8192*t\", 0]}]}");
    scene a, b;
    scene_open(&a, slide, NULL);
    scene_open(&b, far, NULL);
    for (int k = 0; k < 200; k++) {
        double x = -2 + (k % 20) * 0.7, y = -2 + (k / 20) * 0.6;
        graze_enclosure e = ask(&a, x, y, 1e-6), f = ask(&b, 1024 * x, 1024 * y, 1024e-6);
        assert_true(overlap((graze_enclosure){1024 * e.low, 1024 * e.high, 0, e.pmc, 0}, f));
        assert_true(f.high - f.low <= 1024e-6);
    }
    scene_close(&a);
    scene_close(&b);
}

static void refusals(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    const double point[4] = {5, 3, 1e80, 1};
    const double bad[] = {0, -1, (double)INFINITY, (double)NAN};
    graze_enclosure e[2];
    for (size_t k = 0; k < 4; k++)
        assert_int_equal(graze_distances_doubles(e, s.context, s.scene, point, 1, bad[k]),
                         GRAZE_EUSE);
    assert_int_equal(graze_distances_doubles(NULL, s.context, s.scene, point, 1, 1), GRAZE_EUSE);
    assert_int_equal(graze_distances(e, s.context, NULL, NULL, 0, 1), GRAZE_EUSE);
    assert_int_equal(graze_distances_doubles(e, s.context, s.scene, point, 2, 1), GRAZE_ELIMIT);
    assert_true(e[0].low <= 1 && e[0].high >= 1 && e[1].pmc == GRAZE_PMC_NONE);
    double diagonal = 0;
    assert_int_equal(graze_scene_diagonal(&diagonal, s.context, s.scene), GRAZE_OK);
    assert_true(diagonal <= 2 * ROOT2 && diagonal >= 2 * ROOT2 * (1 - 0x1p-51));
    assert_int_equal(graze_scene_diagonal(NULL, s.context, s.scene), GRAZE_EUSE);
    e[0] = ask(&s, 5, 3, 1e-300); /* less than doubles resolve */
    assert_true(e[0].wide && e[0].low <= 1 && e[0].high >= 1 && e[0].high - e[0].low < 1e-12);
    double width = 7;
    assert_int_equal(graze_scene_width(&width, s.context, s.scene, 1e308), GRAZE_ELIMIT);
    assert_true(width == 7);
    assert_int_equal(graze_scene_width(&width, s.context, s.scene, 0.25), GRAZE_OK);
    assert_true(width < diagonal / 4 && width >= diagonal / 4 * (1 - 0x1p-52));
    scene_close(&s);
}

/* A call that is canceled at any of its questions leaves nothing behind, and the next one answers.
 */
static void canceled_anywhere(void **state) {
    (void)state;
    const double point[2] = {3, -2};
    graze_status status = GRAZE_ECANCELED;
    int calls = 0;
    for (; status == GRAZE_ECANCELED; calls++) {
        scene s;
        graze_enclosure e, again;
        int left = calls + 1;
        scene_open(&s, burst, NULL);
        graze_context_set_cancel(s.context, graze_cancel_countdown, &left);
        status = graze_distances_doubles(&e, s.context, s.scene, point, 1, 1e-3);
        graze_context_set_cancel(s.context, NULL, NULL);
        again = ask(&s, point[0], point[1], 1e-3);
        assert_int_equal(again.pmc, GRAZE_OUT);
        scene_close(&s);
    }
    assert_int_equal(status, GRAZE_OK);
    assert_true(calls > 8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_forms),      cmocka_unit_test(lipschitz),
        cmocka_unit_test(weights_far_apart), cmocka_unit_test(stay_between_doubles),
        cmocka_unit_test(same_sets),         cmocka_unit_test(rigid_maps),
        cmocka_unit_test(scaling),           cmocka_unit_test(refusals),
        cmocka_unit_test(canceled_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
