/* Comparing tables: hand-made tables with counts that are evident, and random ones with counts made
 * while they were made.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <unistd.h>
#include "../lib/random.h"
#include "decide/filter/filter.h"
#include "input/delimited/delimited.h"
#include "output/compare/compare.h"
#include "output/compare/counts.h"
#include "fixture.h"

static char golden_path[] = "/tmp/graze-test-golden-XXXXXX";
static char candidate_path[] = "/tmp/graze-test-candidate-XXXXXX";

static int set_up_files(void **state) {
    int a = mkstemp(golden_path), b = mkstemp(candidate_path);
    close(a);
    close(b);
    return a < 0 || b < 0 || set_up(state);
}

static int tear_down_files(void **state) {
    unlink(golden_path);
    unlink(candidate_path);
    return tear_down(state);
}

static void write_file(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static graze_comparison_counts compare(const graze_compare_options *options) {
    graze_comparison *c;
    graze_status status = graze_compare(&c, context, golden_path, candidate_path, options);
    if (status)
        fail_msg("%s", graze_context_message(context));
    graze_comparison_counts n = graze_comparison_count(c);
    if (n.rows != n.agree + n.wrong + n.undecided + n.missing)
        fail_msg("%lu rows are not %lu + %lu + %lu + %lu", n.rows, n.agree, n.wrong, n.undecided,
                 n.missing);
    graze_comparison_destroy(c);
    return n;
}

static void expect(const graze_compare_options *options, unsigned long agree, unsigned long wrong,
                   unsigned long undecided, unsigned long missing, unsigned long extra) {
    graze_comparison_counts n = compare(options);
    if (n.agree != agree || n.wrong != wrong || n.undecided != undecided || n.missing != missing ||
        n.extra != extra)
        fail_msg(
            "agree %lu wrong %lu undecided %lu missing %lu extra %lu; right: %lu %lu %lu %lu %lu",
            n.agree, n.wrong, n.undecided, n.missing, n.extra, agree, wrong, undecided, missing,
            extra);
}

#define HEAD "x,y,pmc,class,definition,case,i,t,word\n"
#define IN_ROW ",in,regular,5,1,2,0,OBIBO\n"
#define ON_ROW ",on,boundary,8,1,0,1,OBO\n"
#define OUT_ROW ",out,exterior,9,1,0,0,O\n"

static void columns_are_judged_each(void **state) {
    (void)state;
    write_file(golden_path, HEAD "1,0" IN_ROW "2,0" ON_ROW "3,0" OUT_ROW "# complete 3\n");
    write_file(candidate_path, "x,y,pmc\n1,0,in\n2,0,on\n3,0,out\n");
    expect(NULL, 3, 0, 0, 0, 0);
    write_file(candidate_path, "x,y,pmc\n1.0,0,in\n4/2,0,out\n+3,0e5,in\n");
    expect(NULL, 1, 2, 0, 0, 0);
    write_file(candidate_path, "word,t,y,i,x\nOBIBO,0,0,2,1\nOBO,2,0,0,2\nO,0,0,1,3\n");
    expect(NULL, 1, 2, 0, 0, 0);
    write_file(candidate_path, "x,y,class\n1,0,fold\n2,0,boundary\n3,0,exterior\n");
    expect(NULL, 2, 1, 0, 0, 0);
    write_file(candidate_path, "x,y,word\n1,0,OBIBO\n2,0,OBOB\n3,0,O\n");
    expect(NULL, 2, 1, 0, 0, 0);
}

/* `on` against in and out, under each meaning it can be given. */
static void on_counts_as(void **state) {
    (void)state;
    write_file(golden_path,
               HEAD "1,0" IN_ROW "2,0" ON_ROW "3,0" ON_ROW "4,0" OUT_ROW "# complete 4\n");
    write_file(candidate_path, "x,y,pmc\n1,0,in\n2,0,in\n3,0,out\n4,0,out\n");
    graze_compare_options o = {.size = sizeof o, .on_as = GRAZE_ON_AS_ON};
    expect(&o, 2, 2, 0, 0, 0);
    o.on_as = GRAZE_ON_AS_ANY;
    expect(&o, 4, 0, 0, 0, 0);
    o.on_as = GRAZE_ON_AS_IN;
    expect(&o, 3, 1, 0, 0, 0);
    o.on_as = GRAZE_ON_AS_OUT;
    expect(&o, 3, 1, 0, 0, 0);
    write_file(candidate_path, "x,y,pmc\n1,0,on\n2,0,on\n3,0,on\n4,0,on\n");
    expect(&o, 3, 1, 0, 0, 0); /* 4 and both `on`, not 1 */
    o.on_as = GRAZE_ON_AS_IN;
    expect(&o, 3, 1, 0, 0, 0); /* 1 and both `on`, not 4 */
    o.on_as = GRAZE_ON_AS_ANY;
    expect(&o, 2, 2, 0, 0, 0);
}

/* The sign alone counts, below the smallest double too. */
static void distances(void **state) {
    (void)state;
    write_file(golden_path, HEAD "1,0" IN_ROW "2,0" ON_ROW "3,0" OUT_ROW "# complete 3\n");
    graze_compare_options o = {.size = sizeof o, .has = GRAZE_HAS_SDF};
    write_file(candidate_path, "x,y,sdf\n1,0,-1e-999\n2,0,-0.0e7\n3,0,1/1000\n");
    expect(&o, 3, 0, 0, 0, 0);
    write_file(candidate_path, "x,y,sdf\n1,0,0\n2,0,0/5\n3,0,-.5\n");
    expect(&o, 1, 2, 0, 0, 0);
}

/* The closed question: `topo` decides where it stands; else one contact at an instant in a face is
 * on the boundary for certain and any other `on` row is undecided. */
static void closed_question(void **state) {
    (void)state;
    graze_compare_options o = {.size = sizeof o, .question = GRAZE_QUESTION_CLOSED};
    write_file(golden_path, "x,y,pmc,i,t,word,topo\n1,0,on,0,1,OBO,interior\n"
                            "2,0,on,0,1,OBO,boundary\n3,0,on,0,1,OBO,undecided\n"
                            "4,0,in,2,0,OBIBO,interior\n# complete 4\n");
    write_file(candidate_path, "x,y,pmc\n1,0,in\n2,0,on\n3,0,out\n4,0,in\n");
    expect(&o, 3, 0, 1, 0, 0);
    write_file(candidate_path, "x,y,pmc\n1,0,on\n2,0,in\n3,0,in\n4,0,out\n");
    expect(&o, 0, 3, 1, 0, 0);
    write_file(golden_path, "# dimension 2\nx,y,pmc,i,t,word,stratum,order,cell,time,k\n"
                            "1,0,on,0,1,OBO,face,2,edge 0-1,1/2,\n"
                            "2,0,on,0,1,OBO,vertex,1,vertex 3,1/2,\n"
                            "3,0,on,0,2,OBOBO,face,2,edge 0-1,1/2,\n"
                            "4,0,on,0,1,OBO,slide,slide,edge 0-1,1/2,\n"
                            "5,0,on,0,1,OBO,miss,2,edge 0-1,1/2,9\n"
                            "6,0,on,0,1,OBO,break,1,edge 0-1,1/2,\n"
                            "7,0,on,0,1,OBO,random,,,,\n# complete 7\n");
    write_file(candidate_path,
               "x,y,pmc\n1,0,in\n2,0,in\n3,0,in\n4,0,in\n5,0,in\n6,0,out\n7,0,on\n");
    expect(&o, 0, 1, 6, 0, 0);
    o.question = GRAZE_QUESTION_OPEN;
    expect(&o, 1, 6, 0, 0, 0);
}

/* In a table of Graze a column `topo` is its answer if the head says so, else one of the points. */
static void closed_question_of_carried_columns(void **state) {
    (void)state;
    graze_compare_options o = {.size = sizeof o, .question = GRAZE_QUESTION_CLOSED};
    static const char row[] = "x,y,pmc,i,t,word,topo\n1,0,on,0,2,OBOBO,interior\n# complete 1\n";
    char table[200];
    write_file(candidate_path, "x,y,pmc\n1,0,in\n");
    snprintf(table, sizeof table, "# graze 1\n# topo yes\n%s", row);
    write_file(golden_path, table);
    expect(&o, 1, 0, 0, 0, 0);
    snprintf(table, sizeof table, "# graze 1\n%s", row);
    write_file(golden_path, table);
    expect(&o, 0, 0, 1, 0, 0);
}

/* A position that is none of an `on` point is refused by name, and no reason to leave a row out. */
static void closed_question_of_other_words(void **state) {
    (void)state;
    static const char *const words[] = {"unknown", "borderline", "exterior", "Interior"};
    graze_compare_options o = {.size = sizeof o, .question = GRAZE_QUESTION_CLOSED};
    write_file(candidate_path, "x,y,pmc\n1,0,on\n2,0,on\n");
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
        char table[200], said[200];
        snprintf(table, sizeof table,
                 "x,y,pmc,i,t,word,topo\n1,0,on,0,1,OBO,boundary\n2,0,on,0,1,OBO,%s\n"
                 "# complete 2\n",
                 words[k]);
        snprintf(said, sizeof said,
                 "topo: '%s' is no answer; expected interior, boundary or undecided for `on`",
                 words[k]);
        write_file(golden_path, table);
        graze_comparison *c = NULL;
        assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, &o), GRAZE_EINPUT);
        assert_non_null(strstr(graze_context_message(context), said));
    }
}

/* In space an edge is no face. */
static void closed_question_in_space(void **state) {
    (void)state;
    graze_compare_options o = {.size = sizeof o, .question = GRAZE_QUESTION_CLOSED};
    write_file(golden_path, "x,y,z,pmc,i,t,word,order,cell,k\n1,0,0,on,0,1,OBO,1,edge 0-1,\n"
                            "2,0,0,on,0,1,OBO,2,face 3,\n# complete 2\n");
    write_file(candidate_path, "x,y,z,pmc\n1,0,0,in\n2,0,0,in\n");
    expect(&o, 0, 1, 1, 0, 0);
}

static void rows_missing_and_extra(void **state) {
    (void)state;
    write_file(golden_path,
               HEAD "1,0" IN_ROW "2,0" ON_ROW "3,0" OUT_ROW "4,0" OUT_ROW "# complete 4\n");
    write_file(candidate_path, "x,y,pmc\n1,0,in\n3,0,out\n4,0,out\n");
    expect(NULL, 3, 0, 0, 1, 0);
    write_file(candidate_path, "x,y,pmc\n1,0,in\n2,0,on\n");
    expect(NULL, 2, 0, 0, 2, 0);
    write_file(candidate_path, "x,y,pmc\n");
    expect(NULL, 0, 0, 0, 4, 0);
    write_file(candidate_path,
               "x,y,pmc\n1,0,in\n1,0,in\n2,0,on\n9,9,in\n3,0,out\n4,0,out\n5,0,out\n");
    expect(NULL, 4, 0, 0, 0, 3);
    write_file(candidate_path, "x,y,pmc\n9,9,in\n2,0,on\n4,0,in\n");
    expect(NULL, 1, 1, 0, 2, 1);
    write_file(golden_path, HEAD "# complete 0\n");
    expect(NULL, 0, 0, 0, 0, 3);
}

/* An id takes the point's place where both have it. */
static void ids_match(void **state) {
    (void)state;
    write_file(golden_path, "x,y,pmc,id\n1,0,in,a\n1,0,in,b\n1,0,in,\"c d\"\n# complete 3\n");
    write_file(candidate_path, "id,pmc\na,in\nb,out\nc d,in\n");
    expect(NULL, 2, 1, 0, 0, 0);
    write_file(candidate_path, "id,pmc\nb,in\nc d,in\n");
    expect(NULL, 2, 0, 0, 1, 0);
}

#define SITES "time,bx,by,role,theta,near\n"

/* Contact points go by time and point, in any order; an empty answer is right where the golden one
 * is empty, and rows of one key go by their order. */
static void contact_points(void **state) {
    (void)state;
    write_file(golden_path, SITES "1/2,1,0,contact,+,\n1/2,2,0,egress,,1/3\n"
                                  "root(-1 0 2;0;1),1,0,hidden,,root(-1 0 3;0;1)\n# complete 3\n");
    write_file(candidate_path, SITES "root(-1 0 2;0;1),1,0,hidden,,root(-1 0 3;0;1)\n"
                                     "0.5,4/2,0,egress,,2/6\n2/4,1.0,0,contact,+,\n");
    expect(NULL, 3, 0, 0, 0, 0);
    write_file(candidate_path, "y,x,time,role\n0,1,1/2,contact\n");
    graze_comparison *c = NULL;
    assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, NULL), GRAZE_EINPUT);
    write_file(candidate_path, "theta,by,bx,time\n,0,1,1/2\n,0,2,1/2\n,0,3,1/2\n");
    expect(NULL, 1, 1, 0, 1, 1);
    write_file(candidate_path, SITES "1/2,2,0,egress,,1/3\n1/2,2,0,egress,,1/3\n");
    expect(NULL, 1, 0, 0, 2, 1);
    write_file(golden_path, "time,bx,by,near\n0,0,0,1\n0,0,0,2\n0,0,0,3\n# complete 3\n");
    write_file(candidate_path, "time,bx,by,near\n0,0,0,1\n0,0,0,3\n");
    expect(NULL, 1, 1, 0, 1, 0);
    write_file(golden_path, "time,bx,by,near,id\n0,0,0,1,a\n0,0,0,2,b\n# complete 2\n");
    write_file(candidate_path, "id,near\nb,2\na,1\n");
    expect(NULL, 2, 0, 0, 0, 0);
}

/* 1/3 and its double are one point under rounding only. */
static void rounding_matches(void **state) {
    (void)state;
    write_file(golden_path, HEAD "1/3,0" IN_ROW "1/10,0" ON_ROW "# complete 2\n");
    write_file(candidate_path, "x,y,pmc\n0.33333333333333331,0,in\n0.10000000000000001,-0.0,on\n");
    graze_comparison *c;
    expect(NULL, 2, 0, 0, 0, 0); /* by order: there are as many */
    write_file(candidate_path, "x,y,pmc\n0.33333333333333331,0,in\n");
    assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, NULL), GRAZE_EINPUT);
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_BINARY64), GRAZE_OK);
    expect(NULL, 1, 0, 0, 1, 0);
    write_file(candidate_path, "x,y,pmc\n0.33333333333333331,0,in\n0.10000000000000001,-0.0,on\n");
    expect(NULL, 2, 0, 0, 0, 0);
    write_file(golden_path,
               HEAD "1/3,0" IN_ROW "1/10,0" ON_ROW "0.33333333333333333,0" IN_ROW "# complete 3\n");
    write_file(candidate_path, "x,y,pmc\n1/3,0,in\n1/10,0,on\n1/3,0,in\n");
    expect(NULL, 3, 0, 0, 0, 0);
    write_file(golden_path,
               HEAD "1/3,0" IN_ROW "1/10,0" ON_ROW "0.33333333333333333,0" ON_ROW "# complete 3\n");
    assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, NULL), GRAZE_EINPUT);
    assert_non_null(strstr(graze_context_message(context), ":4: rounding makes this row equal"));
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_NONE), GRAZE_OK);
}

static const char *pick(unsigned long *agree, unsigned long *wrong, int golden) {
    static const char *const words[] = {"in", "on", "out"};
    int given = draw_below(8) ? golden : (golden + 1) % 3;
    *(given == golden ? agree : wrong) += 1;
    return words[given];
}

/* Tables longer than the look-ahead, with rows dropped and added at known places. */
static void random_tables(void **state) {
    (void)state;
    static const char *const rows[] = {IN_ROW, ON_ROW, OUT_ROW};
    for (unsigned seed = 1; seed <= 40; seed++) {
        unsigned long agree = 0, wrong = 0, missing = 0, extra = 0, count = 3 + seed * 97;
        unsigned long gap = seed % 4 ? 0 : 1500; /* a run of missing rows longer than a window */
        random_start(seed);
        FILE *golden = fopen(golden_path, "w"), *candidate = fopen(candidate_path, "w");
        assert_true(golden && candidate);
        fputs(HEAD, golden);
        fputs("x,y,pmc\n", candidate);
        for (unsigned long k = 0; k < count + gap; k++) {
            int answer = (int)draw_below(3), drop = draw_below(10) == 0 || (k > 1 && k < 2 + gap);
            drop = drop && k > 0;
            fprintf(golden, "%lu/7,%u%s", k, seed, rows[answer]);
            missing += (unsigned long)drop;
            if (!drop)
                fprintf(candidate, "%lu/7,%u,%s\n", k, seed, pick(&agree, &wrong, answer));
            if (!drop && draw_below(20) == 0) {
                fprintf(candidate, "%lu/7,-1,in\n", k);
                extra++;
            }
        }
        fprintf(golden, "# complete %lu\n", count + gap);
        fclose(golden);
        fclose(candidate);
        graze_comparison_counts n = compare(NULL);
        if (n.agree != agree || n.wrong != wrong || n.missing != missing || n.extra != extra)
            fail_msg("seed %u: agree %lu wrong %lu missing %lu extra %lu; right: %lu %lu %lu %lu",
                     seed, n.agree, n.wrong, n.missing, n.extra, agree, wrong, missing, extra);
    }
}

static void report_holds(const char *part, graze_comparison_format format) {
    graze_comparison *c;
    char *text = NULL;
    graze_compare_options o = {
        .size = sizeof o, .show = 1, .solid = "it's.off", .motion = "move.json"};
    assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, &o), GRAZE_OK);
    assert_int_equal(graze_comparison_report(&text, context, c, format), GRAZE_OK);
    if (!strstr(text, part))
        fail_msg("%s\nlacks %s", text, part);
    graze_free(text);
    graze_comparison_destroy(c);
}

/* Rows are numbered as the golden table has them; what the candidate lacks is NULL. */
static void disagreements(void **state) {
    (void)state;
    graze_comparison *c;
    graze_compare_options o = {.size = sizeof o, .show = 10};
    write_file(golden_path,
               "# graze\n# operation unsweep\n# round binary64\nx,y,pmc,id\n0,0,in,a\n1,0,on,b\n"
               "2,0,in,c\n3,0,out,d\n# complete 4\n");
    write_file(candidate_path, "x,y,pmc,id\n0,0,in,a\n1,0,out,b\n3,0,out,d\n4,0,in,e\n");
    assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, &o), GRAZE_OK);
    graze_disagreement d = graze_comparison_disagreement(c, 0);
    assert_int_equal(d.row, 1);
    assert_int_equal(d.golden_line, 6);
    assert_int_equal(d.candidate_line, 3);
    assert_string_equal(d.point, "1 0");
    assert_string_equal(d.golden, "pmc=on");
    assert_string_equal(d.candidate, "pmc=out");
    d = graze_comparison_disagreement(c, 1);
    assert_int_equal(d.row, 2);
    assert_null(d.candidate);
    d = graze_comparison_disagreement(c, 2);
    assert_int_equal(d.row, 4);
    assert_null(d.golden);
    assert_string_equal(d.point, "4 0");
    assert_null(graze_comparison_disagreement(c, 3).point);
    assert_string_equal(graze_comparison_head(c), " --round binary64 --operation unsweep");
    graze_comparison_destroy(c);
}

static void reports(void **state) {
    (void)state;
    write_file(golden_path, "# folds combined\n# round binary32\n" HEAD "1/2,0" IN_ROW "2,0" ON_ROW
                            "3,0" OUT_ROW "# complete 3\n");
    write_file(candidate_path, "x,y,pmc\n1/2,0,out\n2,0,in\n");
    report_holds("| 3 | 0 | 2 | 1 | 0 | 0 |", GRAZE_COMPARISON_TEXT);
    report_holds("| in | 0 | 0 | 1 | 0 |", GRAZE_COMPARISON_TEXT);
    report_holds("| out | 0 | 0 | 0 | 1 |\n\n", GRAZE_COMPARISON_TEXT);
    report_holds("missing: 1 of 3 rows; of the others wrong: 2; pmc 2\n", GRAZE_COMPARISON_TEXT);
    report_holds("| boundary | 1 | 1 | 100.00 % | 0 | 0 |", GRAZE_COMPARISON_TEXT);
    report_holds("The first 1 of 3 disagreements", GRAZE_COMPARISON_TEXT);
    report_holds(
        "line 4 of the golden table, pmc=in class=regular definition=5 case=1 i=2 t=0 word=OBIBO\n",
        GRAZE_COMPARISON_TEXT);
    report_holds("candidate, line 2, pmc=out\n", GRAZE_COMPARISON_TEXT);
    report_holds("`graze explain 'it'\\''s.off' move.json 1/2 0 --round binary32 --folds combined`",
                 GRAZE_COMPARISON_TEXT);
    report_holds("\"wrong\": 2", GRAZE_COMPARISON_JSON);
    report_holds("\"golden-line\": 4", GRAZE_COMPARISON_JSON);
}

/* A byte order mark alone on the first line leaves a blank line, which is passed over. */
static void byte_order_mark_alone(void **state) {
    (void)state;
    write_file(golden_path, HEAD "1/2,0" IN_ROW "# complete 1\n");
    write_file(candidate_path, "\xef\xbb\xbf\nx,y,pmc\n1/2,0,in\n");
    expect(NULL, 1, 0, 0, 0, 0);
}

/* A coordinate that is no number is refused in either table, also where both have the same text. */
static void coordinates_are_numbers(void **state) {
    (void)state;
    graze_comparison *c = NULL;
    static const char *const tables[][2] = {{"zz", "zz"}, {"zz", "0"}, {"0", "zz"}};
    for (size_t k = 0; k < 3; k++) {
        char golden[200], candidate[200];
        snprintf(golden, sizeof golden, HEAD "1/2,%s" IN_ROW "# complete 1\n", tables[k][0]);
        snprintf(candidate, sizeof candidate, "x,y,pmc\n1/2,%s,in\n", tables[k][1]);
        write_file(golden_path, golden);
        write_file(candidate_path, candidate);
        assert_int_equal(graze_compare(&c, context, golden_path, candidate_path, NULL),
                         GRAZE_EINPUT);
        assert_null(c);
        assert_non_null(strstr(graze_context_message(context), ":2: y: 'zz' is not a number"));
    }
}

/* Numbers go by value, and groups past the limit are counted as one. */
static void tallies(void **state) {
    (void)state;
    tally t = {0};
    char name[24];
    for (int k = MOST_GROUPS + 5; k > 0; k--) {
        snprintf(name, sizeof name, "%d", k);
        assert_int_equal(
            tally_add(&t, context, (field){name, strlen(name)}, k % 2 ? 'w' : 'm', NULL), 0);
    }
    tally_sort(&t);
    assert_int_equal(t.count, MOST_GROUPS);
    assert_int_equal(t.others.rows, 5);
    assert_int_equal(t.others.wrong, 3);
    assert_int_equal(t.others.missing, 2);
    assert_string_equal(t.groups[0].name, "6");
    assert_string_equal(t.groups[94].name, "100");
    tally_clear(&t);
    static const char *const names[] = {"ext", "10", "9", "", "5"};
    static const char *const sorted[] = {"", "5", "9", "10", "ext"};
    tally mixed = {0};
    for (int k = 0; k < 5; k++)
        assert_int_equal(tally_add(&mixed, context, (field){names[k], strlen(names[k])}, 'w', NULL),
                         0);
    tally_sort(&mixed);
    for (int k = 0; k < 5; k++)
        assert_string_equal(mixed.groups[k].name, sorted[k]);
    tally_clear(&mixed);
}

static void misuse(void **state) {
    (void)state;
    graze_comparison *c = NULL;
    char *text = NULL;
    graze_compare_options o = {.size = sizeof o, .question = (graze_question)7};
    assert_int_equal(graze_compare(NULL, context, "a", "b", NULL), GRAZE_EUSE);
    assert_int_equal(graze_compare(&c, context, NULL, "b", NULL), GRAZE_EUSE);
    assert_int_equal(graze_compare(&c, context, "a", "b", &o), GRAZE_EUSE);
    assert_null(c);
    assert_int_equal(graze_comparison_report(&text, context, NULL, GRAZE_COMPARISON_TEXT),
                     GRAZE_EUSE);
    assert_int_equal(graze_comparison_count(NULL).rows, 0);
    graze_comparison_destroy(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_are_judged_each),
        cmocka_unit_test(on_counts_as),
        cmocka_unit_test(distances),
        cmocka_unit_test(closed_question),
        cmocka_unit_test(closed_question_of_carried_columns),
        cmocka_unit_test(closed_question_in_space),
        cmocka_unit_test(closed_question_of_other_words),
        cmocka_unit_test(rows_missing_and_extra),
        cmocka_unit_test(ids_match),
        cmocka_unit_test(contact_points),
        cmocka_unit_test(rounding_matches),
        cmocka_unit_test(random_tables),
        cmocka_unit_test(reports),
        cmocka_unit_test(disagreements),
        cmocka_unit_test(byte_order_mark_alone),
        cmocka_unit_test(coordinates_are_numbers),
        cmocka_unit_test(tallies),
        cmocka_unit_test(misuse),
    };
    return cmocka_run_group_tests(tests, set_up_files, tear_down_files);
}
