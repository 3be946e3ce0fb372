/* Cubes that are certainly inside a sweep, or outside, against the exact answers for places in
 * them: corners, sides and the interior (proofs/judging.md C116, C117). In thin plates, which no
 * ball fits, most of the inside is known by facets that go through whole cubes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "../lib/random.h"
#include "base/number/rounding.h"
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "questions/judge/cube.h"
#include "questions/judge/judge.h"
#include "fixture.h"

enum { PLACES = 3, ON_LEVELS = 20 };

typedef struct banded {
    const char *solid, *motion;
    int cubes;    /* that are cut */
    double on[3]; /* a point that touches only */
} banded;

static const banded SCENES[] = {
    /* Corners at the start; the lower pole. */
    {"cases/bracket/solid.off", "cases/bracket/motion.json", 1500, {5, 3, 0}},
    {"cases/ball/solid.off", "cases/ball/motion.json", 600, {0, 0, -5}},
    {"tests/judge/plate.off", "tests/judge/plate.json", 2500, {0, 0, 0}},
    {"tests/judge/plate.off", "tests/judge/corner.json", 2500, {0, 0, 0}},
    {"tests/judge/pinch.off", "tests/judge/pinch.json", 1200, {0, 0, 0}},
    /* The trajectory enters the face where the hollow begins: OBO. */
    {"tests/judge/hollow.off", "tests/judge/rise.json", 1500, {-2, -2, -0.75}},
    /* From the hollow through its lowest vertex, inside a face that all others go through: OBO. */
    {"tests/judge/resting.off", "tests/judge/resting.json", 1500, {0, 0, 1}},
};

/* A place of a closed cube: on a corner, side or face, or inside. */
static void random_place(double at[3], const cube *c) {
    for (int k = 0; k < 3; k++) {
        double share = draw_below(3) ? random_fraction() : draw_below(2) ? 1 : -1;
        at[k] = c->centre[k] + c->half * share;
    }
}

static graze_pmc exact_answer(const graze_scene *scene, const double at[3]) {
    graze_verdict verdict;
    assert_int_equal(
        classify_answer(&verdict, context, scene, (query_point){.value = at}, TRACE_WORD),
        GRAZE_OK);
    return verdict.pmc;
}

/* The largest cube of the band, of those made first. */
static void cut_next(band *b, size_t *next) {
    int done = 0;
    while (!done) {
        assert_true(*next < b->count);
        const cube *c = &b->item[*next];
        if (c->kind == CUBE_BAND && !c->child)
            assert_int_equal(band_cut(&done, b, (uint32_t)*next), GRAZE_OK);
        ++*next;
    }
}

/* However small cubes are, that of a point that touches only is of the band. */
static void ask_on(band *b, const graze_scene *scene, const double on[3]) {
    assert_int_equal(exact_answer(scene, on), GRAZE_ON);
    for (int k = 0; k < ON_LEVELS; k++) {
        double low, high;
        int done;
        uint32_t index = band_nearest(&low, &high, b, on, CUBE_BAND, 0);
        assert_true(index != UINT32_MAX && low == 0);
        assert_int_equal(band_cut(&done, b, index), GRAZE_OK);
        assert_int_equal(band_membership(b, on), GRAZE_PMC_NONE);
    }
}

static void ask_places(const band *b, const graze_scene *scene, const banded *s) {
    size_t told[2] = {0, 0};
    for (size_t k = 0; k < b->count; k++) {
        const cube *c = &b->item[k];
        graze_pmc said = c->kind == CUBE_IN ? GRAZE_IN : GRAZE_OUT;
        double at[3];
        if (c->child || c->kind == CUBE_BAND)
            continue;
        told[said == GRAZE_IN]++;
        for (int p = 0; p < PLACES; p++) {
            random_place(at, c);
            if (exact_answer(scene, at) != said)
                fail_msg("%s: %.17g %.17g %.17g is not %s as all of its cube", s->solid, at[0],
                         at[1], at[2], graze_pmc_name(said));
            assert_int_equal(band_membership(b, c->centre), said);
        }
    }
    assert_true(told[0] > 100 && told[1] > 100);
}

static void test_cubes(void **state) {
    (void)state;
    random_start(20261126);
    for (size_t k = 0; k < sizeof SCENES / sizeof *SCENES; k++) {
        const banded *s = &SCENES[k];
        graze_solid *solid = NULL;
        graze_motion *motion = NULL;
        graze_scene *scene = NULL;
        band b;
        size_t next = 0;
        assert_int_equal(graze_solid_read(&solid, context, s->solid, 0), GRAZE_OK);
        assert_int_equal(graze_motion_read(&motion, context, s->motion), GRAZE_OK);
        assert_int_equal(graze_scene_create(&scene, context, solid, motion, NULL), GRAZE_OK);
        assert_int_equal(filter_lay_bricks(&scene->filter, context), GRAZE_OK);
        assert_int_equal(band_init(&b, context, scene), GRAZE_OK);
        for (int c = 0; c < s->cubes; c++)
            cut_next(&b, &next);
        ask_on(&b, scene, s->on);
        ask_places(&b, scene, s);
        band_clear(&b);
        graze_scene_destroy(scene);
        graze_motion_destroy(motion);
        graze_solid_destroy(solid);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_cubes, set_up, tear_down)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
