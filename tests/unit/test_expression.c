/* Expressions: values derived by hand, random trees evaluated a second way, refusals, rounding.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "../lib/random.h"
#include "base/number/rational.h"
#include "base/number/rounding.h"
#include "input/motion/affine.h"
#include "input/motion/draft.h"
#include "fixture.h"

/* t runs from 1 to 3 while u and s run from 0 to 1. */
static fmpz_poly_q_t t, s, value;

static int set_up_values(void **state) {
    fmpz_poly_q_init(t);
    fmpz_poly_q_init(s);
    fmpz_poly_q_init(value);
    fmpz_poly_q_set_str(t, "2  1 2");
    fmpz_poly_q_set_str(s, "2  0 1");
    return set_up(state);
}

static int tear_down_values(void **state) {
    fmpz_poly_q_clear(t);
    fmpz_poly_q_clear(s);
    fmpz_poly_q_clear(value);
    return tear_down(state);
}

static graze_status read(const char *text) {
    return expression_value(value, context, text, strlen(text), t, s);
}

/* The expression has the value `expected` at t = 3/2, s = u = 1/4. */
static void check(const char *text, const char *expected) {
    fmpq_t u, got, wanted;
    fmpq_init(u);
    fmpq_init(got);
    fmpq_init(wanted);
    fmpq_set_si(u, 1, 4);
    if (read(text) != GRAZE_OK) {
        fail_msg("%s", graze_context_message(context));
    }
    quotient_at(got, value, u);
    set_rational(wanted, expected);
    if (!fmpq_equal(got, wanted)) {
        char *shown = rational_text(got);
        fail_msg("'%s' is %s, not %s", text, shown, expected);
    }
    fmpq_clear(wanted);
    fmpq_clear(got);
    fmpq_clear(u);
}

static void values_by_hand(void **state) {
    (void)state;
    check("t", "3/2");
    check("s", "1/4");
    check("1+2*3", "7");
    check("(1+2)*3", "9");
    check("10-4-3", "3");
    check("24/4/3", "2");
    check("24/4*3", "18");
    check("-t^2", "-9/4");
    check("(-t)^2", "9/4");
    check("2*t^2", "9/2");
    check("-2^2", "-4");
    check("2^-2", "1/4");
    check("2^+2", "4");
    check("t^-1", "2/3");
    check("-t^-1", "-2/3");
    check("(t^2)^3", "729/64");
    check("t^0", "1");
    check("(t-t)^0", "1");
    check("2*-t", "-3");
    check("2--t", "7/2");
    check("+-+t", "-3/2");
    check("1.5e-3*t", "9/4000");
    check("1.5E2*s", "75/2");
    check(".5+5.", "11/2");
    check(" ( t + 1 )\t/ \n 5 ", "1/2");
    check("22/7", "22/7");
    check("22/7*t", "33/7");
    check("1/t*t", "1");
    check("(t^2-1)/(t-1)", "5/2");
    check("(t-1)/2-s", "0");
    check("1^1000000000000000000000", "1");
    check("(-1)^1000000000000000000001", "-1");
}

/* Lowest terms: what cancels leaves no pole behind. */
static void quotients_are_reduced(void **state) {
    (void)state;
    assert_int_equal(read("t/t"), GRAZE_OK);
    assert_true(fmpz_poly_q_is_one(value));
    assert_int_equal(read("(s^2-s)/(2*s-2)"), GRAZE_OK); /* s/2 */
    assert_int_equal(fmpz_poly_degree(fmpz_poly_q_denref(value)), 0);
    assert_int_equal(fmpz_poly_degree(fmpz_poly_q_numref(value)), 1);
}

static void mistakes_are_refused(void **state) {
    (void)state;
    static const char *const texts[] = {
        "",     " ",   "t+",  "*t",     "t t",  "2t",   "t2",    "(t",      "t)",
        "()",   "t^",  "t^t", "t^(2)",  "t^.5", "t^2.", "t^1e1", "t^2^3",   "t^-2^-3",
        "t**2", "x",   "T",   "tt",     "ts",   "1..2", "1e",    "1/(t-t)", "0^-1",
        "1,5",  "1/0", "t#",  "sin(t)", "2 3",  "[t]",  "t=1",   "1//2",    "\xc2\xb2"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        if (read(texts[k]) != GRAZE_EINPUT) {
            fail_msg("'%s' is taken", texts[k]);
        }
    }
    assert_int_equal(expression_value(value, context, "t\0+1", 4, t, s), GRAZE_EINPUT);
    assert_int_equal(expression_value(value, context, "t+1", 3, NULL, NULL), GRAZE_EINPUT);
    assert_int_equal(expression_value(value, context, "1/3+1/6", 7, NULL, NULL), GRAZE_OK);
}

static void limits_act(void **state) {
    (void)state;
    static const char *const texts[] = {"t^201",
                                        "t^100*t^101",
                                        "t^1000000000",
                                        "t^-201",
                                        "2^1000000000",
                                        "2^-1000000000",
                                        "1/t^150+1/(t+1)^150",
                                        "s^100000000000000000000",
                                        "1e5000*1e5000*1e5000"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) {
        if (read(texts[k]) != GRAZE_ELIMIT) {
            fail_msg("'%s' meets no limit", texts[k]);
        }
    }
    assert_int_equal(read("t^200"), GRAZE_OK);
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_DEPTH, 3), GRAZE_OK);
    assert_int_equal(read("(((t)))+(((t)))"), GRAZE_OK);
    assert_int_equal(read("((((t))))"), GRAZE_ELIMIT);
}

/* Every token is rounded by itself, a text that is one token as one. Hardware arithmetic is the
 * second method: 22/7, and 0.1 + 0.2 before their sum is rounded. */
static void tokens_are_rounded(void **state) {
    (void)state;
    static const struct {
        const char *text;
        double first, second; /* the exact sum of two doubles */
    } cases[] = {{"22/7", 22.0 / 7.0, 0},
                 {"0.1", 0.1, 0},
                 {"0.1+0.2", 0.1, 0.2},
                 {"(0.1)", 0.1, 0},
                 {"-0.1", -0.1, 0}};
    fmpq_t got, first, second, zero;
    fmpq_init(got);
    fmpq_init(first);
    fmpq_init(second);
    fmpq_init(zero);
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_BINARY64), GRAZE_OK);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        assert_int_equal(read(cases[k].text), GRAZE_OK);
        quotient_at(got, value, zero);
        assert_int_equal(rational_from_double(first, context, cases[k].first), GRAZE_OK);
        assert_int_equal(rational_from_double(second, context, cases[k].second), GRAZE_OK);
        fmpq_add(first, first, second);
        if (!fmpq_equal(got, first)) {
            fail_msg("'%s' is rounded wrongly", cases[k].text);
        }
    }
    assert_int_equal(read("(22)/7"), GRAZE_OK); /* two tokens, both exact */
    quotient_at(got, value, zero);
    fmpq_set_si(first, 22, 7);
    assert_true(fmpq_equal(got, first));
    fmpq_clear(zero);
    fmpq_clear(second);
    fmpq_clear(first);
    fmpq_clear(got);
}

/* A random tree: its text, and its value at given t and s by rational arithmetic. Returns 0 where a
 * division by zero makes that value undefined. */
typedef struct grown {
    char text[4000];
    fmpq_t value;
} grown;

static int grow(grown *out, int depth, const fmpq_t at_t, const fmpq_t at_s);

static int grow_operation(grown *out, int depth, const fmpq_t at_t, const fmpq_t at_s) {
    static const char operators[] = "+-*/";
    grown *side = calloc(2, sizeof *side);
    fmpq_init(side[0].value);
    fmpq_init(side[1].value);
    int k = (int)draw_below(4);
    int ok = grow(&side[0], depth - 1, at_t, at_s) && grow(&side[1], depth - 1, at_t, at_s) &&
             !(k == 3 && fmpq_is_zero(side[1].value));
    if (ok) {
        void (*const compute[])(fmpq_t, const fmpq_t, const fmpq_t) = {fmpq_add, fmpq_sub, fmpq_mul,
                                                                       fmpq_div};
        snprintf(out->text, sizeof out->text, "(%.1900s)%c(%.1900s)", side[0].text, operators[k],
                 side[1].text);
        compute[k](out->value, side[0].value, side[1].value);
    }
    fmpq_clear(side[0].value);
    fmpq_clear(side[1].value);
    free(side);
    return ok;
}

static int grow_power(grown *out, int depth, const fmpq_t at_t, const fmpq_t at_s) {
    grown *base = calloc(1, sizeof *base);
    fmpq_init(base->value);
    int n = (int)draw_below(7) - 3;
    int ok = grow(base, depth - 1, at_t, at_s) && !(n < 0 && fmpq_is_zero(base->value));
    if (ok) {
        snprintf(out->text, sizeof out->text, "-(%.3900s)^%d", base->text, n);
        fmpq_pow_si(out->value, base->value, n);
        fmpq_neg(out->value, out->value);
    }
    fmpq_clear(base->value);
    free(base);
    return ok;
}

static int grow(grown *out, int depth, const fmpq_t at_t, const fmpq_t at_s) {
    unsigned kind = draw_below(depth > 0 ? 8 : 3);
    if (kind == 0) {
        snprintf(out->text, sizeof out->text, "t");
        fmpq_set(out->value, at_t);
    } else if (kind == 1) {
        snprintf(out->text, sizeof out->text, "s");
        fmpq_set(out->value, at_s);
    } else if (kind == 2) {
        int n = (int)draw_below(100);
        snprintf(out->text, sizeof out->text, "%d.%de-1", n / 10, n % 10);
        fmpq_set_si(out->value, n, 100);
    } else {
        return (kind < 7 ? grow_operation : grow_power)(out, depth, at_t, at_s);
    }
    return 1;
}

static void random_trees_agree(void **state) {
    (void)state;
    random_start(20);
    int compared = 0;
    grown *tree = calloc(1, sizeof *tree);
    fmpq_t at_t, at_s, got;
    fmpq_init(tree->value);
    fmpq_init(at_t);
    fmpq_init(at_s);
    fmpq_init(got);
    for (int k = 0; k < 3000; k++) {
        fmpq_set_si(at_s, draw_below(100), 97);
        quotient_at(at_t, t, at_s);
        if (!grow(tree, 4, at_t, at_s)) {
            continue;
        }
        graze_status status = read(tree->text);
        if (status == GRAZE_ELIMIT) {
            continue;
        }
        if (status != GRAZE_OK) {
            fail_msg("'%s': %s", tree->text, graze_context_message(context));
        }
        quotient_at(got, value, at_s);
        if (!fmpq_equal(got, tree->value)) {
            fail_msg("'%s' differs, seed 20, round %d", tree->text, k);
        }
        compared++;
    }
    assert_true(compared > 2000);
    fmpq_clear(got);
    fmpq_clear(at_s);
    fmpq_clear(at_t);
    fmpq_clear(tree->value);
    free(tree);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(values_by_hand, set_up_values, tear_down_values),
        cmocka_unit_test_setup_teardown(quotients_are_reduced, set_up_values, tear_down_values),
        cmocka_unit_test_setup_teardown(mistakes_are_refused, set_up_values, tear_down_values),
        cmocka_unit_test_setup_teardown(limits_act, set_up_values, tear_down_values),
        cmocka_unit_test_setup_teardown(tokens_are_rounded, set_up_values, tear_down_values),
        cmocka_unit_test_setup_teardown(random_trees_agree, set_up_values, tear_down_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
