/* The host's floating-point environment is not ours: the same answers under every rounding mode,
 * with subnormals flushed to zero, in a narrow exponent range of MPFR, and under a locale with a
 * decimal comma.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"
#include <fenv.h>
#include <locale.h>
#include <mpfr.h>
#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

enum { POINTS = 200, ROW_BYTES = 20000 };

/* All rows of generated points of the bracket, from reading the files on; malloc'ed. */
static char *classify_bracket(void) {
    scene s;
    graze_generator *generator;
    graze_sample made;
    mpq_t point[3], time;
    char *all = malloc((size_t)POINTS * ROW_BYTES);
    size_t used = 0;
    mpq_inits(point[0], point[1], point[2], time, NULL);
    assert_int_equal(graze_context_create(&s.context), GRAZE_OK);
    if (graze_solid_read(&s.solid, s.context, "cases/bracket/solid.off", 0) != GRAZE_OK)
        fail_msg("%s", graze_context_message(s.context));
    assert_int_equal(graze_motion_read(&s.motion, s.context, "cases/bracket/motion.json"),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&s.scene, s.context, s.solid, s.motion, NULL), GRAZE_OK);
    assert_int_equal(graze_generator_create(&generator, s.context, s.scene, 5, NULL, 0), GRAZE_OK);
    for (unsigned k = 0; k < POINTS; k++) {
        graze_trace *trace;
        char *row;
        assert_int_equal(graze_generator_point(point, time, &made, s.context, generator, k),
                         GRAZE_OK);
        assert_int_equal(graze_trace_create(&trace, s.context, s.scene, point), GRAZE_OK);
        for (int format = GRAZE_FORMAT_CSV; format <= GRAZE_FORMAT_JSONL; format++) {
            assert_int_equal(
                graze_report_row(&row, s.context, s.scene, point, trace, NULL,
                                 &(graze_row_options){.size = sizeof(graze_row_options),
                                                      .format = (graze_format)format}),
                GRAZE_OK);
            size_t length = strlen(row);
            assert_true(length < ROW_BYTES / 2);
            memcpy(all + used, row, length + 1);
            used += length;
            graze_free(row);
        }
        graze_trace_destroy(trace);
    }
    graze_generator_destroy(generator);
    scene_close(&s);
    mpq_clears(point[0], point[1], point[2], time, NULL);
    return all;
}

static char *usual;

static int before(void **state) {
    (void)state;
    usual = classify_bracket();
    return usual == NULL;
}

static int after(void **state) {
    (void)state;
    free(usual);
    return 0;
}

static void rounding_modes(void **state) {
    (void)state;
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (size_t k = 0; k < sizeof modes / sizeof *modes; k++) {
        assert_int_equal(fesetround(modes[k]), 0);
        char *rows = classify_bracket();
        int kept = fegetround();
        fesetround(FE_TONEAREST);
        assert_string_equal(rows, usual);
        assert_int_equal(kept, modes[k]);
        free(rows);
    }
}

static void flushed_subnormals(void **state) {
    (void)state;
#if defined(__SSE2__)
    unsigned int saved = _mm_getcsr();
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    char *rows = classify_bracket();
    _mm_setcsr(saved);
    assert_string_equal(rows, usual);
    free(rows);
#else
    skip();
#endif
}

/* The host's own work with MPFR may need a narrow range of exponents. */
static void exponents_of_mpfr(void **state) {
    (void)state;
    mpfr_exp_t least = mpfr_get_emin(), largest = mpfr_get_emax();
    mpfr_set_emin(-3);
    mpfr_set_emax(3);
    char *rows = classify_bracket();
    mpfr_exp_t kept[2] = {mpfr_get_emin(), mpfr_get_emax()};
    mpfr_set_emin(least);
    mpfr_set_emax(largest);
    assert_string_equal(rows, usual);
    assert_int_equal(kept[0], -3);
    assert_int_equal(kept[1], 3);
    free(rows);
}

/* The Makefile makes the locale. */
static void decimal_comma(void **state) {
    (void)state;
    setenv("LOCPATH", "build/tests/locale", 1);
    assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
    assert_string_equal(localeconv()->decimal_point, ",");
    char *rows = classify_bracket();
    (void)setlocale(LC_ALL, "C");
    assert_string_equal(rows, usual);
    free(rows);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rounding_modes),
        cmocka_unit_test(flushed_subnormals),
        cmocka_unit_test(exponents_of_mpfr),
        cmocka_unit_test(decimal_comma),
    };
    return cmocka_run_group_tests(tests, before, after);
}
