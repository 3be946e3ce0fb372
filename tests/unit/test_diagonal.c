/* The diagonal of the box of a solid at the motion's start (questions/distance/distance.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Boxes of whole diagonals, 3-4-5 and 2-3-6-7, give these exactly at every power of two; else the
 * square of the answer is at most the sum of the sides' squares, and that of the next double more.
 */
#include <math.h>
#include "base/number/rounding.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "questions/distance/distance.h"
#include "fixture.h"
#include "graze.h"

static const char turned[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                             "{\"matrix\": [[0, -1, \"7-t\"], [1, 0, \"t-9\"]]}}]}";
static const char flat[] = "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                           "{\"translate\": [\"3-t\", \"t\"]}}]}";
static const char space[] = "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": "
                            "{\"translate\": [\"t\", 0, \"-5\"]}}]}";

/* The diagonal of a triangle or a tetrahedron in which each corner counts, `size` times as large.
 */
static double diagonal(int d, const double *at, const char *motion_text, double size) {
    static const size_t sizes[] = {3, 3, 3, 3}, ring[] = {0, 1, 2},
                        sides[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    graze_solid *solid;
    graze_motion *motion;
    graze_scene *scene;
    double scaled[12], out = 0;
    for (int k = 0; k < d * (d + 1); k++)
        scaled[k] = at[k] * size;
    assert_int_equal(graze_solid_from_doubles(&solid, context, d, scaled, (size_t)d + 1, sizes,
                                              d == 2 ? 1 : 4, d == 2 ? ring : sides, 0),
                     GRAZE_OK);
    assert_int_equal(graze_motion_from_json(&motion, context, motion_text, strlen(motion_text)),
                     GRAZE_OK);
    assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
    assert_int_equal(distance_diagonal(&out, context, scene), GRAZE_OK);
    graze_scene_destroy(scene);
    graze_motion_destroy(motion);
    graze_solid_destroy(solid);
    return out;
}

/* Extremes at the first corner, at the last, and in between. */
static const double triangles[][6] = {
    {0, 0, 3, 4, 0, 4}, {3, 4, 0, 4, 0, 0}, {1, 4, 0, 0, 3, 1}, {-3, 2, 0, -2, -1, 2}};
static const double tetrahedron[] = {0, 0, 0, 2, 0, 1, 1, 3, 2, 1, 1, 6};

static void whole(void **state) {
    (void)state;
    for (int exponent = -290; exponent <= 190; exponent += 8) {
        double size = ldexp(1, exponent);
        for (size_t k = 0; k < sizeof triangles / sizeof *triangles; k++) {
            assert_true(diagonal(2, triangles[k], flat, size) == 5 * size);
            assert_true(diagonal(2, triangles[k], turned, size) == 5 * size);
        }
        assert_true(diagonal(3, tetrahedron, space, size) == 7 * size);
    }
}

/* The sign of the square of a double less a number. */
static int compare_square(double x, ulong number) {
    fmpq_t square;
    fmpq_init(square);
    assert_int_equal(rational_from_double(square, context, x), GRAZE_OK);
    fmpq_mul(square, square, square);
    int order = fmpq_cmp_ui(square, number);
    fmpq_clear(square);
    return order;
}

static void rounded_down(void **state) {
    (void)state;
    for (ulong k = 1; k < 200; k++) {
        const double at[] = {0, 0, (double)k, 0, 0, 1};
        double out = diagonal(2, at, flat, 1);
        assert_true(compare_square(out, k * k + 1) <= 0);
        assert_true(compare_square(nextafter(out, INFINITY), k * k + 1) > 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole), cmocka_unit_test(rounded_down)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
