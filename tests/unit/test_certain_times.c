/* Times with a certain state (proofs/cells.md C76 (b)), from crossings set by hand.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "../lib/harness.h"
#include "decide/filter/filter.h"

/* Look among `count` crossings; windows and lost pieces as many as given. */
static int find(piece_time *out, crossing *item, size_t count, size_t pieces, int outside,
                size_t windows, size_t lost) {
    findings found = {
        .crossing_count = count, .crossing = item, .window_count = windows, .lost_count = lost};
    return certain_times_find(out, &found, pieces, outside);
}

static void expect_time(const piece_time *s, uint32_t piece, double at) {
    assert_int_equal(s->piece, piece);
    assert_true(s->at == at);
}

/* In from 1/4 on, out from 3/4 on. */
static void one_piece(void **state) {
    (void)state;
    piece_time s[CERTAIN_TIMES_MOST];
    crossing item[] = {{.from = 0.25, .to = 0.25, .enters = 1},
                       {.from = 0.75, .to = 0.75, .enters = 0}};
    assert_int_equal(find(s, item, 2, 1, 0, 0, 0), 1);
    expect_time(&s[0], 0, 0.5);
    assert_int_equal(find(s, item, 2, 1, 1, 0, 0), 2);
    expect_time(&s[0], 0, 0.125);
    expect_time(&s[1], 0, 0.875);
}

/* In from the middle of piece 0 to that of piece 3: a whole piece between them is the longest
 * stretch; of the two halves, as long as each other, the first one is kept. */
static void many_pieces(void **state) {
    (void)state;
    piece_time s[CERTAIN_TIMES_MOST];
    crossing item[] = {{.from = 0.5, .to = 0.5, .enters = 1},
                       {.from = 0.5, .to = 0.5, .piece = 3, .enters = 0}};
    assert_int_equal(find(s, item, 2, 4, 0, 0, 0), 2);
    expect_time(&s[0], 1, 0.5);
    expect_time(&s[1], 0, 0.75);
    item[1].piece = 1; /* no whole piece */
    assert_int_equal(find(s, item, 2, 2, 0, 0, 0), 2);
    expect_time(&s[0], 0, 0.75);
    expect_time(&s[1], 1, 0.25);
}

/* Stretches of growing length: the last two are the longest, the last one first. Of falling length:
 * the first two. */
static void longest_first(void **state) {
    (void)state;
    piece_time s[CERTAIN_TIMES_MOST];
    crossing item[] = {{.from = 0, .to = 0, .enters = 1},
                       {.from = 0.0625, .to = 0.0625, .enters = 0},
                       {.from = 0.125, .to = 0.125, .enters = 1},
                       {.from = 0.25, .to = 0.25, .enters = 0},
                       {.from = 0.5, .to = 0.5, .enters = 1}};
    assert_int_equal(find(s, item, 5, 1, 0, 0, 0), 2);
    expect_time(&s[0], 0, 0.75);
    expect_time(&s[1], 0, 0.1875);
    crossing falling[] = {{.from = 0.5, .to = 0.5, .enters = 0},
                          {.from = 0.625, .to = 0.625, .enters = 1},
                          {.from = 0.875, .to = 0.875, .enters = 0},
                          {.from = 0.9375, .to = 0.9375, .enters = 1}};
    assert_int_equal(find(s, falling, 4, 1, 0, 0, 0), 2);
    expect_time(&s[0], 0, 0.25);
    expect_time(&s[1], 0, 0.75);
}

/* Uncertain findings give no time: no crossing, a window, a lost piece, two ways in behind one
 * another, and no double between two crossings. */
static void nothing_certain(void **state) {
    (void)state;
    piece_time s[CERTAIN_TIMES_MOST];
    crossing item[] = {{.from = 0.5, .to = 0.5, .enters = 1},
                       {.from = 0.75, .to = 0.75, .enters = 0}};
    assert_int_equal(find(s, item, 0, 1, 0, 0, 0), 0);
    assert_int_equal(find(s, item, 2, 1, 0, 1, 0), 0);
    assert_int_equal(find(s, item, 2, 1, 0, 0, 1), 0);
    item[1].enters = 1;
    assert_int_equal(find(s, item, 2, 1, 0, 0, 0), 0);
    item[1] = (crossing){.from = nextafter(0.5, 1), .to = 1, .enters = 0};
    assert_int_equal(find(s, item, 2, 1, 0, 0, 0), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_piece), cmocka_unit_test(many_pieces),
                                       cmocka_unit_test(longest_first),
                                       cmocka_unit_test(nothing_certain)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
