/* Memory that runs out: every allocation of ours fails once, and the call says so and gives
 * nothing. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * CGAL's C++ has its own way and is left alone.
 */
#include "walk.h"
#include "../lib/failing.h"

enum { TEETH = 24, VERTICES = 2 * TEETH + 3, SPAN = 2 * TEETH + 2, MOST = 100000 };

/* The comb: a bar under TEETH triangles whose tips are at (2k + 1, 1), their feet at (2k, 0). */
static graze_status make_comb(graze_solid **out, graze_context *context) {
    double at[2 * VERTICES] = {0, -1, 2 * TEETH, -1, 2 * TEETH, 0};
    size_t ring[VERTICES], size = VERTICES;
    for (int k = 0; k < TEETH; k++) {
        double *tip = at + 2 * (3 + 2 * (TEETH - 1 - k));
        tip[0] = 2 * k + 1;
        tip[1] = 1;
        tip[2] = 2 * k;
        tip[3] = 0;
    }
    for (size_t k = 0; k < VERTICES; k++)
        ring[k] = k;
    return graze_solid_from_doubles(out, context, 2, at, VERTICES, &size, 1, ring, 0);
}

/* The points (-1, y) run over the comb to (2 TEETH + 1, y), in two pieces of the motion that meet
 * over a tip. */
static graze_status make_motion(graze_motion **out, graze_context *context) {
    static const char text[] = "{\"dimension\": 2, \"pieces\": ["
                               "{\"t\": [0, 6], \"transform\": {\"translate\": [\"-t\", 0]}},"
                               "{\"t\": [6, 50], \"transform\": {\"translate\": [\"-t\", 0]}}]}";
    assert_int_equal(SPAN, 50);
    return graze_motion_from_json(out, context, text, strlen(text));
}

static void repeat(char *word, const char *part, int count) {
    strcpy(word, "O");
    while (count-- > 0)
        strcat(word, part);
}

typedef struct question {
    double y;
    char word[4 * TEETH + 2];
    graze_class class_;
} question;

/* At the tips it touches each; half way it crosses each tooth, k = TEETH; along the bar's lower
 * side there is one long contact; within the bar it is inside once. */
static void ask(question *q) {
    q[0] = (question){.y = 1, .class_ = GRAZE_BOUNDARY};
    repeat(q[0].word, "BO", TEETH);
    q[1] = (question){.y = 0.5, .class_ = GRAZE_FOLD};
    repeat(q[1].word, "BIBO", TEETH);
    q[2] = (question){.y = -1, .class_ = GRAZE_BOUNDARY};
    repeat(q[2].word, "BO", 1);
    q[3] = (question){.y = -0.5, .class_ = GRAZE_REGULAR};
    repeat(q[3].word, "BIBO", 1);
}

/* Whether the last call had all the memory it asked for. */
static int had_enough(void) {
    int enough = left >= 0;
    left = -1;
    return enough;
}

static void expect_failure(const scene *s, graze_status status, const void *out, long allowed) {
    if (status != GRAZE_ESYSTEM || out)
        print_message("status %d where allocation %ld fails\n", (int)status, allowed);
    assert_int_equal(status, GRAZE_ESYSTEM);
    assert_null(out);
    assert_non_null(strstr(graze_context_message(s->context), "memory"));
}

static void open_comb(scene *s) {
    assert_int_equal(graze_context_create(&s->context), GRAZE_OK);
    assert_int_equal(make_comb(&s->solid, s->context), GRAZE_OK);
    assert_int_equal(make_motion(&s->motion, s->context), GRAZE_OK);
    assert_int_equal(graze_scene_create(&s->scene, s->context, s->solid, s->motion, NULL),
                     GRAZE_OK);
}

/* The exact path: all or nothing. */
static void traces(void **state) {
    (void)state;
    scene s;
    question q[4];
    mpq_t p[2];
    open_comb(&s);
    graze_context_set_filter(s.context, 0);
    ask(q);
    mpq_inits(p[0], p[1], NULL);
    mpq_set_si(p[0], -1, 1);
    for (int k = 0; k < 4; k++) {
        int enough = 0;
        long allowed;
        mpq_set_d(p[1], q[k].y);
        for (allowed = 0; !enough && allowed < MOST; allowed++) {
            graze_trace *trace;
            left = allowed;
            graze_status status = graze_trace_create(&trace, s.context, s.scene, p);
            enough = had_enough();
            if (!enough) {
                expect_failure(&s, status, trace, allowed);
                continue;
            }
            assert_int_equal(status, GRAZE_OK);
            assert_string_equal(graze_trace_word(trace), q[k].word);
            assert_int_equal(graze_trace_verdict(trace).class_, q[k].class_);
            graze_trace_destroy(trace);
        }
        assert_true(enough && (allowed > 10 || SANITIZED));
    }
    mpq_clears(p[0], p[1], NULL);
    scene_close(&s);
}

/* The filter may do without its own memory, but no verdict is ever a wrong one. */
static void verdicts(void **state) {
    (void)state;
    scene s;
    question q[4];
    open_comb(&s);
    ask(q);
    for (int k = 0; k < 4; k++) {
        double point[2] = {-1, q[k].y};
        int enough = 0;
        for (long allowed = 0; !enough && allowed < MOST; allowed++) {
            graze_context *fresh;
            graze_verdict verdict = {.class_ = GRAZE_CLASS_NONE};
            assert_int_equal(graze_context_create(&fresh), GRAZE_OK);
            left = allowed;
            graze_status status =
                graze_classify_doubles(&verdict, fresh, s.scene, point, 1, GRAZE_COLUMNS_ALL);
            enough = had_enough();
            assert_true(status == GRAZE_OK || (status == GRAZE_ESYSTEM && !enough));
            assert_int_equal(verdict.class_, status == GRAZE_OK ? q[k].class_ : GRAZE_CLASS_NONE);
            graze_context_destroy(fresh);
        }
        assert_true(enough);
    }
    scene_close(&s);
}

/* Making what a scene is made of. */
static void makers(void **state) {
    (void)state;
    scene s;
    open_comb(&s);
    for (int kind = 0; kind < 3; kind++) {
        int enough = 0;
        for (long allowed = 0; !enough && allowed < MOST; allowed++) {
            graze_solid *solid = NULL;
            graze_motion *motion = NULL;
            graze_scene *made = NULL;
            left = allowed;
            graze_status status =
                kind == 0   ? make_comb(&solid, s.context)
                : kind == 1 ? make_motion(&motion, s.context)
                            : graze_scene_create(&made, s.context, s.solid, s.motion, NULL);
            enough = had_enough();
            const void *out = kind == 0 ? (void *)solid : kind == 1 ? (void *)motion : made;
            /* Reading a motion writes numbers out for messages that it may not need. */
            if (enough || (kind == 1 && status == GRAZE_OK))
                assert_int_equal(status, GRAZE_OK);
            else
                expect_failure(&s, status, out, allowed);
            graze_scene_destroy(made);
            graze_motion_destroy(motion);
            graze_solid_destroy(solid);
        }
        assert_true(enough);
    }
    scene_close(&s);
}

/* Input of the reports: a scene, some points, their table, and two files to compare. */
typedef struct bench {
    scene s;
    mpq_t point[4];
    char *table, *rows; /* the rows as values too */
    size_t rows_length;
    char golden[32], candidate[32];
} bench;

static void write_file(char *path, const char *text) {
    strcpy(path, "/tmp/graze-test-XXXXXX");
    FILE *file = fdopen(mkstemp(path), "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static void open_bench(bench *b) {
    static const char candidate[] = "x,y,pmc\n-1,1,in\n-1,1/2,in\n";
    static const graze_row_texts rest[] = {{NULL, "7/3,a"}, {NULL, "1e-3,b"}};
    char *head, *rows;
    size_t length, done;
    open_comb(&b->s);
    for (int k = 0; k < 4; k++)
        mpq_init(b->point[k]);
    mpq_set_si(b->point[0], -1, 1);
    mpq_set_si(b->point[1], 1, 1);
    mpq_set_si(b->point[2], -1, 1);
    mpq_set_si(b->point[3], 1, 2);
    assert_int_equal(graze_report_header(&head, b->s.context, b->s.scene, NULL, "size,id", NULL),
                     GRAZE_OK);
    assert_int_equal(graze_report_points(&rows, &length, &done, NULL, b->s.context, b->s.scene,
                                         b->point, 2, rest, NULL),
                     GRAZE_OK);
    b->table = malloc(strlen(head) + length + 32);
    strcat(strcat(strcpy(b->table, head), rows), "# complete 2\n");
    graze_free(head);
    graze_free(rows);
    const graze_row_options binary = {.size = sizeof binary, .format = GRAZE_FORMAT_NPY};
    assert_int_equal(graze_report_points(&b->rows, &b->rows_length, &done, NULL, b->s.context,
                                         b->s.scene, b->point, 2, rest, &binary),
                     GRAZE_OK);
    write_file(b->golden, b->table);
    write_file(b->candidate, candidate);
}

static void close_bench(bench *b) {
    remove(b->golden);
    remove(b->candidate);
    free(b->table);
    graze_free(b->rows);
    for (int k = 0; k < 4; k++)
        mpq_clear(b->point[k]);
    scene_close(&b->s);
}

static graze_status make_comparison(char **out, bench *b, graze_comparison_format format) {
    graze_compare_options options = {.size = sizeof options, .show = 3};
    graze_comparison *comparison;
    graze_status status =
        graze_compare(&comparison, b->s.context, b->golden, b->candidate, &options);
    if (status)
        assert_null(comparison);
    else
        status = graze_comparison_report(out, b->s.context, comparison, format);
    graze_comparison_destroy(comparison);
    return status;
}

enum { REPORTS = 5 };

static graze_status make_report(char **out, size_t *length, bench *b, int kind) {
    size_t done;
    *out = NULL;
    *length = 0;
    if (kind == 0)
        return graze_report_points(out, length, &done, NULL, b->s.context, b->s.scene, b->point, 1,
                                   NULL, &as_jsonl);
    const graze_row_options binary = {.size = sizeof binary,
                                      .format = kind == 1 ? GRAZE_FORMAT_NPY : GRAZE_FORMAT_VTK};
    if (kind < 3)
        return graze_report_export(out, length, b->s.context, b->s.scene, b->rows, b->rows_length,
                                   "size,id", NULL, &binary);
    graze_status status =
        make_comparison(out, b, kind == 3 ? GRAZE_COMPARISON_TEXT : GRAZE_COMPARISON_JSON);
    *length = *out ? strlen(*out) : 0;
    return status;
}

/* A report is whole or not there. yajl's memory is ours, and so it fails here too. */
static void reports(void **state) {
    (void)state;
    bench b;
    open_bench(&b);
    graze_context_set_filter(b.s.context, 0);
    for (int kind = 0; kind < REPORTS; kind++) {
        char *whole, *text;
        size_t length, n;
        long allowed;
        int enough = 0;
        assert_int_equal(make_report(&whole, &length, &b, kind), GRAZE_OK);
        for (allowed = 0; !enough && allowed < MOST; allowed++) {
            left = allowed;
            graze_status status = make_report(&text, &n, &b, kind);
            enough = had_enough();
            if (!enough) {
                expect_failure(&b.s, status, text, allowed);
                continue;
            }
            assert_int_equal(status, GRAZE_OK);
            assert_int_equal(n, length);
            assert_memory_equal(text, whole, n);
            graze_free(text);
        }
        assert_true(enough && (allowed > 5 || SANITIZED));
        graze_free(whole);
    }
    close_bench(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(traces), cmocka_unit_test(verdicts),
                                       cmocka_unit_test(makers), cmocka_unit_test(reports)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
