/* graze_context_exact_count: which queries went through the exact path.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The square slides along; a point far aside and one that the square plainly runs over need no
 * exact arithmetic, the corner's own path does, and with the filter off every query does.
 */
#include "walk.h"

static unsigned long asked(const scene *s, long x, long y, long over) {
    graze_verdict verdict;
    mpq_t p[2];
    mpq_inits(p[0], p[1], NULL);
    mpq_set_si(p[0], x, (unsigned long)over);
    mpq_set_si(p[1], y, (unsigned long)over);
    mpq_canonicalize(p[0]);
    mpq_canonicalize(p[1]);
    unsigned long before = graze_context_exact_count(s->context);
    assert_int_equal(graze_classify(&verdict, s->context, s->scene, p, 1, GRAZE_COLUMNS_ALL),
                     GRAZE_OK);
    mpq_clears(p[0], p[1], NULL);
    return graze_context_exact_count(s->context) - before;
}

static void counts(void **state) {
    (void)state;
    scene s;
    scene_open(&s, slide, NULL);
    assert_int_equal(graze_context_exact_count(s.context), 0);
    assert_int_equal(asked(&s, 500, 500, 3), 0);
    assert_int_equal(asked(&s, 17, 4, 3), 0);
    assert_int_equal(asked(&s, 5, 2, 1), 1);
    graze_context_set_filter(s.context, 0);
    assert_int_equal(asked(&s, 500, 500, 3), 1);
    assert_int_equal(asked(&s, 17, 4, 3), 1);
    scene_close(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(counts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
