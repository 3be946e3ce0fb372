/* Rows of values that are turned into VTK and npy: whatever they say of themselves is checked
 * before it is used. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

/* Rows of the square [0, 2]^2 that moves by 8 along x: four points, which are a grid, and two
 * further columns. */
enum { ROWS = 4 };
static const char *const names = "note,n";
static const double at[2 * ROWS] = {0, 0, 8, 0, 0, 0.5, 8, 0.5};
static const graze_row_texts good[ROWS] = {
    {NULL, "a,1"}, {NULL, "\"b, c\",1/3"}, {NULL, "5\" pipe,2.5"}, {NULL, ",-1e2"}};

static const graze_row_options npy = {.size = sizeof npy, .format = GRAZE_FORMAT_NPY};
static const graze_row_options vtk = {.size = sizeof vtk, .format = GRAZE_FORMAT_VTK};

/* The rows with these texts; `y` in place of the third point's 1/2, unless it is NULL. */
static graze_status make_rows(char **out, size_t *length, const scene *s,
                              const graze_row_texts *texts, const char *y) {
    mpq_t point[2 * ROWS];
    size_t done;
    for (int k = 0; k < 2 * ROWS; k++) {
        mpq_init(point[k]);
        mpq_set_d(point[k], at[k]);
    }
    if (y)
        assert_int_equal(graze_number_parse(point[5], s->context, y, strlen(y)), GRAZE_OK);
    graze_status status = graze_report_points(out, length, &done, NULL, s->context, s->scene,
                                              (graze_rationals)point, ROWS, texts, &npy);
    for (int k = 0; k < 2 * ROWS; k++)
        mpq_clear(point[k]);
    return status;
}

static graze_grid *make_grid(const scene *s, size_t columns) {
    const size_t size[2] = {columns, 2};
    graze_grid *grid;
    mpq_t low[2], high[2];
    mpq_inits(low[0], low[1], high[0], high[1], NULL);
    mpq_set_si(high[0], 8, 1);
    mpq_set_si(high[1], 1, 2);
    assert_int_equal(graze_grid_create(&grid, s->context, s->scene, size, low, high), GRAZE_OK);
    mpq_clears(low[0], low[1], high[0], high[1], NULL);
    return grid;
}

static graze_status export(char **out, size_t *length, const scene *s, const char *rows,
                           size_t rows_length, const char *columns, const graze_grid *grid,
                           const graze_row_options *options) {
    /* bytes of their own, so that a sanitizer sees a read past their end */
    char *copy = malloc(rows_length ? rows_length : 1);
    assert_non_null(copy);
    memcpy(copy, rows, rows_length);
    graze_status status = graze_report_export(out, length, s->context, s->scene, copy, rows_length,
                                              columns, grid, options);
    free(copy);
    return status;
}

static void expect(graze_status status, const scene *s, const char *out, size_t length,
                   const char *says) {
    assert_int_equal(status, GRAZE_EINPUT);
    assert_null(out);
    assert_int_equal(length, 0);
    if (!strstr(graze_context_message(s->context), says))
        fail_msg("%s; expected %s", graze_context_message(s->context), says);
}

/* No beginning of the rows is whole but at the end of a row: after r rows of the four lengths. */
static void cut_anywhere(void **state) {
    (void)state;
    scene s;
    char *rows, *out;
    size_t whole, length, ends = 0;
    scene_open(&s, slide, NULL);
    assert_int_equal(make_rows(&rows, &whole, &s, good, NULL), GRAZE_OK);
    graze_grid *grid = make_grid(&s, 2);
    for (size_t k = 0; k <= whole; k++) {
        graze_status status = export(&out, &length, &s, rows, k, names, NULL, &npy);
        if (status)
            expect(status, &s, out, length, "is not whole");
        ends += !status;
        graze_free(out);
        status = export(&out, &length, &s, rows, k, names, grid, &vtk);
        assert_int_equal(status, k < whole ? GRAZE_EINPUT : GRAZE_OK);
        graze_free(out);
    }
    assert_int_equal(ends, ROWS + 1);
    graze_grid_destroy(grid);
    graze_free(rows);
    scene_close(&s);
}

/* Rows of other columns, of another grid, with a line end in a text, and names of no columns. */
static void rows_refused(void **state) {
    (void)state;
    static const graze_row_options alone = {
        .size = sizeof alone, .format = GRAZE_FORMAT_VTK, .columns = GRAZE_COLUMNS_PMC};
    scene s;
    char *rows, *out = NULL;
    size_t whole, length = 0;
    scene_open(&s, slide, NULL);
    assert_int_equal(make_rows(&rows, &whole, &s, good, NULL), GRAZE_OK);
    graze_grid *wide = make_grid(&s, 3), *grid = make_grid(&s, 2);
    expect(export(&out, &length, &s, rows, whole, NULL, NULL, &npy), &s, out, length, "row 2");
    expect(export(&out, &length, &s, rows, whole, "note", NULL, &npy), &s, out, length, "row 1");
    expect(export(&out, &length, &s, rows, whole, "note,n,m", NULL, &npy), &s, out, length,
           "row 1 is not whole; expected 12 columns");
    expect(export(&out, &length, &s, rows, whole, names, NULL, &alone), &s, out, length, "row");
    expect(export(&out, &length, &s, rows, whole, names, wide, &npy), &s, out, length,
           "4 rows; expected the 6 of the grid");
    expect(export(&out, &length, &s, rows, whole, "\"note,n", NULL, &npy), &s, out, length,
           "a quote");
    char *place = memchr(rows, 'p', whole); /* of `pipe` */
    assert_non_null(place);
    *place = '\n';
    expect(export(&out, &length, &s, rows, whole, names, NULL, &npy), &s, out, length, "row 3");
    memset(rows, 0xff, whole);
    expect(export(&out, &length, &s, rows, whole, names, grid, &npy), &s, out, length, "row 1");
    graze_grid_destroy(grid);
    graze_grid_destroy(wide);
    graze_free(rows);
    scene_close(&s);
}

static int holds(const char *bytes, size_t length, const void *part, size_t part_length) {
    for (size_t k = 0; k + part_length <= length; k++)
        if (memcmp(bytes + k, part, part_length) == 0)
            return 1;
    return 0;
}

/* Further columns keep their fields: a quote within an unquoted field is a letter of it, and a
 * column without a name is one. Their numbers are not rounded as the scene's are: 1/3 stays the
 * nearest binary64, and a number past binary32 stays itself. */
static void further_columns(void **state) {
    (void)state;
    scene s;
    graze_row_texts texts[ROWS];
    char *out, *rows;
    size_t length, whole;
    double third = 1.0 / 3, large = 1e300;
    memcpy(texts, good, sizeof texts);
    texts[2].rest = "5\" pipe,1e300";
    scene_open(&s, slide, NULL);
    assert_int_equal(graze_context_set_rounding(s.context, GRAZE_ROUND_BINARY32), GRAZE_OK);
    assert_int_equal(make_rows(&rows, &whole, &s, texts, NULL), GRAZE_OK);
    assert_int_equal(export(&out, &length, &s, rows, whole, names, NULL, &npy), GRAZE_OK);
    assert_true(holds(out, length, "5\" pipe", 7));
    assert_true(holds(out, length, &third, sizeof third));
    assert_true(holds(out, length, &large, sizeof large));
    graze_free(out);
    assert_int_equal(export(&out, &length, &s, rows, whole, "note,", NULL, &npy), GRAZE_OK);
    assert_true(holds(out, length, "('note', '|S7'), ('column', '<f8')", 33));
    graze_free(out);
    graze_free(rows);
    scene_close(&s);
}

/* Numbers at the ends of the range of binary64. Its largest is M = 2^1024 - 2^971 and its least
 * 2^-1074; the number halfway from M to 2^1024 is 2^1024 - 2^970 =
 * 1.797693134862315807937289714...e308, and half of the least is 2^-1075 =
 * 2.470328229206232720882843964...e-324: both ties go to the even neighbour, 2^1024 and 0. */
static const struct {
    const char *number;
    double nearest;
} extreme[] = {
    {"1.7976931348623158e308", 0x1.fffffffffffffp1023}, /* above M = 1.79769313486231570...e308 */
    {"-1.7976931348623158e308", -0x1.fffffffffffffp1023},
    {"1.797693134862315807937289714e308", 0x1.fffffffffffffp1023}, /* below halfway to 2^1024 */
    {"5e-324", 0x1p-1074},                                         /* 2^-1074 = 4.94...e-324 */
    {"3e-324", 0x1p-1074},
    {"-3e-324", -0x1p-1074},
    {"2.4703282292062328e-324", 0x1p-1074}, /* above half of the least */
    {"8e-324", 0x1p-1073},                  /* above 1.5 * 2^-1074 = 7.41...e-324 */
    {"7e-324", 0x1p-1074},
    {"2.4703282292062327e-324", 0}, /* below half of the least */
    {"2e-324", 0},
    {"1e-20000", 0},
    {"-1e-20000", 0},
};

static const char *const too_large[] = {
    "1.797693134862315808e308",
    "-1.797693134862315808e308", /* above halfway to 2^1024 */
    "1e400",
    "1e20000",
    "-1e20000",
};

/* The value of the last column in row 3 as an array: rows of one length, whose last eight bytes are
 * that column, little-endian. */
static double value_of_row_3(const char *npy, size_t length) {
    size_t head = 12 + (unsigned char)npy[8] + 256 * (size_t)(unsigned char)npy[9];
    size_t end = head + (length - head) / 4 * 3;
    uint64_t bits = 0;
    double value;
    for (int k = 1; k <= 8; k++)
        bits = bits << 8 | (unsigned char)npy[end - (size_t)k];
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* A scene whose context takes numbers of 100,000 digits and would round those of a scene. */
static void open_wide(scene *s, graze_rounding rounding) {
    scene_open(s, slide, NULL);
    assert_int_equal(graze_context_set_limit(s->context, GRAZE_LIMIT_DIGITS, 100000), GRAZE_OK);
    assert_int_equal(graze_context_set_rounding(s->context, rounding), GRAZE_OK);
}

/* The array of the rows with a number in the last column of row 3. */
static graze_status export_number(char **out, size_t *length, const scene *s, const char *number,
                                  const graze_row_options *options) {
    char rest[700], *rows;
    size_t whole;
    graze_row_texts texts[ROWS];
    memcpy(texts, good, sizeof texts);
    snprintf(rest, sizeof rest, "5\" pipe,%s", number);
    texts[2].rest = rest;
    assert_int_equal(make_rows(&rows, &whole, s, texts, NULL), GRAZE_OK);
    graze_status status = export(out, length, s, rows, whole, names, NULL, options);
    graze_free(rows);
    return status;
}

static void ends_of_the_range(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof extreme / sizeof *extreme; k++) {
        scene s;
        char *out;
        size_t length;
        open_wide(&s, (graze_rounding)(k % 3));
        if (export_number(&out, &length, &s, extreme[k].number, &npy))
            fail_msg("%s: %s", extreme[k].number, graze_context_message(s.context));
        double got = value_of_row_3(out, length);
        if (memcmp(&got, &extreme[k].nearest, sizeof got) != 0)
            fail_msg("%s: %a, expected %a", extreme[k].number, got, extreme[k].nearest);
        graze_free(out);
        scene_close(&s);
    }
}

/* A number of a column, or a coordinate, whose row is not made. */
static void past_the_range(void **state) {
    (void)state;
    for (size_t k = 0; k < 2 * (sizeof too_large / sizeof *too_large); k++) {
        const char *number = too_large[k / 2];
        scene s;
        char says[160], *out;
        size_t length;
        open_wide(&s, (graze_rounding)(k % 3));
        snprintf(says, sizeof says,
                 "row 3, column n: '%s'; expected a number that binary64 can hold", number);
        graze_status status = export_number(&out, &length, &s, number, k & 1 ? &npy : &vtk);
        expect(status, &s, out, length, says);
        assert_int_equal(graze_context_set_rounding(s.context, GRAZE_ROUND_NONE), GRAZE_OK);
        assert_int_equal(make_rows(&out, &length, &s, good, number), GRAZE_EINPUT);
        assert_string_equal(graze_context_message(s.context),
                            "column y: expected a number that binary64 can hold");
        assert_true(out != NULL && length > 0); /* two rows */
        graze_free(out);
        scene_close(&s);
    }
    scene s;
    char *out;
    size_t length;
    scene_open(&s, slide, NULL);
    graze_status status = export_number(&out, &length, &s, "1e1000000000", &npy);
    assert_int_equal(status, GRAZE_ELIMIT);
    assert_non_null(strstr(graze_context_message(s.context), "row 3, column n"));
    assert_null(out);
    scene_close(&s);
}

/* sign (2^power - 2^less), or with a negative power 1 / 2^-power, exactly; for free. */
static char *power_text(int sign, long power, unsigned long less) {
    mpq_t value;
    mpz_t low;
    char *text = NULL;
    mpq_init(value);
    mpz_init(low);
    mpz_ui_pow_ui(mpq_numref(value), 2, power < 0 ? 0 : (unsigned long)power);
    mpz_ui_pow_ui(mpq_denref(value), 2, power < 0 ? (unsigned long)-power : 0);
    mpz_ui_pow_ui(low, 2, less);
    if (less)
        mpz_sub(mpq_numref(value), mpq_numref(value), low);
    if (sign < 0)
        mpq_neg(value, value);
    assert_true(gmp_asprintf(&text, "%Qd", value) > 0);
    mpz_clear(low);
    mpq_clear(value);
    return text;
}

/* Exact ties, and the largest number itself. */
static void ties_at_the_ends(void **state) {
    (void)state;
    static const struct {
        long power;
        unsigned long less;
        double nearest; /* 1: none */
    } tie[] = {{1024, 971, 0x1.fffffffffffffp1023}, {1024, 970, 1}, {1024, 0, 1}, {-1075, 0, 0}};
    for (size_t k = 0; k < 2 * (sizeof tie / sizeof *tie); k++) {
        scene s;
        int sign = k & 1 ? -1 : 1;
        char *number = power_text(sign, tie[k / 2].power, tie[k / 2].less), *out;
        size_t length;
        int refused = tie[k / 2].nearest == 1;
        open_wide(&s, GRAZE_ROUND_NONE);
        graze_status status = export_number(&out, &length, &s, number, &npy);
        assert_int_equal(status, refused ? GRAZE_EINPUT : GRAZE_OK);
        if (!refused)
            assert_true(value_of_row_3(out, length) == sign * tie[k / 2].nearest);
        graze_free(out);
        free(number);
        scene_close(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_anywhere),    cmocka_unit_test(rows_refused),
        cmocka_unit_test(further_columns), cmocka_unit_test(ends_of_the_range),
        cmocka_unit_test(past_the_range),  cmocka_unit_test(ties_at_the_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
