/* Memberships of grids: those of the points alone, whatever is asked for in which order, and
 * refusals. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The sweep of the square [0, 2]^2 by slide is [0, 10] x [0, 2], the unsweep by step [1/2, 2] x [0,
 * 2].
 */
#include "walk.h"

#include <pthread.h>
#include <stdlib.h>

static const char step[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                           "{\"translate\": [\"-t/2\", 0]}}]}";
enum { WIDE = 97, HIGH = 83, ALL = WIDE * HIGH };
static const size_t sizes[] = {WIDE, HIGH};

typedef struct plane_grid {
    scene s;
    graze_grid *grid;
    mpq_t low[2], high[2];
} plane_grid;

/* A grid of the sizes above over a box: low x, low y, high x, high y. */
static void grid_over(plane_grid *g, const char *motion, graze_operation operation,
                      const int box[4]) {
    graze_options options = {.size = sizeof options, .operation = operation};
    scene_open(&g->s, motion, &options);
    for (int k = 0; k < 2; k++) {
        mpq_inits(g->low[k], g->high[k], NULL);
        mpq_set_si(g->low[k], box[k], 1);
        mpq_set_si(g->high[k], box[2 + k], 1);
    }
    assert_int_equal(graze_grid_create(&g->grid, g->s.context, g->s.scene, sizes, g->low, g->high),
                     GRAZE_OK);
}

/* From (-1, -1) to (11, 3): its lines are multiples of 1/8 and of 2/41. */
static void grid_open(plane_grid *g, const char *motion, graze_operation operation) {
    grid_over(g, motion, operation, (const int[]){-1, -1, 11, 3});
}

static void grid_close(plane_grid *g) {
    graze_grid_destroy(g->grid);
    for (int k = 0; k < 2; k++)
        mpq_clears(g->low[k], g->high[k], NULL);
    scene_close(&g->s);
}

/* Where (i, j) is relative to [0, x] x [0, 2] or [1/2, 2] x [0, 2]: the point is (i/8 - 1, 2j/41 -
 * 1). */
static graze_pmc expected(size_t i, size_t j, int sweep) {
    long eighths = (long)i - 8, parts = 2 * (long)j - 41, low = sweep ? 0 : 4,
         high = sweep ? 80 : 16;
    if (eighths < low || eighths > high || parts < 0 || parts > 82)
        return GRAZE_OUT;
    return eighths == low || eighths == high || parts == 0 || parts == 82 ? GRAZE_ON : GRAZE_IN;
}

static void whole_grids(void **state) {
    (void)state;
    for (int sweep = 0; sweep < 2; sweep++) {
        plane_grid g;
        unsigned char pmc[ALL];
        grid_open(&g, sweep ? slide : step, sweep ? GRAZE_SWEEP : GRAZE_UNSWEEP);
        assert_int_equal(graze_grid_count(g.grid), ALL);
        assert_int_equal(graze_grid_pmc(pmc, g.s.context, g.grid, 0, 1, ALL), GRAZE_OK);
        for (size_t p = 0; p < ALL; p++)
            if (pmc[p] != expected(p % WIDE, p / WIDE, sweep))
                fail_msg("point %zu: %d, expected %d", p, pmc[p],
                         expected(p % WIDE, p / WIDE, sweep));
        grid_close(&g);
    }
}

/* Backwards, in steps, and without the filter. */
static void any_order(void **state) {
    (void)state;
    plane_grid g;
    grid_open(&g, slide, GRAZE_SWEEP);
    for (int exact = 0; exact < 2; exact++) {
        graze_context_set_filter(g.s.context, !exact);
        for (size_t first = ALL; first-- > 0;) {
            unsigned char pmc[3] = {0, 0, 0};
            size_t count = first % 3 + 1, stride = first % 501 + 1;
            if (first + (count - 1) * stride >= ALL || first % (exact ? 97 : 7))
                continue;
            assert_int_equal(graze_grid_pmc(pmc, g.s.context, g.grid, first, stride, count),
                             GRAZE_OK);
            for (size_t k = 0; k < count; k++) {
                size_t p = first + k * stride;
                assert_int_equal(pmc[k], expected(p % WIDE, p / WIDE, 1));
            }
        }
    }
    grid_close(&g);
}

static void points_and_rows(void **state) {
    (void)state;
    plane_grid g;
    mpq_t point[4];
    char *rows = NULL;
    size_t length, done;
    grid_open(&g, slide, GRAZE_SWEEP);
    for (int k = 0; k < 4; k++)
        mpq_init(point[k]);
    graze_grid_points(point, g.grid, 9, WIDE * 42, 2); /* (1/8, -1) and (1/8, 43/41) */
    assert_true(mpq_cmp_si(point[0], 1, 8) == 0 && mpq_cmp_si(point[1], -1, 1) == 0);
    assert_true(mpq_cmp_si(point[2], 1, 8) == 0 && mpq_cmp_si(point[3], 43, 41) == 0);
    assert_int_equal(graze_grid_rows(&rows, &length, &done, g.s.context, g.grid, 9, WIDE * 42, 2,
                                     GRAZE_FORMAT_CSV),
                     GRAZE_OK);
    assert_string_equal(rows, "1/8,-1,out\n1/8,43/41,in\n");
    assert_int_equal(length, strlen(rows));
    assert_int_equal(done, 2);
    graze_free(rows);
    assert_int_equal(
        graze_grid_rows(&rows, &length, &done, g.s.context, g.grid, 9, 1, 0, GRAZE_FORMAT_CSV),
        GRAZE_OK);
    assert_true(rows == NULL && length == 0 && done == 0);
    mpq_set_si(point[0], 5, 1);
    graze_grid_points(point, g.grid, ALL, 1, 1);
    assert_true(mpq_cmp_si(point[0], 5, 1) == 0);
    for (int k = 0; k < 4; k++)
        mpq_clear(point[k]);
    grid_close(&g);
}

typedef struct share {
    graze_grid *grid;
    unsigned char *pmc;
    size_t first;
} share;

enum { THREADS = 4 };

/* Every fourth row of the grid. */
static void *take_share(void *data) {
    share *s = data;
    graze_context *context = NULL;
    if (graze_context_create(&context) == GRAZE_OK)
        for (size_t row = s->first; row < HIGH; row += THREADS)
            if (graze_grid_pmc(s->pmc + row * WIDE, context, s->grid, row * WIDE, 1, WIDE))
                break;
    graze_context_destroy(context);
    graze_thread_finish();
    return NULL;
}

static void threads(void **state) {
    (void)state;
    plane_grid g;
    unsigned char pmc[ALL] = {0};
    pthread_t thread[THREADS];
    share shares[THREADS];
    grid_open(&g, slide, GRAZE_SWEEP);
    for (size_t k = 0; k < THREADS; k++) {
        shares[k] = (share){g.grid, pmc, k};
        assert_int_equal(pthread_create(&thread[k], NULL, take_share, &shares[k]), 0);
    }
    for (size_t k = 0; k < THREADS; k++)
        pthread_join(thread[k], NULL);
    for (size_t p = 0; p < ALL; p++)
        assert_int_equal(pmc[p], expected(p % WIDE, p / WIDE, 1));
    grid_close(&g);
}

static int stop(void *data) {
    ++*(int *)data;
    return 1;
}

/* Where all points go one way, and are decided together, it is asked too. */
static void cancel(void **state) {
    (void)state;
    plane_grid g;
    unsigned char pmc[ALL];
    int asked = 0;
    grid_over(&g, slide, GRAZE_SWEEP, (const int[]){20, 20, 30, 30});
    graze_context_set_cancel(g.s.context, stop, &asked);
    assert_int_equal(graze_grid_pmc(pmc, g.s.context, g.grid, 0, 1, ALL), GRAZE_ECANCELED);
    assert_int_equal(asked, 1);
    for (size_t p = 0; p < ALL; p++)
        assert_int_equal(pmc[p], 0);
    grid_close(&g);
}

/* (x, 0), 0 <= x <= 2, touches at t = (3 +- sqrt(2)) / 32 alone, which more than one bit tells
 * apart: what stands behind the first such point is 0. */
static void limits(void **state) {
    (void)state;
    static const char twice[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {"
                                "\"translate\": [0, \"((32*t-3)^2-2)^2/500000\"]}}]}";
    plane_grid g;
    unsigned char pmc[ALL];
    size_t failed = 41 * WIDE + 8;
    grid_over(&g, twice, GRAZE_SWEEP, (const int[]){-1, -41, 11, 41});
    assert_int_equal(graze_context_set_limit(g.s.context, GRAZE_LIMIT_BITS, 1), GRAZE_OK);
    assert_int_equal(graze_grid_pmc(pmc, g.s.context, g.grid, 0, 1, ALL), GRAZE_ELIMIT);
    for (size_t p = 0; p < ALL; p++)
        assert_int_equal(pmc[p] != 0, p < failed);
    grid_close(&g);
}

static void refusals(void **state) {
    (void)state;
    plane_grid g;
    graze_grid *other;
    unsigned char pmc[2] = {7, 7};
    const size_t one[] = {1, 5}, many[] = {50, 50};
    grid_open(&g, slide, GRAZE_SWEEP);
    graze_context *c = g.s.context;
    assert_int_equal(graze_grid_create(NULL, c, g.s.scene, sizes, g.low, g.high), GRAZE_EUSE);
    assert_int_equal(graze_grid_create(&other, c, g.s.scene, NULL, g.low, g.high), GRAZE_EUSE);
    assert_int_equal(graze_grid_create(&other, c, g.s.scene, one, g.low, g.high), GRAZE_EUSE);
    assert_int_equal(graze_grid_create(&other, c, g.s.scene, sizes, g.high, g.low), GRAZE_EUSE);
    assert_null(other);
    assert_int_equal(graze_context_set_limit(c, GRAZE_LIMIT_GRID, 2499), GRAZE_OK);
    assert_int_equal(graze_grid_create(&other, c, g.s.scene, many, g.low, g.high), GRAZE_ELIMIT);
    assert_int_equal(graze_grid_pmc(NULL, c, g.grid, 0, 1, 2), GRAZE_EUSE);
    assert_int_equal(graze_grid_pmc(pmc, c, g.grid, ALL - 1, 1, 2), GRAZE_EUSE);
    assert_int_equal(graze_grid_pmc(pmc, c, g.grid, 0, 0, 2), GRAZE_EUSE);
    assert_int_equal(graze_grid_pmc(pmc, c, NULL, 0, 1, 2), GRAZE_EUSE);
    assert_int_equal(pmc[0], 7);
    assert_int_equal(graze_grid_rows(NULL, NULL, NULL, c, g.grid, 0, 1, 2, GRAZE_FORMAT_CSV),
                     GRAZE_EUSE);
    assert_int_equal(graze_grid_count(NULL), 0);
    graze_grid_destroy(NULL);
    grid_close(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_grids),     cmocka_unit_test(any_order),
        cmocka_unit_test(points_and_rows), cmocka_unit_test(threads),
        cmocka_unit_test(cancel),          cmocka_unit_test(limits),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
