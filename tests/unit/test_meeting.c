/* Boundaries and their images, by trees (decide/scene/scene.h) against all simplices at once.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The solids are boxes apart from each other; a third of the maps are moves by whole numbers, under
 * which faces come to lie on faces or just beside them.
 */
#include <flint/fmpq_mat.h>
#include <flint/fmpq_vec.h>
#include "../lib/random.h"
#include "decide/scene/scene.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "fixture.h"

enum { SOLIDS = 60, MAPS = 12, PLACES = 4, MOST_BOXES = 12 };

typedef struct boxes {
    size_t count;
    mpq_t x[MOST_BOXES * 8 * 3];
    size_t size[MOST_BOXES * 6], index[MOST_BOXES * 24];
} boxes;

static const size_t AROUND[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

/* A box in a place of its own, from 1 to 2 wide along each axis. */
static void add_box(boxes *b, slong place) {
    slong at[3] = {3 * (place % PLACES), 3 * (place / PLACES % PLACES),
                   3 * (place / PLACES / PLACES)};
    slong low[3], high[3];
    for (int i = 0; i < 3; i++) {
        low[i] = 8 * at[i] + draw_below(4);
        high[i] = low[i] + 8 + draw_below(5);
    }
    for (size_t corner = 0; corner < 8; corner++)
        for (size_t i = 0; i < 3; i++) {
            mpq_t *x = &b->x[(8 * b->count + corner) * 3 + i];
            mpq_init(*x);
            mpq_set_si(*x, corner >> i & 1 ? high[i] : low[i], 8);
            mpq_canonicalize(*x);
        }
    for (size_t face = 0; face < 6; face++) {
        b->size[6 * b->count + face] = 4;
        for (size_t k = 0; k < 4; k++)
            b->index[(6 * b->count + face) * 4 + k] = 8 * b->count + AROUND[face][k];
    }
    b->count++;
}

static graze_solid *random_solid(void) {
    boxes b = {.count = 0};
    graze_solid *solid;
    for (slong place = 0; place < PLACES * PLACES * PLACES && b.count < MOST_BOXES; place++)
        if (draw_below(6) == 0 || place == 7)
            add_box(&b, place);
    assert_int_equal(graze_solid_from_arrays(&solid, context, 3, b.x, 8 * b.count, b.size,
                                             6 * b.count, b.index, 0),
                     GRAZE_OK);
    for (size_t k = 0; k < 24 * b.count; k++)
        mpq_clear(b.x[k]);
    return solid;
}

/* A move by whole numbers, by eighths, or a map of small entries; 0 if it is singular. */
static int random_map(fmpq *map) {
    int kind = (int)draw_below(3), regular;
    fmpq_mat_t linear;
    fmpq_mat_init(linear, 3, 3);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++) {
            fmpq *entry = map + 4 * i + j;
            if (j == 3)
                fmpq_set_si(entry, random_about(kind ? 100 : 12), kind ? 8 : 1);
            else if (kind == 2)
                fmpq_set_si(entry, random_about(9), 7);
            else
                fmpq_set_si(entry, i == j, 1);
            if (j < 3)
                fmpq_set(fmpq_mat_entry(linear, i, j), entry);
        }
    fmpq_t determinant;
    fmpq_init(determinant);
    fmpq_mat_det(determinant, linear);
    regular = !fmpq_is_zero(determinant);
    fmpq_clear(determinant);
    fmpq_mat_clear(linear);
    return regular;
}

static void test_meeting(void **state) {
    (void)state;
    int count[2] = {0, 0};
    fmpq *map = _fmpq_vec_init(12);
    for (ulong seed = 1; seed <= SOLIDS; seed++) {
        random_start(seed);
        graze_solid *solid = random_solid();
        for (int k = 0; k < MAPS; k++) {
            int found, expected;
            if (!random_map(map))
                continue;
            assert_int_equal(meeting_find(&found, context, solid, map), GRAZE_OK);
            assert_int_equal(boundaries_meet(&expected, context, &solid->input, &solid->cut, map),
                             GRAZE_OK);
            if (found != expected)
                fail_msg("seed %lu, map %d: the boundaries %s, found %d", seed, k,
                         expected ? "meet" : "are apart", found);
            count[found]++;
        }
        graze_solid_destroy(solid);
    }
    assert_true(count[0] > SOLIDS && count[1] > SOLIDS);
    _fmpq_vec_clear(map, 12);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_meeting)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
