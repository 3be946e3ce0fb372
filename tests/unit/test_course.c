/* The bounds of several pieces: at all times the map is a mean of the matrices that the group
 * states. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The maps at a time are computed from the pieces' own coefficients, in doubles with room for their
 * rounding.
 */
#include <math.h>
#include <string.h>
#include "../lib/harness.h"
#include "decide/bounds/bounds.h"
#include "input/motion/motion.h"
#include "graze.h"

enum { PLACES = 64 };

/* Angles from -11 to 191 degrees: the sine runs from -0.2 over 1 to -0.2; and three quarters and a
 * way in space. */
static const char *const motions[] = {
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"compose\": [{\"rotate\": "
    "{\"tan_half\": \"(2*t-1)/10\"}}, {\"turn\": {\"quarters\": 2}}]}}]}",
    "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"compose\": [{\"turn\": "
    "{\"quarters\": 3, "
    "\"axis\": [\"2/7\", \"3/7\", \"6/7\"]}}, {\"translate\": [\"t\", \"-2*t\", \"t/3\"]}]}}]}",
};

/* A Bernstein form at s. */
static double value(const double *coefficient, int n, double s) {
    double row[CARRIER_DEGREE + 1];
    memcpy(row, coefficient, (size_t)(n + 1) * sizeof *row);
    for (int level = 1; level <= n; level++)
        for (int k = 0; k <= n - level; k++)
            row[k] += s * (row[k + 1] - row[k]);
    return row[0];
}

/* Is there a place s of the chord from which no entry is further than `off`? Each entry leaves an
 * interval of s. */
static int is_near_chord(const piece_group *g, const double *map, int entries) {
    double first = 0, last = 1;
    for (int e = 0; e < entries; e++) {
        double step = g->last[e] - g->first[e], room = g->off[e] + 1e-12;
        if (fabs(step) < 1e-9) {
            if (fabs(map[e] - g->first[e]) > room + 1e-9)
                return 0;
            continue;
        }
        double a = (map[e] - room - g->first[e]) / step, b = (map[e] + room - g->first[e]) / step;
        first = fmax(first, fmin(a, b));
        last = fmin(last, fmax(a, b));
    }
    return first <= last;
}

static void check_group(const course *c, const piece_group *g, size_t count) {
    int d = c->dimension, entries = d * (d + 1);
    assert_true(g->bounded);
    for (const carrier *p = c->piece + g->piece; p < c->piece + g->piece + count; p++)
        for (int k = 0; k <= PLACES; k++) {
            double map[POINT_MAP_ENTRIES], s = (double)k / PLACES;
            for (int e = 0; e < entries; e++)
                map[e] = value(p->entry + e * (p->degree + 1), p->degree, s) /
                         value(p->weight, p->degree, s);
            if (!is_near_chord(g, map, entries))
                fail_msg("pieces %u to %zu: at %g of piece %td no place of the chord is near",
                         g->piece, g->piece + count - 1, s, p - c->piece);
        }
}

static void check_below(const course *c, size_t index, size_t count) {
    const piece_group *g = &c->group[index];
    if (!g->child)
        return;
    check_group(c, g, count);
    check_below(c, g->child, count / 2);
    check_below(c, g->child + 1, count - count / 2);
}

static void means(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof motions / sizeof *motions; k++)
        for (int operation = GRAZE_SWEEP; operation <= GRAZE_UNSWEEP; operation++) {
            graze_context *context;
            graze_motion *motion;
            course c;
            assert_int_equal(graze_context_create(&context), GRAZE_OK);
            assert_int_equal(
                graze_motion_from_json(&motion, context, motions[k], strlen(motions[k])), GRAZE_OK);
            assert_true(course_make(&c, motion, (graze_operation)operation));
            assert_true(c.piece_count >= 2);
            check_below(&c, 0, c.piece_count);
            course_clear(&c);
            graze_motion_destroy(motion);
            graze_context_destroy(context);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(means)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
