/* Bricks against exact location: what is said of a box holds at random places in it, for bricks,
 * parts of them and boxes of several, in solids whose coordinates are no doubles as well.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <math.h>
#include "../lib/random.h"
#include "base/number/rounding.h"
#include "decide/filter/filter.h"
#include "decide/filter/search.h"
#include "input/solid/solid.h"
#include "fixture.h"

enum { BOXES = 3000, PLACES = 4 };

static const char *const SOLIDS[] = {"cases/bracket/solid.off", "cases/ball/solid.off",
                                     "cases/cutter/solid.off", "cases/cartridge/solid.off",
                                     "tests/examples/solids/q2.wkt"};

/* The second method: no double but the place itself. */
static graze_state exact_state(void *data, const double at[3]) {
    const graze_solid *solid = data;
    int d = solid->input.dimension;
    fmpq *p = _fmpq_vec_init(d);
    fmpz *x = _fmpz_vec_init(d + 1);
    for (int k = 0; k < d; k++)
        assert_int_equal(rational_from_double(p + k, context, at[k]), GRAZE_OK);
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + d, p, d);
    graze_state state = solid_locate(solid, x);
    _fmpq_vec_clear(p, d);
    _fmpz_vec_clear(x, d + 1);
    return state;
}

/* A box in the solid's, from a fraction of a brick to several, often with a brick's own ends. */
static box random_box(const interior *m) {
    box b = {{0, 0, 0}, {0, 0, 0}};
    double size = ldexp(random_fraction(), (int)draw_below(5) - 2);
    int whole = draw_below(3) == 0;
    for (int k = 0; k < m->dimension; k++) {
        double at = fabs(random_fraction()) * (double)m->count[k], end = at + fabs(size);
        at = whole ? floor(at) : at;
        end = whole ? ceil(end) : end;
        b.low[k] = m->low[k] + at * m->step[k];
        b.high[k] = m->low[k] + end * m->step[k];
    }
    return b;
}

/* An end of the box, or between them. */
static void random_place(double at[3], const box *b) {
    for (int k = 0; k < 3; k++) {
        double share = draw_below(3) ? fabs(random_fraction()) : (double)draw_below(2);
        at[k] = fmin(b->low[k] + share * (b->high[k] - b->low[k]), b->high[k]);
    }
}

static void test_places(void **state) {
    (void)state;
    random_start(20261125);
    for (size_t s = 0; s < sizeof SOLIDS / sizeof *SOLIDS; s++) {
        graze_solid *solid = NULL;
        interior bricks;
        int inside = 0, outside = 0;
        assert_int_equal(graze_solid_read(&solid, context, SOLIDS[s], 0), GRAZE_OK);
        assert_true(interior_make(&bricks, solid, exact_state, solid));
        for (int k = 0; k < BOXES; k++) {
            box b = random_box(&bricks);
            graze_state said = interior_state(&bricks, &b);
            inside += said == GRAZE_STATE_I;
            outside += said == GRAZE_STATE_O;
            for (int p = 0; p < PLACES && said != GRAZE_STATE_ABSENT; p++) {
                double at[3];
                random_place(at, &b);
                if (exact_state(solid, at) != said)
                    fail_msg("%s at %.17g %.17g %.17g: the bricks say %c", SOLIDS[s], at[0], at[1],
                             at[2], (char)said);
            }
        }
        assert_true(inside > BOXES / 50);
        assert_true(inside + outside > BOXES / 20);
        interior_clear(&bricks);
        graze_solid_destroy(solid);
    }
}

/* Nothing is said of what reaches beyond the bricks. */
static void test_beyond(void **state) {
    (void)state;
    graze_solid *solid = NULL;
    interior bricks;
    assert_int_equal(graze_solid_read(&solid, context, SOLIDS[4], 0), GRAZE_OK);
    assert_true(interior_make(&bricks, solid, exact_state, solid));
    const box *all = &solid->boxes.node[0].box;
    box middle = {{0.5 * (all->low[0] + all->high[0]), 0.5 * (all->low[1] + all->high[1]), 0},
                  {0, 0, 0}};
    for (int k = 0; k < 3; k++)
        middle.high[k] = middle.low[k];
    assert_int_equal(interior_state(&bricks, &middle), GRAZE_STATE_I);
    middle.high[0] = all->high[0] + 1;
    assert_int_equal(interior_state(&bricks, &middle), GRAZE_STATE_ABSENT);
    middle.high[0] = NAN;
    assert_int_equal(interior_state(&bricks, &middle), GRAZE_STATE_ABSENT);
    interior_clear(&bricks);
    assert_int_equal(interior_state(&bricks, &middle), GRAZE_STATE_ABSENT);
    graze_solid_destroy(solid);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_places, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_beyond, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
