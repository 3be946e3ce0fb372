/* The verdict that a word has.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

static const graze_options sweep = {.size = sizeof sweep},
                           combined = {.size = sizeof sweep, .folds = GRAZE_FOLDS_COMBINED},
                           unsweep = {.size = sizeof sweep, .operation = GRAZE_UNSWEEP};

/* By hand from Definitions 3 to 11 and Table 1: i counts a B between different letters or beside an
 * I at an end, t every other one, k = (i + ends I) / 2. */
static const struct {
    const char *word;
    const graze_options *options;
    graze_verdict verdict;
} right[] = {
    {"O", &sweep, {GRAZE_OUT, GRAZE_EXTERIOR, 9, 1, 0, 0}},
    {"I", &sweep, {GRAZE_IN, GRAZE_REGULAR, 0, 9, 0, 0}},
    {"B", &sweep, {GRAZE_ON, GRAZE_BOUNDARY, 0, 5, 0, 1}},
    {"OB", &sweep, {GRAZE_ON, GRAZE_BOUNDARY, 8, 2, 0, 1}},
    {"BO", &sweep, {GRAZE_ON, GRAZE_BOUNDARY, 8, 4, 0, 1}},
    {"BI", &sweep, {GRAZE_IN, GRAZE_REGULAR, 0, 6, 1, 0}},
    {"IB", &sweep, {GRAZE_IN, GRAZE_REGULAR, 0, 8, 1, 0}},
    {"OBI", &sweep, {GRAZE_IN, GRAZE_REGULAR, 5, 3, 1, 0}},
    {"IBO", &sweep, {GRAZE_IN, GRAZE_REGULAR, 5, 7, 1, 0}},
    {"BIBO", &sweep, {GRAZE_IN, GRAZE_REGULAR, 5, 4, 2, 0}},
    {"OBIBO", &sweep, {GRAZE_IN, GRAZE_REGULAR, 5, 1, 2, 0}},
    {"OBIBOBIBO", &sweep, {GRAZE_IN, GRAZE_FOLD, 6, 1, 4, 0}},
    {"OBIBIBO", &sweep, {GRAZE_IN, GRAZE_FOLD_BOUNDARY, 7, 1, 2, 1}},
    {"OBOBIBOBIBO", &sweep, {GRAZE_IN, GRAZE_FOLD_BOUNDARY, 7, 1, 4, 1}},
    {"OBO", &sweep, {GRAZE_ON, GRAZE_BOUNDARY, 8, 1, 0, 1}},
    {"IBOBI", &sweep, {GRAZE_IN, GRAZE_FOLD, 0, 9, 2, 0}},
    {"OBIBOBIBO", &combined, {GRAZE_IN, GRAZE_FOLD, 10, 1, 4, 0}},
    {"OBOBIBOBIBO", &combined, {GRAZE_IN, GRAZE_FOLD, 10, 1, 4, 1}},
    {"OBIBIBO", &combined, {GRAZE_IN, GRAZE_FOLD_BOUNDARY, 11, 1, 2, 1}},
    {"I", &unsweep, {GRAZE_IN, GRAZE_CLASS_NONE, 0, 0, 0, 0}},
    {"IBI", &unsweep, {GRAZE_ON, GRAZE_CLASS_NONE, 0, 0, 0, 1}},
    {"IBO", &unsweep, {GRAZE_OUT, GRAZE_CLASS_NONE, 0, 0, 1, 0}},
};

static void words_by_hand(void **state) {
    (void)state;
    graze_context *context;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (size_t k = 0; k < sizeof right / sizeof *right; k++) {
        graze_verdict v;
        size_t length = strlen(right[k].word);
        char bytes[16]; /* the word with more behind it */
        memset(bytes, 'I', sizeof bytes);
        memcpy(bytes, right[k].word, length);
        assert_int_equal(graze_word_verdict(&v, context, bytes, length, right[k].options),
                         GRAZE_OK);
        const graze_verdict *e = &right[k].verdict;
        if (v.pmc != e->pmc || v.class_ != e->class_ || v.definition != e->definition ||
            v.case_ != e->case_ || v.i != e->i || v.t != e->t)
            fail_msg("%s: %s %d %d %lu %lu", right[k].word, graze_class_name(v.class_),
                     v.definition, v.case_, v.i, v.t);
    }
    graze_context_destroy(context);
}

static void what_is_no_word(void **state) {
    (void)state;
    static const char *const wrong[] = {"",  "OO", "BB",   "II",  "OI",    "IO",
                                        "X", "ob", "OBIO", "OBX", "OBBIO", " O"};
    graze_context *context;
    graze_verdict v;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        if (graze_word_verdict(&v, context, wrong[k], strlen(wrong[k]), NULL) != GRAZE_EINPUT)
            fail_msg("'%s' is taken for a word", wrong[k]);
        assert_int_equal(v.pmc, GRAZE_PMC_NONE);
        assert_non_null(strstr(graze_context_message(context), "is no word"));
    }
    assert_int_equal(graze_word_verdict(&v, context, "O\0", 2, NULL), GRAZE_EINPUT);
    graze_context_destroy(context);
}

/* The verdict of a trace is that of its word. */
static void traces_agree(void **state) {
    (void)state;
    static const char back[] =
        "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": "
        "[\"8*t-8*t^2\", \"(2*t-1)*(4*t-1)\"]}}]}";
    const graze_options *const options[] = {&sweep, &combined, &unsweep};
    for (size_t k = 0; k < 3; k++) {
        scene s;
        graze_generator *generator;
        mpq_t p[2], time;
        scene_open(&s, back, options[k]);
        mpq_inits(p[0], p[1], time, NULL);
        assert_int_equal(graze_generator_create(&generator, s.context, s.scene, 7, NULL, 0),
                         GRAZE_OK);
        for (unsigned long long row = 0; row < 300; row++) {
            graze_sample made;
            graze_trace *trace;
            graze_verdict v;
            assert_int_equal(graze_generator_point(p, time, &made, s.context, generator, row),
                             GRAZE_OK);
            assert_int_equal(graze_trace_create(&trace, s.context, s.scene, p), GRAZE_OK);
            const char *word = graze_trace_word(trace);
            graze_verdict e = graze_trace_verdict(trace);
            assert_int_equal(graze_word_verdict(&v, s.context, word, strlen(word), options[k]),
                             GRAZE_OK);
            if (v.pmc != e.pmc || v.class_ != e.class_ || v.definition != e.definition ||
                v.case_ != e.case_ || v.i != e.i || v.t != e.t)
                fail_msg("row %llu, %s", row, word);
            graze_trace_destroy(trace);
        }
        graze_generator_destroy(generator);
        mpq_clears(p[0], p[1], time, NULL);
        scene_close(&s);
    }
}

/* Letters beside the word are none of it: O in OB, and BO in IBO, whose one contact, at t0, has O
 * beside it. */
static void only_its_letters(void **state) {
    (void)state;
    graze_context *context;
    graze_verdict v;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(graze_word_verdict(&v, context, "OB", 1, NULL), GRAZE_OK);
    assert_true(v.class_ == GRAZE_EXTERIOR && v.i == 0 && v.t == 0);
    assert_int_equal(graze_word_verdict(&v, context, &"IBO"[1], 2, NULL), GRAZE_OK);
    assert_true(v.class_ == GRAZE_BOUNDARY && v.i == 0 && v.t == 1);
    graze_context_destroy(context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_by_hand),
        cmocka_unit_test(what_is_no_word),
        cmocka_unit_test(only_its_letters),
        cmocka_unit_test(traces_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
