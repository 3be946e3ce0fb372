/* Tables that are turned into VTK and npy: whatever a table says of itself is checked before it is
 * used.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walk.h"

/* Four corners of a grid of the square [0, 1]^2 that moves by 8 along x, and two further columns.
 */
static const char good[] = "# graze 0.1.0\n"
                           "# contract 1\n"
                           "# dimension 2\n"
                           "# operation sweep\n"
                           "# grid 2,2\n"
                           "# box 0,0,8,1/2\n"
                           "x,y,pmc,class,definition,case,i,t,word,note,n\n"
                           "0,0,on,boundary,8,4,0,1,BO,a,1\n"
                           "8,0,on,boundary,8,2,0,1,OB,\"b, c\",1/3\n"
                           "0,1/2,in,regular,5,7,1,0,IBO,5\" pipe,2.5\n"
                           "8,1/2,in,regular,ext,3,1,0,OBI,,-1e2\n"
                           "# complete 4\n";

typedef struct change {
    const char *from, *to;
    graze_status status;
    const char *says;
} change;

#define FORTY "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,"

static const change changes[] = {
    {"# dimension 2\n# operation sweep\n# grid 2,2\n# box 0,0,8,1/2\n",
     "# dimension 40\n# box " FORTY FORTY "1\n", GRAZE_EINPUT, "# dimension 40"},
    {"# dimension 2", "# dimension 2147483648", GRAZE_EINPUT, "# dimension 2147483648"},
    {"# dimension 2", "# dimension 18446744073709551618", GRAZE_EINPUT, "expected 2 or 3"},
    {"# dimension 2", "# dimension 0", GRAZE_EINPUT, "expected 2 or 3"},
    {"# dimension 2\n# operation sweep\n# grid 2,2\n# box 0,0,8,1/2\n",
     "# dimension 6\n# box 0,0,0,0,0,0,1,1,1,1,1,1\n", GRAZE_EINPUT,
     "# dimension 6: expected 2 or 3"},
    {"# dimension 2", "# dimension 9", GRAZE_EINPUT, "# dimension 9: expected 2 or 3"},
    {"# dimension 2", "# dimension 2x", GRAZE_EINPUT, "expected 2 or 3"},
    {"# dimension 2", "# dimension 3", GRAZE_EINPUT, "# grid"},
    {"# dimension 2\n", "", GRAZE_EINPUT, "dimension"},
    {"# box", "# dimension 2\n# box", GRAZE_EINPUT, "twice"},
    {"# box", "# grid 2,2\n# box", GRAZE_EINPUT, "twice"},
    {"# box 0,0,8,1/2\n", "# box 0,0,8,1/2\n# box 0,0,8,1\n", GRAZE_EINPUT, "twice"},
    {"# box", "# columns pmc\n# columns pmc\n# box", GRAZE_EINPUT, "# columns stands there twice"},
    {"# box", "# columns word\n# box", GRAZE_EINPUT, "# columns word: expected pmc"},
    {"# grid 2,2", "# grid 4", GRAZE_EINPUT, "expected 2 whole numbers"},
    {"# grid 2,2", "# grid 2,2,1", GRAZE_EINPUT, "expected 2 whole numbers"},
    {"# grid 2,2", "# grid 4,1", GRAZE_EINPUT, "expected 2 whole numbers"},
    {"# grid 2,2", "# grid 0,0", GRAZE_EINPUT, "expected 2 whole numbers"},
    {"# grid 2,2", "# grid -2,-2", GRAZE_EINPUT, "expected 2 whole numbers"},
    {"# grid 2,2", "# grid 2,3", GRAZE_EINPUT, "than its grid"},
    /* 2^33 * 2^31 = 2^64 */
    {"# grid 2,2", "# grid 8589934592,2147483648", GRAZE_EINPUT, "than its grid"},
    /* (2^64 + 4) / 10 * 10 is 4 in 64 bits: 1844674407370955162 * 10 = 2^64 + 4 */
    {"# grid 2,2", "# grid 1844674407370955162,10", GRAZE_EINPUT, "than its grid"},
    {"# grid 2,2", "# grid 18446744073709551618,2", GRAZE_EINPUT, "expected 2 whole numbers"},
    {"# box 0,0,8,1/2", "# box 0,0,8", GRAZE_EINPUT, "expected 4 numbers"},
    {"# box 0,0,8,1/2", "# box 0,0,8,1,1", GRAZE_EINPUT, "expected 4 numbers"},
    {"# box 0,0,8,1/2", "# box 0,0,8,one", GRAZE_EINPUT, "one"},
    {"# box 0,0,8,1/2", "# box 0,0,8,1/0", GRAZE_EINPUT, "1/0"},
    {"# box 0,0,8,1/2", "# box 0,0,8,1e1000000000", GRAZE_ELIMIT, "digits"},
    {"# box 0,0,8,1/2", "# box 0,0,0,1/2", GRAZE_EINPUT, "box is empty"},
    {"# box 0,0,8,1/2\n", "", GRAZE_EINPUT, "without # box"},
    {"# grid 2,2\n", "", GRAZE_EINPUT, "without # grid"},
    {"x,y,pmc,class,definition,case,i,t,word,note,n\n", "", GRAZE_EINPUT, "column line"},
    {"x,y,pmc", "y,x,pmc", GRAZE_EINPUT, "column line"},
    {"x,y,pmc", "x,y,z,pmc", GRAZE_EINPUT, "column line"},
    {"i,t,word", "i,word", GRAZE_EINPUT, "column line"},
    {",a,1\n", ",a\n", GRAZE_EINPUT, "row 1"},
    {",a,1\n", ",a,1,\n", GRAZE_EINPUT, "row 1"},
    {",a,1\n", "\n", GRAZE_EINPUT, "row 1"},
    {",\"b, c\",", ",\"b, c,", GRAZE_EINPUT, "row 2"},
    {"0,0,on,", "0,none,on,", GRAZE_EINPUT, "row 1, column y"},
    {"0,0,on,", "0,1/0,on,", GRAZE_EINPUT, "row 1, column y"},
    {"0,0,on,", "0,1e1000000000,on,", GRAZE_ELIMIT, "row 1, column y"},
    {"on,boundary,8,2", "at,boundary,8,2", GRAZE_EINPUT, "row 2, column pmc"},
    {"on,boundary,8,2", "on,border,8,2", GRAZE_EINPUT, "row 2, column class"},
    {"on,boundary,8,2", "on,boundary,12,2", GRAZE_EINPUT, "row 2, column definition"},
    {"on,boundary,8,2", "on,boundary,8,10", GRAZE_EINPUT, "row 2, column case"},
    {"7,1,0,IBO", "7,4294967297,0,IBO", GRAZE_EINPUT, "row 3, column i"},
    {"7,1,0,IBO", "7,1,18446744073709551616,IBO", GRAZE_EINPUT, "row 3, column t"},
    {"7,1,0,IBO", "7,1,0,IBA", GRAZE_EINPUT, "row 3, column word"},
    {"7,1,0,IBO", "7,1,0,", GRAZE_EINPUT, "row 3, column word"},
    {"2.5\n", "1e1000000000\n", GRAZE_ELIMIT, "row 3, column n"},
    {"# complete 4\n", "", GRAZE_EINPUT, "no line # complete"},
    {"# complete 4", "# complete 5", GRAZE_EINPUT, "another number of rows"},
    {"# complete 4", "# complete 18446744073709551620", GRAZE_EINPUT, "another number of rows"},
    {"# complete 4", "# complete", GRAZE_EINPUT, "# complete"},
    {"# complete 4\n", "# complete 4\n# complete 4\n", GRAZE_EINPUT, "after # complete"},
    {"# complete 4\n", "# points-checksum 0\n# complete 4\n", GRAZE_EINPUT, "# points-checksum 0"},
};

/* The good table with one text replaced, malloc'ed. */
static char *changed(const change *c) {
    const char *at = strstr(good, c->from);
    size_t before = (size_t)(at - good);
    char *table = malloc(sizeof good + strlen(c->to));
    assert_non_null(at);
    assert_non_null(table);
    memcpy(table, good, before);
    strcpy(table + before, c->to);
    strcat(table, at + strlen(c->from));
    return table;
}

static graze_status export(char **out, size_t *length, graze_context *context, const char *table,
                           size_t table_length, graze_export form) {
    /* bytes of their own, so that a sanitizer sees a read past their end */
    char *copy = malloc(table_length ? table_length : 1);
    assert_non_null(copy);
    memcpy(copy, table, table_length);
    graze_status status = graze_report_export(out, length, context, copy, table_length, form);
    free(copy);
    return status;
}

static void what_a_table_says_is_checked(void **state) {
    (void)state;
    graze_context *context;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (size_t k = 0; k < sizeof changes / sizeof *changes; k++)
        for (int form = GRAZE_EXPORT_VTK; form <= GRAZE_EXPORT_NPY; form++) {
            char *out = (char *)&context, *table = changed(&changes[k]);
            size_t length = 1;
            graze_status status =
                export(&out, &length, context, table, strlen(table), (graze_export)form);
            if (status != changes[k].status || out || length ||
                !strstr(graze_context_message(context), changes[k].says))
                fail_msg("%s: status %d, %s", changes[k].to, (int)status,
                         graze_context_message(context));
            free(table);
        }
    graze_context_destroy(context);
}

/* No beginning of a table is a whole one but all of it, with or without its last line end. */
static void cut_anywhere(void **state) {
    (void)state;
    graze_context *context;
    char *out;
    size_t length, whole = strlen(good);
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (size_t k = 0; k <= whole; k++) {
        graze_status status = export(&out, &length, context, good, k, GRAZE_EXPORT_NPY);
        if (status != (k + 1 < whole ? GRAZE_EINPUT : GRAZE_OK))
            fail_msg("cut at byte %zu: status %d, %s", k, (int)status,
                     graze_context_message(context));
        graze_free(out);
    }
    char nul[sizeof good];
    memcpy(nul, good, sizeof good);
    *strstr(nul, "pipe") = '\0';
    assert_int_equal(export(&out, &length, context, nul, whole, GRAZE_EXPORT_VTK), GRAZE_EINPUT);
    assert_non_null(strstr(graze_context_message(context), "byte 0"));
    graze_context_destroy(context);
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
    static const change wider = {"note,n\n", "note,\n", GRAZE_OK, NULL};
    static const change huge = {"2.5\n", "1e300\n", GRAZE_OK, NULL};
    graze_context *context;
    char *out, *table = changed(&huge);
    size_t length;
    double third = 1.0 / 3, large = 1e300;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_BINARY32), GRAZE_OK);
    assert_int_equal(export(&out, &length, context, table, strlen(table), GRAZE_EXPORT_NPY),
                     GRAZE_OK);
    assert_true(holds(out, length, "5\" pipe", 7));
    assert_true(holds(out, length, &third, sizeof third));
    assert_true(holds(out, length, &large, sizeof large));
    graze_free(out);
    free(table);
    table = changed(&wider);
    assert_int_equal(export(&out, &length, context, table, strlen(table), GRAZE_EXPORT_NPY),
                     GRAZE_OK);
    assert_true(holds(out, length, "('note', '|S7'), ('column', '<f8')", 33));
    graze_free(out);
    free(table);
    graze_context_destroy(context);
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

/* The value of the last column in row 3 of the good table as an array: rows of one length, of which
 * the last eight bytes are that column, little-endian. */
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

/* A context that takes numbers of 100,000 digits and would round those of a scene. */
static graze_context *wide_context(graze_rounding rounding) {
    graze_context *context;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_DIGITS, 100000), GRAZE_OK);
    assert_int_equal(graze_context_set_rounding(context, rounding), GRAZE_OK);
    return context;
}

static void ends_of_the_range(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof extreme / sizeof *extreme; k++) {
        graze_context *context = wide_context((graze_rounding)(k % 3));
        char line[64], *out;
        size_t length;
        snprintf(line, sizeof line, "%s\n", extreme[k].number);
        const change one = {"2.5\n", line, GRAZE_OK, NULL};
        char *table = changed(&one);
        if (export(&out, &length, context, table, strlen(table), GRAZE_EXPORT_NPY))
            fail_msg("%s: %s", extreme[k].number, graze_context_message(context));
        double got = value_of_row_3(out, length);
        if (memcmp(&got, &extreme[k].nearest, sizeof got) != 0)
            fail_msg("%s: %a, expected %a", extreme[k].number, got, extreme[k].nearest);
        graze_free(out);
        free(table);
        graze_context_destroy(context);
    }
}

/* The column is n or, in place of 1/2, y. */
static void past_the_range(void **state) {
    (void)state;
    for (size_t k = 0; k < 4 * (sizeof too_large / sizeof *too_large); k++) {
        const char *number = too_large[k / 4], *column = k & 1 ? "y" : "n";
        graze_context *context = wide_context((graze_rounding)(k % 3));
        char line[64], says[160], *out;
        size_t length;
        if (k & 1)
            snprintf(line, sizeof line, "0,%s,in", number);
        else
            snprintf(line, sizeof line, "%s\n", number);
        snprintf(says, sizeof says,
                 "row 3, column %s: '%s'; expected a number that binary64 can hold", column,
                 number);
        const change one = {k & 1 ? "0,1/2,in" : "2.5\n", line, GRAZE_EINPUT, says};
        char *table = changed(&one);
        graze_status status = export(&out, &length, context, table, strlen(table),
                                     k & 2 ? GRAZE_EXPORT_NPY : GRAZE_EXPORT_VTK);
        if (status != GRAZE_EINPUT || out || !strstr(graze_context_message(context), says))
            fail_msg("%s: status %d, %s", number, (int)status, graze_context_message(context));
        free(table);
        graze_context_destroy(context);
    }
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
    assert_true(gmp_asprintf(&text, "%Qd\n", value) > 0);
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
        graze_context *context = wide_context(GRAZE_ROUND_NONE);
        int sign = k & 1 ? -1 : 1;
        char *number = power_text(sign, tie[k / 2].power, tie[k / 2].less), *out;
        const change one = {"2.5\n", number, GRAZE_OK, NULL};
        char *table = changed(&one);
        size_t length;
        int refused = tie[k / 2].nearest == 1;
        graze_status status =
            export(&out, &length, context, table, strlen(table), GRAZE_EXPORT_NPY);
        assert_int_equal(status, refused ? GRAZE_EINPUT : GRAZE_OK);
        if (!refused)
            assert_true(value_of_row_3(out, length) == sign * tie[k / 2].nearest);
        graze_free(out);
        free(table);
        free(number);
        graze_context_destroy(context);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_table_says_is_checked),
        cmocka_unit_test(cut_anywhere),
        cmocka_unit_test(further_columns),
        cmocka_unit_test(ends_of_the_range),
        cmocka_unit_test(past_the_range),
        cmocka_unit_test(ties_at_the_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
