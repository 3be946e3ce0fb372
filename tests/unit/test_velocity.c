/* Normal velocities in doubles (questions/generate/strata.h) against the exact ones, on
 * tetrahedra whose coordinates doubles do not hold. Half of the motions slide along a face, whose
 * velocity is then 0: a bound that is too small shows. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "../lib/random.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/generate/generate.h"
#include "questions/generate/strata.h"
#include "fixture.h"

enum { SCENES = 400, TIMES = 8 };

typedef struct tetrahedron {
    mpq_t at[12];
    graze_solid *solid;
} tetrahedron;

/* A coordinate in sevenths and 10^9ths far from the origin, now and then a double near it. */
static void draw_far(mpq_t out, int far) {
    mpq_set_si(out, random_about(1000), far ? 7 : 8);
    mpq_canonicalize(out);
    if (far) {
        mpq_t more;
        mpq_init(more);
        mpq_set_si(more, 1000000 + draw_below(1000), 1000003);
        mpq_canonicalize(more);
        mpq_add(out, out, more);
        mpq_set_si(more, (1 << 30) * (draw_below(2) ? 1L : 1024L), 1);
        mpq_add(out, out, more);
        mpq_clear(more);
    }
}

/* Faces outward in one of the two orders; 0 for a flat one. */
static int draw_solid(tetrahedron *t) {
    static const size_t size[4] = {3, 3, 3, 3};
    static const size_t turned[2][12] = {{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                                         {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0}};
    int far = draw_below(4) > 0;
    for (int k = 0; k < 12; k++)
        draw_far(t->at[k], far);
    for (int side = 0; side < 2; side++)
        if (!graze_solid_from_arrays(&t->solid, context, 3, t->at, 4, size, 4, turned[side], 0))
            return 1;
    return 0;
}

/* A translation, along the face 0 1 2 every other time, or a turn. */
static graze_motion *draw_motion(tetrahedron *t) {
    graze_motion *motion = NULL;
    char *text = NULL;
    mpq_t step[3], part;
    mpq_inits(step[0], step[1], step[2], part, NULL);
    slong a = random_about(9), b = random_about(9), kind = draw_below(4);
    for (int i = 0; i < 3; i++) {
        mpq_set_si(part, a, 1);
        mpq_sub(step[i], t->at[3 + i], t->at[i]);
        mpq_mul(step[i], step[i], part);
        mpq_sub(part, t->at[6 + i], t->at[i]);
        for (slong k = 0; k < b; k++)
            mpq_add(step[i], step[i], part);
        if (kind == 2)
            mpq_set_si(step[i], random_about(100), 3);
    }
    if (kind < 3)
        gmp_asprintf(
            &text,
            "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": "
            "[\"(%Qd)*t\", \"(%Qd)*t\", \"(%Qd)*t\"]}}]}",
            step[0], step[1], step[2]);
    else
        gmp_asprintf(
            &text,
            "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"quaternion\": "
            "[\"1\", \"%ld*t\", \"t/3\", \"%ld*t^2\"]}}]}",
            (long)a, (long)b);
    assert_int_equal(graze_motion_from_json(&motion, context, text, strlen(text)), GRAZE_OK);
    free(text);
    mpq_clears(step[0], step[1], step[2], part, NULL);
    return motion;
}

/* 1 or -1 where the exact velocities at the corners of a simplex have that sign, else 0. */
static int exact_sign(const instant *i, const graze_solid *solid, size_t simplex) {
    fmpz *plane = _fmpz_vec_init(8), *form = plane + 4;
    fmpq *value = _fmpq_vec_init(2);
    int sum = 0;
    solid_plane(plane, solid, simplex);
    instant_pullback(form, i, plane, 1);
    for (int c = 0; c < 3; c++) {
        const fmpq *y = solid->input.coordinates + 3 * (size_t)solid->cut.item[simplex].vertex[c];
        fmpq_set_fmpz(value, form + 3);
        for (int j = 0; j < 3; j++) {
            fmpq_mul_fmpz(value + 1, y + j, form + j);
            fmpq_add(value, value, value + 1);
        }
        sum += fmpq_sgn(value);
    }
    _fmpz_vec_clear(plane, 8);
    _fmpq_vec_clear(value, 2);
    return sum / 3;
}

static void one_sign_is_exact(void **state) {
    (void)state;
    tetrahedron t;
    long seen = 0, missed = 0, zero = 0;
    fmpq_t u;
    fmpq_init(u);
    for (int k = 0; k < 12; k++)
        mpq_init(t.at[k]);
    random_start(2008);
    for (int k = 0; k < SCENES; k++) {
        if (!draw_solid(&t))
            continue;
        graze_motion *motion = draw_motion(&t);
        graze_scene *scene = NULL;
        assert_int_equal(graze_scene_create(&scene, context, t.solid, motion, NULL), GRAZE_OK);
        for (int n = 0; n < TIMES; n++) {
            instant when;
            fmpq_set_si(u, draw_below(65), 64);
            instant_init(&when, scene, 0, u);
            for (size_t s = 0; s < 4; s++) {
                int sign = exact_sign(&when, t.solid, s),
                    quick = velocity_has_one_sign(&when, t.solid, s);
                if (quick && !sign)
                    print_error("scene %d, time %d/64, simplex %zu\n", k, n, s);
                assert_true(sign || !quick);
                seen += quick;
                missed += sign && !quick;
                zero += !sign;
            }
            instant_clear(&when);
        }
        graze_scene_destroy(scene);
        graze_motion_destroy(motion);
        graze_solid_destroy(t.solid);
    }
    print_message("%ld seen, %ld not, %ld have none\n", seen, missed, zero);
    assert_true(seen > 9 * missed && zero > 1000);
    for (int k = 0; k < 12; k++)
        mpq_clear(t.at[k]);
    fmpq_clear(u);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_sign_is_exact)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
