/* Decimals of times, formulas, rows and the explanation, on traces made by hand.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/harness.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "output/report/report.h"
#include "output/report/row_parts.h"

static void set(fmpq_t out, const char *text) {
    assert_int_equal(fmpq_set_str(out, text, 10), 0);
    fmpq_canonicalise(out);
}

/* A translation by (4t, 0) on [1, 3] in the piece's parameter u = (t - 1)/2, and its inverse. */
static void make_motion(graze_motion *m, motion_piece *piece) {
    memset(m, 0, sizeof *m);
    m->dimension = 2;
    m->piece_count = 1;
    m->piece = piece;
    fmpq_init(piece->lo);
    fmpq_init(piece->hi);
    set(piece->lo, "1");
    set(piece->hi, "3");
    for (int side = 0; side < 2; side++) {
        point_map *map = side ? &piece->inverse : &piece->forward;
        map->dimension = 2;
        for (int k = 0; k < 12; k++)
            fmpz_poly_init(&map->entry[k]);
        fmpz_poly_init(map->weight);
        fmpz_poly_set_si(&map->entry[0], 1);
        fmpz_poly_set_si(&map->entry[4], 1);
        fmpz_poly_set_coeff_si(&map->entry[2], 0, side ? -4 : 4);
        fmpz_poly_set_coeff_si(&map->entry[2], 1, side ? -8 : 8);
        fmpz_poly_set_si(map->weight, 1);
    }
}

static void clear_motion(motion_piece *piece) {
    fmpq_clear(piece->lo);
    fmpq_clear(piece->hi);
    for (int k = 0; k < 12; k++) {
        fmpz_poly_clear(&piece->forward.entry[k]);
        fmpz_poly_clear(&piece->inverse.entry[k]);
    }
    fmpz_poly_clear(piece->forward.weight);
    fmpz_poly_clear(piece->inverse.weight);
}

static void make_time(graze_time *time, const graze_motion *motion, const char *value) {
    memset(time, 0, sizeof *time);
    time->motion = motion;
    algebraic_init(&time->u);
    fmpz_poly_init(time->poly);
    fmpq_init(time->low);
    fmpq_init(time->high);
    if (value) {
        fmpq_t u;
        fmpq_init(u);
        set(u, value);
        algebraic_set_rational(&time->u, u);
        fmpq_clear(u);
    } else {
        /* 2u^2 - 1 = 0 in (0, 1), that is t = 1 + sqrt(2), a root of t^2 - 2t - 1. */
        fmpz_poly_set_str(time->u.poly, "3  -1 0 2");
        dyadic_interval_set_si(&time->u.where, 0, 1);
        time->u.low_sign = -1;
    }
}

static void clear_time(graze_time *time) {
    algebraic_clear(&time->u);
    fmpz_poly_clear(time->poly);
    fmpq_clear(time->low);
    fmpq_clear(time->high);
}

static void decimal_of_a_root(void **state) {
    (void)state;
    graze_motion motion;
    motion_piece piece;
    graze_time time;
    int exact = 1;
    make_motion(&motion, &piece);
    make_time(&time, &motion, NULL);
    char *text = decimal_of_time(&exact, &time, 40); /* 1 + sqrt(2) */
    assert_string_equal(text, "2.414213562373095048801688724209698078570");
    assert_int_equal(exact, 0);
    free(text);
    assert_int_equal(time_is_rational(&time), 0);
    clear_time(&time);
    make_time(&time, &motion, "1/4");
    text = decimal_of_time(&exact, &time, 40); /* t = 1 + 2/4 */
    assert_string_equal(text, "1.5");
    assert_int_equal(exact, 1);
    free(text);
    clear_time(&time);
    clear_motion(&piece);
}

static void expect_formula(const motion_piece *piece, const point_map *map, int coordinate,
                           const fmpq *point, const char *expected) {
    text t;
    text_init(&t);
    formula_coordinate(&t, piece, map, coordinate, point);
    assert_string_equal(t.data, expected);
    text_clear(&t);
}

/* x - 4t, since u = (t - 1)/2 turns -4 - 8u into -4t. */
static void formulas(void **state) {
    (void)state;
    graze_motion motion;
    motion_piece piece;
    make_motion(&motion, &piece);
    fmpq point[2];
    fmpq_init(point);
    fmpq_init(point + 1);
    set(point, "1/2");
    set(point + 1, "-3");
    expect_formula(&piece, &piece.inverse, 0, point, "-4*t + 1/2");
    expect_formula(&piece, &piece.inverse, 1, point, "-3");
    /* A weight 1 + u = (t + 1)/2 makes (1/2 - 4t)/((t + 1)/2) = (-8t + 1)/(t + 1). */
    fmpz_poly_set_str(piece.inverse.weight, "2  1 1");
    expect_formula(&piece, &piece.inverse, 0, point, "(-8*t + 1)/(t + 1)");
    expect_formula(&piece, &piece.inverse, 1, point, "-6/(t + 1)");
    /* A common factor goes out: entry 2 (1 + u) over 1 + u. */
    for (int k = 3; k < 6; k++)
        fmpz_poly_zero(&piece.inverse.entry[k]);
    fmpz_poly_set_str(&piece.inverse.entry[5], "2  2 2");
    expect_formula(&piece, &piece.inverse, 1, point, "2");
    text t;
    text_init(&t);
    set(point, "12345678901234567890123456789012345678901234567890/7");
    formula_rational(&t, point);
    assert_string_equal(t.data, "123456789012...901234567890[50 digits]/7");
    text_clear(&t);
    fmpz_poly_t long_one;
    fmpz_poly_init(long_one);
    for (int k = 0; k <= 10; k++)
        fmpz_poly_set_coeff_si(long_one, k, k % 2 ? -1 : 1);
    text_init(&t);
    formula_polynomial(&t, long_one);
    assert_string_equal(t.data, "t^10 - t^9 + t^8 + ... [5 terms left out] ... + t^2 - t + 1");
    text_clear(&t);
    fmpz_poly_clear(long_one);
    fmpq_clear(point);
    fmpq_clear(point + 1);
    clear_motion(&piece);
}

/* OBIBO with an instant at u = 1/4 and a slide from the root to u = 1, so that every form of a time
 * and of a cell is written. */
typedef struct fixture {
    graze_motion motion;
    motion_piece piece;
    graze_solid solid;
    graze_scene scene;
    graze_time time[3];
    contact contacts[2];
    graze_cell cells[3];
    graze_trace trace;
    fmpq point[2];
    graze_context *context;
} fixture;

static void open_fixture(fixture *f) {
    memset(f, 0, sizeof *f);
    make_motion(&f->motion, &f->piece);
    make_time(&f->time[0], &f->motion, "1/4");
    make_time(&f->time[1], &f->motion, NULL);
    make_time(&f->time[2], &f->motion, "1");
    f->cells[0] = (graze_cell){GRAZE_CELL_FACE, 3, 0};
    f->cells[1] = (graze_cell){GRAZE_CELL_EDGE, 1, 2};
    f->cells[2] = (graze_cell){GRAZE_CELL_VERTEX, 7, 0};
    f->contacts[0] =
        (contact){GRAZE_STATE_O, GRAZE_STATE_I, &f->time[0], &f->time[0], f->cells, 1, 1};
    f->contacts[1] =
        (contact){GRAZE_STATE_I, GRAZE_STATE_ABSENT, &f->time[1], &f->time[2], f->cells + 1, 2, 2};
    f->solid.input.dimension = 2;
    f->scene.solid = &f->solid;
    f->scene.motion = &f->motion;
    f->trace.first = GRAZE_STATE_O;
    f->trace.last = GRAZE_STATE_B;
    f->trace.contact_count = 2;
    f->trace.contact = f->contacts;
    f->trace.word = (char *)"OBIB";
    f->trace.verdict = (graze_verdict){GRAZE_IN, GRAZE_REGULAR, 5, 2, 2, 0};
    fmpq_init(f->point);
    fmpq_init(f->point + 1);
    set(f->point, "1/2");
    set(f->point + 1, "-3");
    assert_int_equal(graze_context_create(&f->context), GRAZE_OK);
}

static void close_fixture(fixture *f) {
    graze_context_destroy(f->context);
    for (int k = 0; k < 3; k++)
        clear_time(&f->time[k]);
    fmpq_clear(f->point);
    fmpq_clear(f->point + 1);
    clear_motion(&f->piece);
}

static const graze_row_options all_answers = {.size = sizeof all_answers};

static row row_of(const fixture *f, const char *rest) {
    return (row){.scene = &f->scene,
                 .shown = &all_answers,
                 .point = f->point,
                 .trace = &f->trace,
                 .texts = {NULL, rest}};
}

static char *csv_row(fixture *f, const char *rest) {
    char *out;
    text line;
    row r = row_of(f, rest);
    text_init(&line);
    report_csv(&line, &r);
    assert_int_equal(text_finish(&out, f->context, &line), GRAZE_OK);
    return out;
}

static void rows(void **state) {
    (void)state;
    fixture f;
    char *out;
    open_fixture(&f);
    out = csv_row(&f, "a,\"b\"");
    assert_string_equal(out, "1/2,-3,in,regular,5,2,2,0,OBIB,a,\"b\"\n");
    free(out);
    f.trace.verdict.definition = 0;
    f.trace.verdict.case_ = 8;
    out = csv_row(&f, NULL);
    assert_string_equal(out, "1/2,-3,in,regular,ext,8,2,0,OBIB\n");
    free(out);
    row r = row_of(&f, NULL);
    r.texts.point = "0.5,-3"; /* as given */
    text line;
    text_init(&line);
    report_csv(&line, &r);
    assert_string_equal(line.data, "0.5,-3,in,regular,ext,8,2,0,OBIB\n");
    line.length = 0;
    report_json(&line, &r);
    assert_int_equal(text_finish(&out, f.context, &line), GRAZE_OK);
    /* 1 + sqrt(2) = 2.41421356237309504880...; t^2 - 2t - 1 has its other root at -0.414, so (2, 3)
     * is the widest dyadic interval that isolates it. */
    assert_string_equal(
        out,
        "{\"point\":[\"1/2\",\"-3\"],\"pmc\":\"in\",\"class\":\"regular\",\"definition\":\"ext\","
        "\"case\":8,\"i\":2,\"t\":0,\"word\":\"OBIB\",\"contacts\":["
        "{\"kind\":\"intersection\",\"left\":\"O\",\"right\":\"I\",\"from\":\"3/2\","
        "\"to\":\"3/2\",\"features\":[{\"face\":3}]},"
        "{\"kind\":\"intersection\",\"left\":\"I\",\"right\":null,"
        "\"from\":{\"poly\":[\"-1\",\"-2\",\"1\"],\"lo\":\"2\",\"hi\":\"3\","
        "\"approx\":\"2.4142135623730950\"},\"to\":\"3\","
        "\"features\":[{\"edge\":[1,2]},{\"vertex\":7}]}]}\n");
    free(out);
    f.scene.options.operation = GRAZE_UNSWEEP;
    out = csv_row(&f, NULL);
    assert_string_equal(out, "1/2,-3,in,OBIB\n");
    free(out);
    close_fixture(&f);
}

/* Readers have room for the names of all sets together. */
static void column_names(void **state) {
    (void)state;
    const column_label *name[COLUMNS_MOST];
    size_t count = columns_names(name, ~0u);
    assert_true(count < COLUMNS_MOST);
    for (size_t k = 0; k < count; k++)
        assert_ptr_equal(columns_known(k).name, name[k]->name);
    assert_null(columns_known(count).name);
    assert_string_equal(columns_known(columns_place("topo")).name, "topo");
    assert_int_equal(columns_known(columns_place("topo")).bit, 1u << 4);
    assert_int_equal(columns_names(name, 1), 3);
    assert_int_equal(columns_of_line((field){"# topo yes", 10}), 1u << 4);
    assert_int_equal(columns_of_line((field){"# topo no", 9}), 0);
    assert_int_equal(columns_of_line((field){"# sdf 1e-6", 10}), 1u);
}

static void head(void **state) {
    (void)state;
    fixture f;
    char *out;
    open_fixture(&f);
    f.scene.ends = GRAZE_ENDS_MEET;
    f.scene.options.folds = GRAZE_FOLDS_COMBINED;
    for (int k = 0; k < 32; k++)
        f.motion.sha256[k] = (unsigned char)(16 * k + k % 16);
    assert_int_equal(report_header(&out, f.context, &f.scene, "# grid 2,2\n", "name", &all_answers),
                     GRAZE_OK);
    static const char *const parts[] = {"# graze " GRAZE_VERSION "\n# contract 1\n# dimension 2\n",
                                        "# solid-sha256 none\n", "# motion-sha256 0011223344",
                                        "# operation sweep\n# overlap extend\n# folds combined\n"
                                        "# round none\n# grid 2,2\n# ends-meet yes\n"
                                        "x,y,pmc,class,definition,case,i,t,word,name\n"};
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (!strstr(out, parts[k]))
            fail_msg("%s lacks %s", out, parts[k]);
    free(out);
    f.scene.options.operation = GRAZE_UNSWEEP;
    assert_int_equal(graze_context_set_rounding(f.context, GRAZE_ROUND_BINARY32), GRAZE_OK);
    assert_int_equal(report_header(&out, f.context, &f.scene, NULL, NULL, &all_answers), GRAZE_OK);
    assert_non_null(strstr(out, "# operation unsweep\n"));
    assert_non_null(strstr(out, "# round binary32\n# ends-meet yes\nx,y,pmc,word\n"));
    free(out);
    close_fixture(&f);
}

static void explanation(void **state) {
    (void)state;
    fixture f;
    char *out;
    open_fixture(&f);
    row r = row_of(&f, NULL);
    assert_int_equal(report_explain(&out, f.context, &r), GRAZE_OK);
    static const char *const parts[] = {
        "P = (1/2, -3) is `in` for the sweep, class `regular`. Its word is OBIB.\n",
        "  t0 = 1  c(t0) = (-7/2, -3) is outside S, so P is outside S^0\n",
        "  t1 = 3  c(t1) = (-23/2, -3) is on the boundary of S, so P is on the boundary of S^1\n",
        "case 2 of Table 1",
        "    x = -4*t + 1/2\n    y = -3\n",
        "  B  at t = 3/2 = 1.5\n       it meets face 3\n       intersection: O before and I after",
        ("  B  from t = about 2.41421356237, the one root of t^2 - 2*t - 1 between 2 and 3\n"
         "     to t = 3\n       it meets edge 1-2, vertex 7\n"),
        "intersection: the motion ends here, and I came before ([EI] Definition 3)\n",
        "  k = 1: the number of visits of P to the interior of S; a tangency from inside ends "
        "none\n  k = (i + a + b) / 2 = (2 + 0 + 0) / 2,",
        "k = 1 and t = 0: P is a regular point (Definition 5) in case 2\n",
    };
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (!strstr(out, parts[k]))
            fail_msg("%s\nlacks %s", out, parts[k]);
    free(out);
    f.scene.options.operation = GRAZE_UNSWEEP;
    f.trace.verdict = (graze_verdict){GRAZE_OUT, GRAZE_CLASS_NONE, 0, 0, 2, 0};
    assert_int_equal(report_explain(&out, f.context, &r), GRAZE_OK);
    assert_non_null(strstr(out, "    x = 4*t + 1/2\n"));
    assert_non_null(strstr(out, "([IS] eqs 12, 13, 35)\n  pmc `out`: the word holds an O"));
    assert_null(strstr(out, "Definition"));
    free(out);
    close_fixture(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decimal_of_a_root),
        cmocka_unit_test(formulas),
        cmocka_unit_test(rows),
        cmocka_unit_test(column_names),
        cmocka_unit_test(head),
        cmocka_unit_test(explanation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
