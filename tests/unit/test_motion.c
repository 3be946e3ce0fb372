/* Motions: every transform against matrices derived by hand, the forms made of motions, point maps
 * against each other, and random motions computed a second way.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A matrix is written row by row, b last in each row. cos = 3/5, sin = 4/5 is the angle with the
 * tangent 1/2 of its half.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "motion/motion_read.h"
#include "number/rational.h"
#include "fixture.h"
#include "../lib/random.h"

enum { ENTRIES = 12, TEXT = 4000, STEPS = 7 };

static graze_motion *make(const char *text) {
    graze_motion *motion;
    if (graze_motion_from_json(&motion, context, text, strlen(text)) != GRAZE_OK) {
        fail_msg("%s\n%s", text, graze_context_message(context));
    }
    return motion;
}

static void init_matrix(fmpq *m) {
    for (int k = 0; k < ENTRIES; k++) {
        fmpq_init(&m[k]);
    }
}

static void clear_matrix(fmpq *m) {
    for (int k = 0; k < ENTRIES; k++) {
        fmpq_clear(&m[k]);
    }
}

static void set_number(fmpq_t out, const char *token) {
    assert_int_equal(rational_parse(out, context, token, strlen(token)), GRAZE_OK);
}

/* The map at time t, in the last piece that holds t. */
static void map_at(fmpq *out, const graze_motion *motion, const fmpq_t t, int inverse) {
    size_t k = motion->piece_count - 1;
    while (k > 0 && fmpq_cmp(t, motion->piece[k].lo) < 0) {
        k--;
    }
    const motion_piece *piece = &motion->piece[k];
    fmpq_t u, span;
    fmpq_init(u);
    fmpq_init(span);
    fmpq_sub(u, t, piece->lo);
    fmpq_sub(span, piece->hi, piece->lo);
    fmpq_div(u, u, span);
    point_map_at(out, inverse ? &piece->inverse : &piece->forward, u);
    fmpq_clear(span);
    fmpq_clear(u);
}

/* a = a after b */
static void multiply(fmpq *a, const fmpq *b, int d) {
    fmpq result[ENTRIES];
    init_matrix(result);
    for (int i = 0; i < d; i++) {
        for (int j = 0; j <= d; j++) {
            for (int k = 0; k < d; k++) {
                fmpq_addmul(&result[i * (d + 1) + j], &a[i * (d + 1) + k], &b[k * (d + 1) + j]);
            }
        }
        fmpq_add(&result[i * (d + 1) + d], &result[i * (d + 1) + d], &a[i * (d + 1) + d]);
    }
    for (int k = 0; k < d * (d + 1); k++) {
        fmpq_swap(&a[k], &result[k]);
    }
    clear_matrix(result);
}

static int equal_to_text(const fmpq *m, int d, const char *expected, char *shown) {
    fmpq_t entry;
    int equal = 1, used = 0;
    fmpq_init(entry);
    for (int k = 0; k < d * (d + 1); k++) {
        expected += strspn(expected, " |");
        size_t n = strcspn(expected, " |");
        assert_int_equal(rational_parse(entry, context, expected, n), GRAZE_OK);
        expected += n;
        equal = equal && fmpq_equal(entry, &m[k]);
        char *text = rational_text(&m[k]);
        used += snprintf(shown + used, (size_t)(TEXT - used), "%.40s ", text);
        free(text);
    }
    assert_int_equal(strspn(expected, " |"), strlen(expected));
    fmpq_clear(entry);
    return equal;
}

static void check(const char *text, const char *time, const char *expected) {
    char shown[TEXT];
    fmpq m[ENTRIES];
    fmpq_t t;
    graze_motion *motion = make(text);
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_NONE), GRAZE_OK);
    init_matrix(m);
    fmpq_init(t);
    set_number(t, time);
    map_at(m, motion, t, 0);
    if (!equal_to_text(m, motion->dimension, expected, shown)) {
        fail_msg("%s\nat t = %s is %s, not %s", text, time, shown, expected);
    }
    fmpq_clear(t);
    clear_matrix(m);
    graze_motion_destroy(motion);
}

/* A motion of one piece over [0, 1]. */
static void check_piece(int d, const char *transform, const char *time, const char *expected) {
    char text[TEXT];
    snprintf(text, sizeof text,
             "{\"dimension\": %d, \"pieces\": [{\"t\": [0, 1], \"transform\": %s}]}", d, transform);
    check(text, time, expected);
}

static void plane_transforms(void **state) {
    (void)state;
    check_piece(2, "{\"translate\": [\"4*t\", \"t^2\"]}", "1/2", "1 0 2 | 0 1 1/4");
    check_piece(2, "{\"matrix\": [[\"1+t\", 2, \"t\"], [0, 1, -1]]}", "1/2", "3/2 2 1/2 | 0 1 -1");
    check_piece(2, "{\"matrix\": [[1, 2, 3], [4, 5, 6], [0, \"t-t\", \"t/t\"]]}", "1",
                "1 2 3 | 4 5 6");
    check_piece(2, "{\"scale\": \"1+t\"}", "1", "2 0 0 | 0 2 0");
    check_piece(2, "{\"scale\": [2, -3]}", "1", "2 0 0 | 0 -3 0");
    /* 1 + 2 (x - 1) = 2x - 1 */
    check_piece(2, "{\"scale\": 2, \"center\": [1, 0]}", "0", "2 0 -1 | 0 2 0");
    check_piece(2, "{\"rotate\": {\"tan_half\": \"1/2\"}}", "0", "3/5 -4/5 0 | 4/5 3/5 0");
    check_piece(2, "{\"rotate\": {\"tan_half\": \"1/2\", \"times\": -1}}", "0",
                "3/5 4/5 0 | -4/5 3/5 0");
    /* (3 + 4i)^2 / 25 = (-7 + 24i) / 25 */
    check_piece(2, "{\"rotate\": {\"tan_half\": 0.5, \"times\": 2}}", "0",
                "-7/25 -24/25 0 | 24/25 -7/25 0");
    check_piece(2, "{\"rotate\": {\"tan_half\": \"s\", \"times\": 0}}", "1", "1 0 0 | 0 1 0");
    /* x' = 1 - (y - 2), y' = 2 + (x - 1) */
    check_piece(2, "{\"rotate\": {\"tan_half\": \"s\", \"center\": [1, 2]}}", "1",
                "0 -1 3 | 1 0 1");
    /* the center moves: about (t, 0) at t = 1, a quarter turn: x' = 1 - y, y' = x - 1 */
    check_piece(2, "{\"rotate\": {\"tan_half\": 1, \"center\": [\"t\", 0]}}", "1",
                "0 -1 1 | 1 0 -1");
    check_piece(2, "{\"compose\": []}", "1", "1 0 0 | 0 1 0");
    /* T1 first: R (x + 1, y) = (-y, x + 1); and the other way round (-y + 1, x) */
    check_piece(2, "{\"compose\": [{\"translate\": [1, 0]}, {\"turn\": {\"quarters\": 1}}]}", "1",
                "0 -1 0 | 1 0 1");
    check_piece(2, "{\"compose\": [{\"turn\": {\"quarters\": 1}}, {\"translate\": [1, 0]}]}", "1",
                "0 -1 1 | 1 0 0");
}

/* In part j of |n| the tangent of the half angle past j quarters runs from 0 to 1. */
static void turns(void **state) {
    (void)state;
    const char *one = "{\"turn\": {\"quarters\": 1}}", *back = "{\"turn\": {\"quarters\": -3}}";
    check_piece(2, one, "0", "1 0 0 | 0 1 0");
    check_piece(2, one, "1/2", "3/5 -4/5 0 | 4/5 3/5 0");
    check_piece(2, one, "1", "0 -1 0 | 1 0 0");
    check_piece(2, back, "1/3", "0 1 0 | -1 0 0");
    /* a quarter back and the 3-4-5 angle back: cos = -4/5, sin = -3/5 */
    check_piece(2, back, "1/2", "-4/5 3/5 0 | -3/5 -4/5 0");
    check_piece(2, back, "2/3", "-1 0 0 | 0 -1 0");
    check_piece(2, back, "1", "0 -1 0 | 1 0 0");
    check_piece(2, "{\"turn\": {\"quarters\": 0, \"center\": [5, 5]}}", "1/2", "1 0 0 | 0 1 0");
    check_piece(2, "{\"turn\": {\"quarters\": 9}}", "1", "0 -1 0 | 1 0 0");
    check_piece(2, "{\"turn\": {\"quarters\": 6, \"center\": [1, 0]}}", "1", "-1 0 2 | 0 -1 0");
    check_piece(3, "{\"turn\": {\"quarters\": 1, \"axis\": [0, 0, -2]}}", "1",
                "0 1 0 0 | -1 0 0 0 | 0 0 1 0");
    /* s runs on over the cut at 1/2 */
    check_piece(2, "{\"compose\": [{\"turn\": {\"quarters\": 2}}, {\"translate\": [\"s\", 0]}]}",
                "1/2", "0 -1 1/2 | 1 0 0");
    /* 3 and 2 quarters at t = 1/2: one and a half, and one: the half is the 3-4-5 angle, so
     * (3 + 4i)/5 turned by two quarters */
    check_piece(2, "{\"compose\": [{\"turn\": {\"quarters\": 3}}, {\"turn\": {\"quarters\": 2}}]}",
                "1/2", "-3/5 4/5 0 | -4/5 -3/5 0");
}

static void check_pieces(const char *transform, size_t count) {
    char text[TEXT];
    snprintf(text, sizeof text,
             "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": %s}]}", transform);
    graze_motion *motion = make(text);
    assert_int_equal(graze_motion_piece_count(motion), count);
    graze_motion_destroy(motion);
}

static void turns_cut(void **state) {
    (void)state;
    check_pieces("{\"turn\": {\"quarters\": 0}}", 1);
    check_pieces("{\"turn\": {\"quarters\": -1}}", 1);
    check_pieces("{\"turn\": {\"quarters\": -7}}", 7);
    /* 1/3, 2/3, 1/2 */
    check_pieces("{\"compose\": [{\"turn\": {\"quarters\": 3}}, {\"turn\": {\"quarters\": 2}}]}",
                 4);
    /* halves are quarters too, whichever comes first */
    check_pieces("{\"compose\": [{\"turn\": {\"quarters\": 2}}, {\"turn\": {\"quarters\": -4}}]}",
                 4);
    check_pieces("{\"compose\": [{\"turn\": {\"quarters\": 4}}, {\"turn\": {\"quarters\": 2}}]}",
                 4);
}

/* tan_half = 1/(1 - 2s) runs from 1 through its pole to -1: from 90 over 180 to 270 degrees. */
static void poles_are_half_turns(void **state) {
    (void)state;
    const char *half = "{\"rotate\": {\"tan_half\": \"1/(1-2*s)\"}}";
    const char *twice = "{\"rotate\": {\"tan_half\": \"1/(1-2*s)\", \"times\": 2}}";
    check_piece(2, half, "0", "0 -1 0 | 1 0 0");
    check_piece(2, half, "1/2", "-1 0 0 | 0 -1 0");
    check_piece(2, half, "1", "0 1 0 | -1 0 0");
    check_piece(2, twice, "1/2", "1 0 0 | 0 1 0");
    check_piece(2, twice, "1", "-1 0 0 | 0 -1 0");
    /* about n = (3, 4, 0)/5: 2 n n^T - 1 */
    check_piece(3, "{\"rotate\": {\"tan_half\": \"1/(1-2*s)\", \"axis\": [3, 4, 0]}}", "1/2",
                "-7/25 24/25 0 0 | 24/25 7/25 0 0 | 0 0 -1 0");
    /* the axis (1 - t^2, 2t, 0) has the length 1 + t^2, and that direction at t = 1/2 */
    check_piece(3, "{\"rotate\": {\"tan_half\": \"1/(1-2*s)\", \"axis\": [\"1-t^2\", \"2*t\", 0]}}",
                "1/2", "-7/25 24/25 0 0 | 24/25 7/25 0 0 | 0 0 -1 0");
    check_piece(3, "{\"quaternion\": [\"1/(1-2*s)\", 0, 0, 1]}", "1/2",
                "1 0 0 0 | 0 1 0 0 | 0 0 1 0");
}

static void space_transforms(void **state) {
    (void)state;
    check_piece(3, "{\"translate\": [\"t\", \"2*t\", -1]}", "1", "1 0 0 1 | 0 1 0 2 | 0 0 1 -1");
    /* x' = 1 + 3/5 (x - 1) - 4/5 y, y' = 4/5 (x - 1) + 3/5 y */
    check_piece(3,
                "{\"rotate\": {\"tan_half\": \"1/2\", \"axis\": [0, 0, 1], \"center\": [1, 0, 0]}}",
                "1", "3/5 -4/5 0 2/5 | 4/5 3/5 0 -4/5 | 0 0 1 0");
    check_piece(3, "{\"rotate\": {\"tan_half\": \"1/2\", \"axis\": [7, 0, 0]}}", "1",
                "1 0 0 0 | 0 3/5 -4/5 0 | 0 4/5 3/5 0");
    check_piece(3, "{\"rotate\": {\"tan_half\": \"1/2\", \"axis\": [0, \"1/3\", 0]}}", "1",
                "3/5 0 4/5 0 | 0 1 0 0 | -4/5 0 3/5 0");
    /* a quarter about n = (1, 2, 2)/3 is n n^T + [n]x */
    check_piece(3, "{\"turn\": {\"quarters\": 1, \"axis\": [1, 2, 2]}}", "1",
                "1/9 -4/9 8/9 0 | 8/9 4/9 1/9 0 | -4/9 7/9 4/9 0");
    check_piece(3, "{\"quaternion\": [3, 0, 0, \"3*t\"]}", "1", "0 -1 0 0 | 1 0 0 0 | 0 0 1 0");
    /* a third of a turn about (1, 1, 1): x -> y -> z -> x; it takes (1, 0, 0) to (0, 1, 0) */
    check_piece(3, "{\"quaternion\": [1, 1, 1, 1], \"center\": [1, 0, 0]}", "1",
                "0 0 1 1 | 1 0 0 -1 | 0 1 0 0");
    check_piece(3, "{\"scale\": [1, 2, \"-1-t\"]}", "1", "1 0 0 0 | 0 2 0 0 | 0 0 -2 0");
}

static void numbers_are_exact(void **state) {
    (void)state;
    char small[420] = "1 0 1/1", expected[500];
    memset(small + 7, '0', 400);
    snprintf(expected, sizeof expected, "%s | 0 1 1180591620717411303424", small);
    check_piece(2, "{\"translate\": [0.1, \"0.1\"]}", "1", "1 0 1/10 | 0 1 1/10");
    check_piece(2, "{\"translate\": [1e-400, 1180591620717411303424]}", "1", expected);
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_BINARY64), GRAZE_OK);
    /* the motion alone is rounded, not what is expected of it */
    check_piece(2, "{\"translate\": [0.1, \"10*0.1\"]}", "1",
                "1 0 3602879701896397/36028797018963968 | 0 1 18014398509481985/18014398509481984");
}

static void keyframes(void **state) {
    (void)state;
    const char *plane = "{\"dimension\": 2, \"keyframes\": ["
                        "{\"t\": 0, \"position\": [0, 0], \"complex\": [1, 0]},"
                        "{\"t\": 4, \"position\": [2, 4], \"complex\": [0, 1]},"
                        "{\"t\": 5, \"position\": [2, 0], \"complex\": [0, 2]}]}";
    check(plane, "0", "1 0 0 | 0 1 0");
    /* (1 + i)/2, squared: a quarter turn */
    check(plane, "2", "0 -1 1 | 1 0 2");
    check(plane, "4", "-1 0 2 | 0 -1 4");
    check(plane, "9/2", "-1 0 2 | 0 -1 2");
    const char *space = "{\"dimension\": 3, \"keyframes\": ["
                        "{\"t\": 0, \"quaternion\": [1, 0, 0, 0]},"
                        "{\"t\": 1, \"quaternion\": [0, 1, 0, 0]}]}";
    check(space, "1/2", "1 0 0 0 | 0 0 -1 0 | 0 1 0 0");
    /* (2 + i)/3 is half the 3-4-5 angle */
    check(space, "1/3", "1 0 0 0 | 0 3/5 -4/5 0 | 0 4/5 3/5 0");
    check("{\"dimension\": 3, \"keyframes\": [{\"t\": 0, \"position\": [0, 0, 0]},"
          "{\"t\": 1, \"position\": [1, \"1/3\", 3]}]}",
          "1/2", "1 0 0 1/2 | 0 1 0 1/6 | 0 0 1 3/2");
}

#define TURNING                                                                                    \
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"compose\": ["               \
    "{\"turn\": {\"quarters\": 3}}, {\"translate\": [\"t^2\", \"1/(1+t)\"]}]}}]}"

static void relative_motions(void **state) {
    (void)state;
    const char *same =
        "{\"dimension\": 2, \"relative\": {\"moving\": " TURNING ", \"frame\": " TURNING "}}";
    check(same, "0", "1 0 0 | 0 1 0");
    check(same, "5/7", "1 0 0 | 0 1 0");
    /* a quarter back of (x + t, y): (y, -x - t) */
    const char *seen =
        "{\"dimension\": 2, \"relative\": {\"moving\": {\"dimension\": 2, \"pieces\": ["
        "{\"t\": [0, \"1/3\"], \"transform\": {\"translate\": [\"t\", 0]}},"
        "{\"t\": [\"1/3\", 1], \"transform\": {\"translate\": [\"t\", 0]}}]},"
        "\"frame\": {\"dimension\": 2, \"pieces\": ["
        "{\"t\": [0, \"1/2\"], \"transform\": {\"rotate\": {\"tan_half\": 1}}},"
        "{\"t\": [\"1/2\", 1], \"transform\": {\"rotate\": {\"tan_half\": 1}}}]}}}";
    check(seen, "0", "0 1 0 | -1 0 0");
    check(seen, "2/5", "0 1 0 | -1 0 -2/5");
    check(seen, "1", "0 1 0 | -1 0 -1");
    graze_motion *motion = make(seen);
    assert_int_equal(graze_motion_piece_count(motion), 3);
    graze_motion_destroy(motion);
}

static void sequences(void **state) {
    (void)state;
    const char *text = "{\"dimension\": 2, \"sequence\": ["
                       "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 2], \"transform\": "
                       "{\"translate\": [\"t\", 0]}}]},"
                       "{\"dimension\": 2, \"pieces\": [{\"t\": [5, 6], \"transform\": {\"turn\": "
                       "{\"quarters\": 1}}}]},"
                       "{\"dimension\": 2, \"pieces\": ["
                       "{\"t\": [-1, 0], \"transform\": {\"translate\": [0, \"t+1\"]}},"
                       "{\"t\": [0, 3], \"transform\": {\"translate\": [0, 1]}}]}]}";
    check(text, "0", "1 0 0 | 0 1 0");
    check(text, "1/2", "1 0 1 | 0 1 0");
    check(text, "1", "1 0 2 | 0 1 0");
    /* the 3-4-5 angle of (x + 2, y), then a quarter of it, then up by one */
    check(text, "3/2", "3/5 -4/5 6/5 | 4/5 3/5 8/5");
    check(text, "2", "0 -1 0 | 1 0 2");
    check(text, "17/8", "0 -1 0 | 1 0 5/2");
    check(text, "3", "0 -1 0 | 1 0 3");
    graze_motion *motion = make(text);
    assert_int_equal(graze_motion_piece_count(motion), 4);
    graze_motion_destroy(motion);
}

/* Signs of the weight and common factors, as motion.h promises them. */
static void check_map(const point_map *map, const char *text) {
    fmpz_poly_t common;
    fmpq_t u, weight;
    fmpz_poly_init(common);
    fmpq_init(u);
    fmpq_init(weight);
    fmpz_poly_set(common, map->weight);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++) {
        fmpz_poly_gcd(common, common, &map->entry[k]);
    }
    if (!fmpz_poly_is_one(common)) {
        fail_msg("a common factor is left: %s", text);
    }
    for (int k = 0; k <= 8; k++) {
        fmpq_set_si(u, k, 8);
        fmpz_poly_evaluate_fmpq(weight, map->weight, u);
        if (fmpq_sgn(weight) <= 0) {
            fail_msg("the weight is not positive at u = %d/8: %s", k, text);
        }
    }
    fmpq_clear(weight);
    fmpq_clear(u);
    fmpz_poly_clear(common);
}

/* A random transform that is legal for t in [0, 1]. */
static void random_transform(char *out, size_t size, int d) {
    int a = (int)random_below(9) - 4, b = (int)random_below(5) + 1;
    const char *axes[] = {"[0, 0, 1]", "[2, -1, 2]", "[\"1-t^2\", 0, \"2*t\"]"};
    const char *axis = axes[random_below(3)];
    char more[80] = "";
    if (d == 3) {
        snprintf(more, sizeof more, ", \"axis\": %s", axis);
    }
    const char *third = d == 3 ? ", \"t^2-t\"" : "";
    switch (random_below(6)) {
    case 0:
        snprintf(out, size, "{\"translate\": [\"%d*t\", \"1/(t+%d)\"%s]}", a, b, third);
        break;
    case 1:
        snprintf(out, size, "{\"rotate\": {\"tan_half\": \"%d*s-1/%d\", \"times\": %d%s}}", a, b,
                 a % 3, more);
        break;
    case 2:
        snprintf(out, size, "{\"turn\": {\"quarters\": %d, \"center\": [%d, \"t\"%s]%s}}", a, b,
                 third, more);
        break;
    case 3:
        snprintf(out, size, "{\"scale\": \"-(t+%d)/(t^2+%d)\", \"center\": [%d, 1%s]}", b, b, a,
                 third);
        break;
    case 4:
        snprintf(out, size,
                 d == 3 ? "{\"quaternion\": [%d, \"t\", \"s^2+%d\", \"1/(s+2)\"]}"
                        : "{\"rotate\": {\"tan_half\": \"%d/(2*t-1)-%d\"}}",
                 a, b);
        break;
    default:
        snprintf(out, size,
                 d == 3
                     ? "{\"matrix\": [[1, \"t\", %d, 0], [0, %d, \"t^3\", 1], [0, 0, \"1+t\", 0]]}"
                     : "{\"matrix\": [[1, \"%d*t\", 3], [0, %d, \"t^3\"]]}",
                 a, b);
    }
}

static void piece_text(char *out, size_t size, int d, const char *transform) {
    snprintf(out, size, "{\"dimension\": %d, \"pieces\": [{\"t\": [0, 1], \"transform\": %s}]}", d,
             transform);
}

/* Forward after inverse is the identity; and the matrix of a compose is the product of those of its
 * steps, each read as a motion of its own and multiplied as rational matrices. */
static void random_motions(void **state) {
    (void)state;
    random_start(3);
    char step[STEPS][400], all[STEPS * 400 + 100], text[TEXT], shown[TEXT];
    fmpq forward[ENTRIES], inverse[ENTRIES], product[ENTRIES], factor[ENTRIES];
    fmpq_t t;
    init_matrix(forward);
    init_matrix(inverse);
    init_matrix(product);
    init_matrix(factor);
    fmpq_init(t);
    for (int round = 0; round < 150; round++) {
        int d = 2 + round % 2;
        const char *identity = d == 2 ? "1 0 0 | 0 1 0" : "1 0 0 0 | 0 1 0 0 | 0 0 1 0";
        int last = (int)random_below(STEPS);
        size_t used = (size_t)snprintf(all, sizeof all, "{\"compose\": [");
        for (int k = 0; k <= last; k++) {
            random_transform(step[k], sizeof step[k], d);
            used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", step[k],
                                     k < last ? ", " : "]}");
        }
        piece_text(text, sizeof text, d, all);
        graze_motion *motion = make(text);
        for (size_t k = 0; k < motion->piece_count; k++) {
            check_map(&motion->piece[k].forward, text);
            check_map(&motion->piece[k].inverse, text);
        }
        fmpq_set_si(t, random_below(61), 60);
        map_at(forward, motion, t, 0);
        map_at(inverse, motion, t, 1);
        for (int k = last; k >= 0; k--) {
            piece_text(text, sizeof text, d, step[k]);
            graze_motion *alone = make(text);
            map_at(k == last ? product : factor, alone, t, 0);
            if (k < last) {
                multiply(product, factor, d);
            }
            graze_motion_destroy(alone);
        }
        for (int k = 0; k < d * (d + 1); k++) {
            if (!fmpq_equal(&product[k], &forward[k])) {
                fail_msg("entry %d is not that of the product: %s", k, all);
            }
        }
        graze_motion_destroy(motion);
        multiply(inverse, forward, d);
        if (!equal_to_text(inverse, d, identity, shown)) {
            fail_msg("inverse after forward is %s: %s", shown, all);
        }
    }
    fmpq_clear(t);
    clear_matrix(factor);
    clear_matrix(product);
    clear_matrix(inverse);
    clear_matrix(forward);
}

static void texts_and_handles(void **state) {
    (void)state;
    /* byte order mark, CRLF, escapes in keys and strings */
    check("\xef\xbb\xbf{\"dimension\": \"2\",\r\n\"pieces\": [{\"\\u0074\": [\"0\", 1],\r\n"
          "\"transform\": {\"translate\": [\"\\u0074\", \"1\\/2\"]}}]}\r\n",
          "1", "1 0 1 | 0 1 1/2");
    graze_motion_destroy(NULL);
    graze_motion *motion =
        make("{\"dimension\":2,\"pieces\":[{\"t\":[0,1],\"transform\":{\"scale\":1}}]}");
    /* the first bytes that sha256sum prints for this text */
    const unsigned char sum[] = {0x79, 0x4f, 0xd7, 0x4e, 0x67, 0xc1, 0xeb, 0xa0};
    assert_memory_equal(motion->sha256, sum, sizeof sum);
    assert_int_equal(graze_motion_dimension(motion), 2);
    graze_motion_destroy(motion);
    assert_int_equal(graze_motion_from_json(&motion, context, "{", 0), GRAZE_EINPUT);
    assert_null(motion);
}

static int stop(void *data) {
    return ++*(int *)data > 2;
}

static void calls_can_be_canceled(void **state) {
    (void)state;
    int asked = 0;
    graze_motion *motion;
    const char *text = TURNING;
    graze_context_set_cancel(context, stop, &asked);
    assert_int_equal(graze_motion_from_json(&motion, context, text, strlen(text)), GRAZE_ECANCELED);
    assert_null(motion);
    assert_int_equal(asked, 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(plane_transforms, set_up, tear_down),
        cmocka_unit_test_setup_teardown(turns, set_up, tear_down),
        cmocka_unit_test_setup_teardown(turns_cut, set_up, tear_down),
        cmocka_unit_test_setup_teardown(poles_are_half_turns, set_up, tear_down),
        cmocka_unit_test_setup_teardown(space_transforms, set_up, tear_down),
        cmocka_unit_test_setup_teardown(numbers_are_exact, set_up, tear_down),
        cmocka_unit_test_setup_teardown(keyframes, set_up, tear_down),
        cmocka_unit_test_setup_teardown(relative_motions, set_up, tear_down),
        cmocka_unit_test_setup_teardown(sequences, set_up, tear_down),
        cmocka_unit_test_setup_teardown(random_motions, set_up, tear_down),
        cmocka_unit_test_setup_teardown(texts_and_handles, set_up, tear_down),
        cmocka_unit_test_setup_teardown(calls_can_be_canceled, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
