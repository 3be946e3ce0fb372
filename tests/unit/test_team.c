/* Teams: every index is worked on once, the failure told is the first by index for any number of
 * threads, and a cancel of the caller's context ends all.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdlib.h>
#include "../lib/harness.h"
#include "base/context/team.h"

enum { INDICES = 20000, MEMBERS = 7 };

typedef struct tally {
    int done[INDICES];
    size_t by[MEMBERS];  /* indices by member */
    size_t fails_from;   /* every third index from here on fails */
    unsigned long limit; /* that every member's context must have */
} tally;

static graze_status count_index(void *data, graze_context *context, int member, size_t index) {
    tally *t = data;
    t->done[index]++;
    t->by[member]++;
    if (graze_context_limit(context, GRAZE_LIMIT_BITS) != t->limit)
        return context_fail(context, GRAZE_EINTERNAL, "another limit");
    if (index >= t->fails_from && (index - t->fails_from) % 3 == 0)
        return context_fail(context, GRAZE_ELIMIT, "index %zu failed", index);
    return context_poll(context);
}

static void test_once_each(void **state) {
    (void)state;
    for (int threads = 0; threads <= MEMBERS; threads++) {
        graze_context *context = NULL;
        tally *t = calloc(1, sizeof *t);
        size_t sum = 0;
        assert_int_equal(graze_context_create(&context), GRAZE_OK);
        assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_BITS, 4321), GRAZE_OK);
        t->fails_from = INDICES;
        t->limit = 4321;
        assert_int_equal(team_run(context, threads, INDICES, count_index, t), GRAZE_OK);
        for (size_t k = 0; k < INDICES; k++)
            assert_int_equal(t->done[k], 1);
        for (int m = 0; m < MEMBERS; m++)
            sum += t->by[m];
        assert_int_equal(sum, INDICES);
        free(t);
        graze_context_destroy(context);
    }
}

static void test_first_failure(void **state) {
    (void)state;
    for (int round = 0; round < 200; round++) {
        graze_context *context = NULL;
        tally *t = calloc(1, sizeof *t);
        assert_int_equal(graze_context_create(&context), GRAZE_OK);
        t->fails_from = 100;
        t->limit = graze_context_limit(context, GRAZE_LIMIT_BITS);
        assert_int_equal(team_run(context, 1 + round % MEMBERS, INDICES, count_index, t),
                         GRAZE_ELIMIT);
        assert_string_equal(graze_context_message(context), "index 100 failed");
        assert_int_equal(t->done[INDICES - 1], 0);
        free(t);
        graze_context_destroy(context);
    }
}

static void test_cancel(void **state) {
    (void)state;
    for (int threads = 1; threads <= MEMBERS; threads++) {
        graze_context *context = NULL;
        tally *t = calloc(1, sizeof *t);
        int left = 0;
        assert_int_equal(graze_context_create(&context), GRAZE_OK);
        graze_context_set_cancel(context, graze_cancel_countdown, &left);
        t->fails_from = INDICES;
        t->limit = graze_context_limit(context, GRAZE_LIMIT_BITS);
        graze_status status = team_run(context, threads, INDICES, count_index, t);
        /* the others may have taken all before the caller took one */
        assert_true(status == GRAZE_ECANCELED || (status == GRAZE_OK && !t->by[0]));
        free(t);
        graze_context_destroy(context);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_once_each),
                                       cmocka_unit_test(test_first_failure),
                                       cmocka_unit_test(test_cancel)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
