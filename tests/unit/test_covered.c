/* Boxes that the solid covers at one time (questions/outline/arcs.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The solid is |x| + |y| <= 8 without |x| + |y| < 4, times a power of two. A box is inside if its
 * farthest corner has |x| + |y| < 8 and its nearest point |x| + |y| > 4, outside if the nearest
 * point has more than 8 or the farthest corner less than 4.
 */
#include <math.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "questions/outline/arcs.h"
#include "fixture.h"
#include "graze.h"

static const double rings_at[] = {8, 0, 0, 8, -8, 0, 0, -8, 4, 0, 0, 4, -4, 0, 0, -4};
static const char rest[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                           "{\"translate\": [\"0*t\", 0]}}]}";
static const char ratios[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                             "{\"translate\": [\"1/3\", \"1/7\"]}}]}";
static const char leg[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                          "{\"translate\": [\"64*t\", 0]}}]}";

static graze_outline o;

static void make(const char *motion_text, double size, graze_operation operation) {
    static const size_t sizes[] = {4, 4}, rings[] = {0, 1, 2, 3, 4, 5, 6, 7};
    graze_options options = {.size = sizeof options, .operation = operation};
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    double at[16];
    for (int k = 0; k < 16; k++)
        at[k] = rings_at[k] * size;
    assert_int_equal(graze_solid_from_doubles(&solid, context, 2, at, 8, sizes, 2, rings, 0),
                     GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, context, motion_text, strlen(motion_text)),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&scene, context, solid, motion, &options), GRAZE_OK);
    o.scene = scene;
    assert_int_equal(outline_cover(&o, context), GRAZE_OK);
}

static void drop(void) {
    graze_solid *solid = (graze_solid *)o.scene->solid;
    graze_motion *motion = (graze_motion *)o.scene->motion;
    graze_scene_destroy((graze_scene *)o.scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    covering_clear(&o.cover);
    o.cover = (covering){0};
}

/* The least and the greatest |x| of an interval. */
static double nearest(double low, double high) {
    return fmax(0, fmax(low, -high));
}
static double farthest(double low, double high) {
    return fmax(fabs(low), fabs(high));
}

/* All boxes with whole corners, the flat ones among them. */
static size_t compare_boxes(double size, int is_sweep) {
    size_t told = 0;
    for (int k = 0; k < 19 * 19 * 19 * 19; k++) {
        double a = k % 19 - 9, b = k / 19 % 19 - 9, c = k / 361 % 19 - 9, d = k / 6859 - 9;
        if (a > b || c > d)
            continue;
        box x = {{a * size, c * size, 0}, {b * size, d * size, 0}};
        double near = nearest(a, b) + nearest(c, d), far = farthest(a, b) + farthest(c, d);
        int expected = is_sweep ? far < 8 && near > 4 : near > 8 || far < 4;
        assert_int_equal(outline_covers(&o, &x, 0), expected);
        told += (size_t)expected;
    }
    return told;
}

static void whole_boxes(void **state) {
    (void)state;
    for (int exponent = -500; exponent <= 500; exponent += 250)
        for (int is_sweep = 0; is_sweep < 2; is_sweep++) {
            make(rest, ldexp(1, exponent), is_sweep ? GRAZE_SWEEP : GRAZE_UNSWEEP);
            assert_true(compare_boxes(ldexp(1, exponent), is_sweep) > 100);
            drop();
        }
}

/* Is |x - 1/3| + |y - 1/7| < 8 ? */
static int is_inside(const double *xy) {
    LOCAL_VEC(fmpq, x, 2);
    for (int i = 0; i < 2; i++) {
        LOCAL(fmpq, middle);
        fmpq_set_si(middle, 1, i ? 7 : 3);
        assert_int_equal(rational_from_double(x + i, context, xy[i]), GRAZE_OK);
        fmpq_sub(x + i, x + i, middle);
        fmpq_abs(x + i, x + i);
    }
    fmpq_add(x, x, x + 1);
    return fmpq_cmp_ui(x, 8) < 0;
}

/* Points a few units in the last place from a side of a solid whose corners are no doubles. */
static void near_sides(void **state) {
    (void)state;
    size_t told = 0;
    make(ratios, 1, GRAZE_SWEEP);
    for (int k = -40; k <= 40; k++)
        for (int far = 0; far < 50; far++) {
            double xy[2] = {1.0 / 3 + 5 + k * 0x1p-50, 1.0 / 7 + 3 - ldexp(far, -far)};
            box x = {{xy[0], xy[1], 0}, {xy[0], xy[1], 0}};
            int covers = outline_covers(&o, &x, 0);
            assert_true(!covers || is_inside(xy));
            told += (size_t)covers;
        }
    assert_true(told > 1000);
    drop();
}

/* Places on the axes at a corner of a solid of size 2^-1017, which is almost no normal double, are
 * not outside it; those farther off are. */
static void least_size(void **state) {
    (void)state;
    make(rest, 0x1p-1020, GRAZE_UNSWEEP);
    for (int k = 0; k < 8; k++) {
        double off = ldexp(k & 1 ? -1 : 1, -1020) * (k & 2 ? 8 : 9);
        box x = {{k & 4 ? off : 0, k & 4 ? 0 : off, 0}, {k & 4 ? off : 0, k & 4 ? 0 : off, 0}};
        assert_int_equal(outline_covers(&o, &x, 0), !(k & 2));
    }
    drop();
}

/* Boxes beside the path, at its first places and its last ones, and those that the solid passes
 * between two of its 65 places; where the square of a size is no double nothing is told. */
static void moving(void **state) {
    (void)state;
    const box around = {{31, 5, 0}, {32, 6, 0}}, above = {{31, 9, 0}, {32, 10, 0}},
              middle = {{35, -0.25, 0}, {37, 0.25, 0}}, wide = {{30, 5, 0}, {45, 6, 0}},
              first = {{-6, -1, 0}, {-5, 1, 0}}, last = {{69, -1, 0}, {70, 1, 0}};
    make(leg, 1, GRAZE_SWEEP);
    assert_true(outline_covers(&o, &around, 0) && outline_covers(&o, &middle, 0));
    assert_true(outline_covers(&o, &first, 0) && outline_covers(&o, &last, 0));
    assert_false(outline_covers(&o, &above, 0) || outline_covers(&o, &wide, 0));
    drop();
    make(leg, 1, GRAZE_UNSWEEP);
    assert_true(outline_covers(&o, &around, 0) && outline_covers(&o, &above, 0));
    drop();
    make(rest, 0x1p600, GRAZE_SWEEP);
    const box inside = {{0x1.5p602, 0, 0}, {0x1.6p602, 0, 0}};
    assert_false(outline_covers(&o, &inside, 0));
    drop();
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole_boxes), cmocka_unit_test(near_sides),
                                       cmocka_unit_test(least_size), cmocka_unit_test(moving)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
