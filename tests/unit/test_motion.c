/* Motions: every transform against matrices derived by hand, the forms made of motions, point maps
 * against each other.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A matrix is written row by row, b last in each row. cos = 3/5, sin = 4/5 is the angle with the
 * tangent 1/2 of its half.
 */
#include "motion_fixture.h"

static void check(const char *text, const char *time, const char *expected) {
    char shown[TEXT];
    fmpq m[ENTRIES];
    fmpq_t t;
    graze_motion *motion = make(text);
    assert_int_equal(graze_context_set_rounding(context, GRAZE_ROUND_NONE), GRAZE_OK);
    init_matrix(m);
    fmpq_init(t);
    set_rational(t, time);
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
        cmocka_unit_test_setup_teardown(texts_and_handles, set_up, tear_down),
        cmocka_unit_test_setup_teardown(calls_can_be_canceled, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
