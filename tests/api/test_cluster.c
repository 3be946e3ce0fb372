/* A motion of few bytes whose contacts are 10^-620 apart, through the public functions: the
 * answer, the exact times, and the cancel callback at every stage.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"
#include <time.h>

/* With f = x^60 - 2 (10^20 x - 1)^2 the point (0, 1) is inside where -2 < f < 0. f is -2 at 0, is
 * positive between two roots on either side of 10^-20 only, is -2 again just before 2 10^-20, and
 * less from there to 1. */
static const char cluster[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                              "{\"translate\": [\"t^60-2*(10^20*t-1)^2\", 0]}}]}";

typedef struct patience {
    size_t polls, allowed;
    double longest, last; /* seconds of this thread between two polls */
} patience;

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int ask(void *data) {
    patience *p = data;
    double now = seconds();
    p->longest = now - p->last > p->longest ? now - p->last : p->longest;
    p->last = now;
    return ++p->polls > p->allowed;
}

static graze_status classify(graze_verdict *out, scene *s, patience *p) {
    static const double point[] = {0, 1};
    p->polls = 0;
    p->longest = 0;
    p->last = seconds();
    return graze_classify_doubles(out, s->context, s->scene, point, 1, GRAZE_COLUMNS_ALL);
}

static graze_status trace_and_report(scene *s, patience *p) {
    mpq_t point[2];
    mpq_init(point[0]);
    mpq_init(point[1]);
    mpq_set_ui(point[1], 1, 1);
    p->polls = 0;
    p->last = seconds();
    graze_trace *trace;
    char *row = NULL;
    graze_status status = graze_trace_create(&trace, s->context, s->scene, point);
    if (!status) {
        assert_string_equal(graze_trace_word(trace), "BIBOBIBO");
        status = graze_report_row(&row, s->context, s->scene, point, trace, NULL, &as_jsonl);
    }
    assert_true((status == GRAZE_OK) == (row != NULL));
    graze_free(row);
    graze_trace_destroy(trace);
    mpq_clear(point[0]);
    mpq_clear(point[1]);
    return status;
}

static void answers_and_is_cancelled(void **state) {
    (void)state;
    scene s;
    patience p = {.allowed = SIZE_MAX};
    graze_verdict v;
    scene_open(&s, cluster, NULL);
    graze_context_set_cancel(s.context, ask, &p);
    assert_int_equal(classify(&v, &s, &p), GRAZE_OK);
    assert_int_equal(v.class_, GRAZE_FOLD);
    assert_int_equal(v.i, 4);
    size_t all = p.polls;
    printf("%zu polls, at most %.3f s of CPU time apart\n", all, p.longest);
    assert_true(all >= 15);
    for (p.allowed = 0; p.allowed + 1 < all; p.allowed++) {
        assert_int_equal(classify(&v, &s, &p), GRAZE_ECANCELED);
        assert_int_equal(v.class_, GRAZE_CLASS_NONE);
    }
    scene_close(&s);
}

static void exact_times_are_cancelled(void **state) {
    (void)state;
    scene s;
    patience p = {.allowed = SIZE_MAX};
    scene_open(&s, cluster, NULL);
    graze_context_set_cancel(s.context, ask, &p);
    assert_int_equal(trace_and_report(&s, &p), GRAZE_OK);
    size_t all = p.polls;
    printf("%zu polls, at most %.3f s of CPU time apart\n", all, p.longest);
    assert_true(all >= 30);
    for (p.allowed = all - 2; p.allowed > 0; p.allowed -= 1 + p.allowed / 4)
        assert_int_equal(trace_and_report(&s, &p), GRAZE_ECANCELED);
    scene_close(&s);
}

/* The times are 2^(1/2) 10^-620 apart, which takes about 2060 binary places. */
static void limit_is_told(void **state) {
    (void)state;
    scene s;
    patience p = {.allowed = SIZE_MAX};
    graze_verdict v;
    scene_open(&s, cluster, NULL);
    assert_int_equal(graze_context_limit(s.context, GRAZE_LIMIT_BITS), 100000);
    assert_int_equal(graze_context_set_limit(s.context, GRAZE_LIMIT_BITS, 2000), GRAZE_OK);
    assert_int_equal(classify(&v, &s, &p), GRAZE_ELIMIT);
    assert_int_equal(v.class_, GRAZE_CLASS_NONE);
    assert_non_null(strstr(graze_context_message(s.context), "the limit bits="));
    assert_int_equal(graze_context_set_limit(s.context, GRAZE_LIMIT_BITS, 2150), GRAZE_OK);
    assert_int_equal(classify(&v, &s, &p), GRAZE_OK);
    scene_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_and_is_cancelled),
        cmocka_unit_test(exact_times_are_cancelled),
        cmocka_unit_test(limit_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
