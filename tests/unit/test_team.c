/* Teams: every index is worked on once, the failure told is the first by index for any number of
 * threads, and a cancel of the caller's context ends all.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <sched.h>
#include <stdlib.h>
#include "../lib/harness.h"
#include "base/context/team.h"

enum { INDICES = 20000, MEMBERS = 7 };
static const unsigned long LIMIT = 4321; /* that every member's context must have */

typedef struct tally {
    int done[INDICES];
    size_t by[MEMBERS]; /* indices by member */
    size_t fails_from;  /* every third index from here on fails */
    int waits, failed;  /* atomic: whether the caller's thread waits until another one failed, and
                           whether one did */
} tally;

static graze_status count_index(void *data, graze_context *context, int member, size_t index) {
    tally *t = data;
    t->done[index]++;
    t->by[member]++;
    if (graze_context_limit(context, GRAZE_LIMIT_BITS) != LIMIT)
        return context_fail(context, GRAZE_EINTERNAL, "another limit");
    while (member == 0 && t->waits && !__atomic_load_n(&t->failed, __ATOMIC_RELAXED))
        sched_yield();
    if (index >= t->fails_from && (index - t->fails_from) % 3 == 0) {
        __atomic_store_n(&t->failed, 1, __ATOMIC_RELAXED);
        return context_fail(context, GRAZE_ELIMIT, "index %zu failed", index);
    }
    return context_poll(context);
}

/* One run of a team, and what it leaves. */
typedef struct trial {
    graze_context *context;
    tally *tally;
    graze_status status;
} trial;

static trial run_trial(int threads, size_t fails_from, int waits, int *left) {
    trial out = {.tally = calloc(1, sizeof *out.tally)};
    assert_int_equal(graze_context_create(&out.context), GRAZE_OK);
    assert_int_equal(graze_context_set_limit(out.context, GRAZE_LIMIT_BITS, LIMIT), GRAZE_OK);
    if (left)
        graze_context_set_cancel(out.context, graze_cancel_countdown, left);
    out.tally->fails_from = fails_from;
    out.tally->waits = waits;
    out.status = team_run(out.context, threads, INDICES, count_index, out.tally);
    return out;
}

static void trial_clear(trial *t) {
    free(t->tally);
    graze_context_destroy(t->context);
}

static void test_once_each(void **state) {
    (void)state;
    for (int threads = 0; threads <= MEMBERS; threads++) {
        trial t = run_trial(threads, INDICES, 0, NULL);
        size_t sum = 0;
        assert_int_equal(t.status, GRAZE_OK);
        for (size_t k = 0; k < INDICES; k++)
            assert_int_equal(t.tally->done[k], 1);
        for (int m = 0; m < MEMBERS; m++)
            sum += t.tally->by[m];
        assert_int_equal(sum, INDICES);
        trial_clear(&t);
    }
}

static void test_first_failure(void **state) {
    (void)state;
    for (int round = 0; round < 200; round++) {
        int threads = 1 + round % MEMBERS;
        trial t = run_trial(threads, 100, threads > 1 && round % 2, NULL);
        assert_int_equal(t.status, GRAZE_ELIMIT);
        assert_string_equal(graze_context_message(t.context), "index 100 failed");
        assert_int_equal(t.tally->done[INDICES - 1], 0);
        trial_clear(&t);
    }
}

static void test_cancel(void **state) {
    (void)state;
    for (int threads = 1; threads <= MEMBERS; threads++) {
        int left = 0;
        trial t = run_trial(threads, INDICES, 0, &left);
        /* the others may have taken all before the caller took one */
        assert_true(t.status == GRAZE_ECANCELED || (t.status == GRAZE_OK && !t.tally->by[0]));
        trial_clear(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_once_each),
                                       cmocka_unit_test(test_first_failure),
                                       cmocka_unit_test(test_cancel)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
