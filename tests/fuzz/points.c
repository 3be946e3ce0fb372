/* One point of a scene, answered in several ways that must agree.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The counts, the class and the definition are derived here from the word a second time, by the
 * tables of the contract.
 */
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

/* Letters alternate, and no two states of the same kind stand side by side. */
static void check_word(const char *word) {
    size_t n = strlen(word);
    EXPECT(n > 0 && strspn(word, "IBO") == n);
    for (size_t k = 0; k + 1 < n; k++)
        EXPECT((word[k] == 'B') != (word[k + 1] == 'B'));
}

/* Intersections and tangencies of a word: what stands beside each B. */
static void count(unsigned long *i, unsigned long *t, const char *word) {
    size_t n = strlen(word);
    *i = *t = 0;
    for (size_t k = 0; k < n; k++) {
        if (word[k] != 'B')
            continue;
        char left = k > 0 ? word[k - 1] : 0, right = k + 1 < n ? word[k + 1] : 0;
        int crosses = left && right ? left != right : left == 'I' || right == 'I';
        *(crosses ? i : t) += 1;
    }
}

static graze_class class_of(unsigned long k, unsigned long t, graze_folds folds) {
    if (k == 0)
        return t ? GRAZE_BOUNDARY : GRAZE_EXTERIOR;
    if (folds == GRAZE_FOLDS_COMBINED)
        return k >= 2 ? GRAZE_FOLD : t ? GRAZE_FOLD_BOUNDARY : GRAZE_REGULAR;
    return t ? GRAZE_FOLD_BOUNDARY : k == 1 ? GRAZE_REGULAR : GRAZE_FOLD;
}

/* The verdict of a word by proofs/semantics.md 4 and 6. */
static void check_verdict(graze_verdict v, const char *word, graze_options options) {
    unsigned long i, t;
    char first = word[0], last = word[strlen(word) - 1];
    count(&i, &t, word);
    EXPECT(v.i == i && v.t == t);
    if (options.operation == GRAZE_UNSWEEP) {
        graze_pmc pmc = strcmp(word, "I") == 0 ? GRAZE_IN
                        : strchr(word, 'O')    ? GRAZE_OUT
                                               : GRAZE_ON;
        EXPECT(v.pmc == pmc && v.class_ == GRAZE_CLASS_NONE && v.case_ == 0);
        return;
    }
    static const char cases[] = "OOOBOIBOBBBIIOIBII"; /* t0 and t1 of the cases 1 to 9 */
    unsigned long twice = i + (first == 'I') + (last == 'I');
    EXPECT(twice % 2 == 0);
    EXPECT(v.pmc == (strchr(word, 'I') ? GRAZE_IN : strchr(word, 'B') ? GRAZE_ON : GRAZE_OUT));
    EXPECT(v.class_ == class_of(twice / 2, t, options.folds));
    EXPECT(v.case_ >= 1 && v.case_ <= 9);
    EXPECT(cases[2 * v.case_ - 2] == first && cases[2 * v.case_ - 1] == last);
    EXPECT(strcmp(graze_pmc_name(v.pmc), "none") != 0);
    EXPECT(strcmp(graze_class_name(v.class_), "none") != 0);
    int outside = v.case_ == 5 || v.case_ == 6 || v.case_ == 8 || v.case_ == 9;
    int plain = (int)v.class_ + 4;
    int combined = v.class_ == GRAZE_FOLD ? 10 : v.class_ == GRAZE_FOLD_BOUNDARY ? 11 : plain;
    EXPECT(v.definition == (outside                                 ? 0
                            : options.folds == GRAZE_FOLDS_COMBINED ? combined
                                                                    : plain));
}

/* A time's polynomial, interval and decimal are there, and times follow one another. */
static void check_times(graze_context *context, const graze_contact *c, mpq_t after) {
    mpq_t low, high, value;
    mpz_t coefficient;
    char *text;
    mpq_inits(low, high, value, NULL);
    mpz_init(coefficient);
    const graze_time *ends[] = {c->from, c->to};
    for (int k = 0; k < (c->from == c->to ? 1 : 2); k++) {
        int degree = graze_time_degree(ends[k]);
        EXPECT(degree >= 1);
        EXPECT(graze_time_rational(value, ends[k]) == (degree == 1));
        graze_time_interval(low, high, ends[k]);
        EXPECT(mpq_cmp(low, high) < 0 || (degree == 1 && mpq_equal(low, value)));
        EXPECT(mpq_cmp(after, high) <= 0);
        mpq_set(after, low);
        graze_time_coefficient(coefficient, ends[k], degree);
        EXPECT(mpz_sgn(coefficient) > 0);
        EXPECT(graze_time_decimal(&text, context, ends[k], 17) == GRAZE_OK);
        graze_free(text);
    }
    mpz_clear(coefficient);
    mpq_clears(low, high, value, NULL);
}

static void check_contacts(graze_context *context, const graze_trace *trace) {
    graze_verdict v = graze_trace_verdict(trace);
    size_t n = graze_trace_contact_count(trace);
    unsigned long crossings = 0;
    mpq_t after;
    mpq_init(after);
    EXPECT(n == v.i + v.t);
    for (size_t k = 0; k < n; k++) {
        graze_contact c = graze_trace_contact(trace, k);
        EXPECT(c.kind == GRAZE_INTERSECTION || c.kind == GRAZE_TANGENCY);
        EXPECT(c.cell_count > 0 && c.cells != NULL);
        crossings += c.kind == GRAZE_INTERSECTION;
        if (k == 0)
            graze_time_interval(after, after, c.from);
        check_times(context, &c, after);
    }
    EXPECT(crossings == v.i);
    EXPECT(graze_trace_contact(trace, n).from == NULL);
    mpq_clear(after);
}

/* Everything that is said of a point, as text. 0 when a limit was met. */
static int say(char *out[4], graze_verdict *v, graze_context *context, const graze_scene *scene,
               graze_rationals point) {
    graze_trace *trace = NULL;
    char *one = NULL;
    size_t length, done;
    for (int k = 0; k < 4; k++)
        out[k] = NULL;
    graze_status status = graze_trace_create(&trace, context, scene, point);
    EXPECT(status == GRAZE_OK || status == GRAZE_ELIMIT);
    if (status)
        return 0;
    *v = graze_trace_verdict(trace);
    check_word(graze_trace_word(trace));
    /* A point whose word begins and ends with I or B is in both S^0 and S^1. */
    EXPECT(graze_scene_ends_meet(scene) || !strchr("IB", *graze_trace_word(trace)) ||
           !strchr("IB", graze_trace_word(trace)[strlen(graze_trace_word(trace)) - 1]));
    graze_options options = {.size = sizeof options};
    graze_scene_options(&options, scene);
    check_verdict(*v, graze_trace_word(trace), options);
    check_contacts(context, trace);
    EXPECT(graze_report_row(&out[0], context, scene, point, trace, NULL,
                            &(graze_row_options){.size = sizeof(graze_row_options),
                                                 .format = GRAZE_FORMAT_JSONL}) == GRAZE_OK);
    EXPECT(fuzz_is_json(out[0], strlen(out[0])));
    EXPECT(graze_report_explain(&out[1], context, scene, point, trace, NULL) == GRAZE_OK);
    EXPECT(graze_report_row(&out[2], context, scene, point, trace, &(graze_row_texts){NULL, "x"},
                            NULL) == GRAZE_OK);
    EXPECT(graze_report_points(&out[3], &length, &done, NULL, context, scene, point, 1,
                               &(graze_row_texts){NULL, "x"}, NULL) == GRAZE_OK);
    EXPECT(graze_report_point(&one, context, scene, point, &(graze_row_texts){NULL, "x"}, NULL) ==
           GRAZE_OK);
    EXPECT(strcmp(one, out[2]) == 0);
    graze_free(one);
    EXPECT(done == 1 && length == strlen(out[2]) && memcmp(out[2], out[3], length) == 0);
    graze_trace_destroy(trace);
    return 1;
}

/* Verdicts alone, and of doubles where the point is one. */
static void check_classify(graze_context *context, const graze_scene *scene, graze_rationals point,
                           graze_verdict v) {
    graze_verdict alone = {0}, rounded = {0};
    double doubles[3];
    int d = graze_scene_dimension(scene), exact = 1;
    mpq_t back;
    mpq_init(back);
    EXPECT(graze_classify(&alone, context, scene, point, 1, GRAZE_COLUMNS_ALL) == GRAZE_OK);
    EXPECT(alone.pmc == v.pmc && alone.class_ == v.class_ && alone.definition == v.definition &&
           alone.case_ == v.case_ && alone.i == v.i && alone.t == v.t);
    for (int k = 0; k < d; k++) {
        doubles[k] = mpq_get_d(point[k]);
        mpq_set_d(back, doubles[k]);
        exact &= mpq_equal(back, point[k]) != 0;
    }
    EXPECT(graze_classify_doubles(&rounded, context, scene, doubles, 1, GRAZE_COLUMNS_ALL) ==
           GRAZE_OK);
    EXPECT(!exact || (rounded.pmc == v.pmc && rounded.class_ == v.class_ && rounded.i == v.i));
    mpq_clear(back);
}

/* The box holds the sweep: what is outside the box is outside the sweep. */
static void check_box(graze_context *context, const graze_scene *scene, graze_rationals point,
                      graze_verdict v) {
    mpq_t low[3], high[3];
    mpq_inits(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
    EXPECT(graze_scene_box(low, high, context, scene) == GRAZE_OK);
    for (int k = 0; k < graze_scene_dimension(scene); k++)
        EXPECT(v.pmc == GRAZE_OUT ||
               (mpq_cmp(low[k], point[k]) <= 0 && mpq_cmp(point[k], high[k]) <= 0));
    mpq_clears(low[0], low[1], low[2], high[0], high[1], high[2], NULL);
}

int fuzz_point(graze_context *context, const graze_scene *scene, graze_rationals point) {
    char *filtered[4], *exact[4];
    graze_verdict v, w;
    graze_context_set_filter(context, 0);
    int answered = say(exact, &w, context, scene, point);
    graze_context_set_filter(context, 1);
    int again = say(filtered, &v, context, scene, point);
    if (answered && again) {
        for (int k = 0; k < 4; k++)
            EXPECT(strcmp(filtered[k], exact[k]) == 0);
        check_classify(context, scene, point, v);
        check_box(context, scene, point, v);
    }
    for (int k = 0; k < 4; k++) {
        graze_free(filtered[k]);
        graze_free(exact[k]);
    }
    return answered;
}
