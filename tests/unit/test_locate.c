/* Location in a tetrahedron (input/solid/solid.h) against the signs of four determinants, at points
 * whose ray passes an edge or a corner, hits it, or misses it by about as much as doubles can tell;
 * and its box.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The second method knows no ray: x lies in the tetrahedron iff putting it in the place of a vertex
 * never changes the sign of the volume. Coordinates are thirds, sevenths and doubles in all
 * octants.
 */
#include <flint/fmpq_mat.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "../lib/random.h"
#include "input/solid/solid.h"
#include "fixture.h"

enum { ROUNDS = 400, POINTS = 40 };

static void draw_coordinate(fmpq_t out) {
    static const ulong denominator[] = {1, 3, 7, 1024};
    fmpq_set_si(out, (slong)draw_below(81) - 40, denominator[draw_below(4)]);
}

/* The sign of the volume of a tetrahedron with x in the place of vertex `k`, or its own for k = 4.
 */
static int volume_sign(const fmpq *vertex, const fmpq *x, int k) {
    fmpq_mat_t m;
    fmpq_t volume;
    fmpq_mat_init(m, 4, 4);
    fmpq_init(volume);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 3; j++)
            fmpq_set(fmpq_mat_entry(m, i, j), i == k ? x + j : vertex + 3 * i + j);
        fmpq_one(fmpq_mat_entry(m, i, 3));
    }
    fmpq_mat_det(volume, m);
    int sign = fmpq_sgn(volume);
    fmpq_mat_clear(m);
    fmpq_clear(volume);
    return sign;
}

static graze_state expected_state(const fmpq *vertex, const fmpq *x) {
    int whole = volume_sign(vertex, x, 4);
    graze_state state = GRAZE_STATE_I;
    for (int k = 0; k < 4; k++) {
        int sign = volume_sign(vertex, x, k);
        if (sign == -whole)
            return GRAZE_STATE_O;
        if (sign == 0)
            state = GRAZE_STATE_B;
    }
    return state;
}

/* A tetrahedron's facets, outward where its volume's sign is `whole`: the determinant's rows with
 * the ones behind make it negative for the usual right-handed one. */
static graze_solid *make_solid(const fmpq *vertex, int whole) {
    static const size_t size[] = {3, 3, 3, 3};
    static const size_t facet[2][12] = {{1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1},
                                        {1, 3, 2, 0, 2, 3, 0, 3, 1, 0, 1, 2}};
    mpq_t at[12];
    for (int k = 0; k < 12; k++) {
        mpq_init(at[k]);
        fmpq_get_mpq(at[k], vertex + k);
    }
    graze_solid *solid;
    assert_int_equal(
        graze_solid_from_arrays(&solid, context, 3, at, 4, size, 4, facet[whole > 0], 0), GRAZE_OK);
    for (int k = 0; k < 12; k++)
        mpq_clear(at[k]);
    return solid;
}

/* A point on an edge or at its end, moved back along the ray, and aside by very little. */
static void draw_point(fmpq *x, const fmpq *vertex) {
    fmpq_t share, step;
    int aside = draw_below(3) != 0;
    fmpq_init(share);
    fmpq_init(step);
    const fmpq *a = vertex + 3 * draw_below(4), *b = vertex + 3 * draw_below(4);
    fmpq_set_si(share, (slong)draw_below(6), 5);
    for (int j = 0; j < 3; j++) {
        fmpq_sub(x + j, b + j, a + j);
        fmpq_mul(x + j, x + j, share);
        fmpq_add(x + j, x + j, a + j);
    }
    fmpq_set_si(step, (slong)draw_below(4), 1);
    if (draw_below(2))
        fmpq_div_2exp(step, step, 50);
    fmpq_sub(x, x, step);
    for (int j = 1; j < 3 && aside; j++) {
        fmpq_set_si(step, (slong)draw_below(7) - 3, 1);
        fmpq_div_2exp(step, step, 46 + draw_below(12));
        fmpq_add(x + j, x + j, step);
    }
    fmpq_clear(share);
    fmpq_clear(step);
}

static graze_state locate(const graze_solid *solid, const fmpq *x) {
    fmpz *at = _fmpz_vec_init(4);
    _fmpq_vec_get_fmpz_vec_fmpz(at, at + 3, x, 3);
    graze_state state = solid_locate(solid, at);
    _fmpz_vec_clear(at, 4);
    return state;
}

static void check_point(const graze_solid *solid, const fmpq *vertex, const fmpq *x) {
    graze_state want = expected_state(vertex, x), got = locate(solid, x);
    if (got != want) {
        for (int k = 0; k < 15; k++) {
            char *text = fmpq_get_str(NULL, 10, k < 12 ? vertex + k : x + k - 12);
            print_message("%s%s", text, k % 3 < 2 ? " " : "\n");
            flint_free(text);
        }
        print_message("got %c, want %c\n", got, want);
    }
    assert_int_equal(got, want);
}

/* The box has no vertex beyond it and one on each side. */
static void check_box(const graze_solid *solid, const fmpq *vertex) {
    fmpq *low = _fmpq_vec_init(6), *high = low + 3;
    solid_box(low, high, solid);
    for (int i = 0; i < 3; i++) {
        int lowest = 0, highest = 0;
        for (int k = 0; k < 4; k++) {
            assert_true(fmpq_cmp(vertex + 3 * k + i, low + i) >= 0);
            assert_true(fmpq_cmp(vertex + 3 * k + i, high + i) <= 0);
            lowest += fmpq_equal(vertex + 3 * k + i, low + i);
            highest += fmpq_equal(vertex + 3 * k + i, high + i);
        }
        assert_true(lowest && highest);
    }
    _fmpq_vec_clear(low, 6);
}

static void tetrahedra(void **state) {
    (void)state;
    size_t met[3] = {0, 0, 0};
    fmpq *vertex = _fmpq_vec_init(12), *x = _fmpq_vec_init(3);
    random_start(20260722);
    for (int round = 0; round < ROUNDS; round++) {
        for (int k = 0; k < 12; k++)
            draw_coordinate(vertex + k);
        int whole = volume_sign(vertex, x, 4);
        if (whole == 0)
            continue;
        graze_solid *solid = make_solid(vertex, whole);
        check_box(solid, vertex);
        for (int n = 0; n < POINTS; n++) {
            draw_point(x, vertex);
            check_point(solid, vertex, x);
            graze_state s = expected_state(vertex, x);
            met[s == GRAZE_STATE_I ? 0 : s == GRAZE_STATE_B ? 1 : 2]++;
        }
        graze_solid_destroy(solid);
    }
    /* All three states are met often, or the points prove little. */
    for (int k = 0; k < 3; k++)
        assert_true(met[k] > ROUNDS * POINTS / 50);
    _fmpq_vec_clear(vertex, 12);
    _fmpq_vec_clear(x, 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tetrahedra)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
