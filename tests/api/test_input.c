/* The wait for a FIFO without a writer asks the cancel callback.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"
#include <sys/stat.h>
#include <unistd.h>

/* Asks to stop at the third question. */
static int third(void *data) {
    int *questions = data;
    return ++*questions >= 3;
}

static void waiting_can_be_canceled(void **state) {
    (void)state;
    graze_context *context;
    graze_solid *solid;
    graze_motion *motion;
    graze_comparison *comparison;
    char *json;
    mpq_t zero;
    char folder[] = "/tmp/graze-input-XXXXXX", fifo[64];
    int questions = 0;
    mpq_init(zero);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    graze_context_set_cancel(context, third, &questions);
    assert_non_null(mkdtemp(folder));
    snprintf(fifo, sizeof fifo, "%s/silent.off", folder);
    assert_int_equal(mkfifo(fifo, 0600), 0);
    alarm(20); /* without a call of it this program ends here */
    assert_int_equal(graze_solid_read(&solid, context, fifo, 0), GRAZE_ECANCELED);
    assert_null(solid);
    assert_int_equal(questions, 3);
    questions = 0;
    assert_int_equal(graze_motion_read(&motion, context, fifo), GRAZE_ECANCELED);
    assert_null(motion);
    questions = 0;
    assert_int_equal(graze_compare(&comparison, context, fifo, fifo, NULL), GRAZE_ECANCELED);
    assert_null(comparison);
    questions = 0;
    assert_int_equal(graze_motion_write_poses(&json, NULL, context, fifo, zero, 0),
                     GRAZE_ECANCELED);
    assert_null(json);
    alarm(0);
    assert_int_equal(remove(fifo) | remove(folder), 0);
    graze_context_destroy(context);
    mpq_clear(zero);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(waiting_can_be_canceled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
