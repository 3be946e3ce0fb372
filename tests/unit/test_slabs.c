/* Slabs against exact corners: those of every node hold all corners below it, of solids whose
 * coordinates are no doubles as well; what is said of boxes holds at their exact corners, and
 * of chords by hand (proofs/slabs.md C93).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <flint/fmpq_vec.h>
#include <math.h>
#include "../lib/random.h"
#include "base/number/rounding.h"
#include "decide/bounds/bounds.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "fixture.h"

enum { BOXES = 400 };

static const char *const SOLIDS[] = {"cases/bracket/solid.off", "cases/ball/solid.off",
                                     "cases/cutter/solid.off", "cases/cartridge/solid.off",
                                     "tests/examples/solids/q2.wkt"};

/* The second method: normal . x without rounding. */
static void form_at(fmpq_t out, const slab *s, const fmpq *x, int d) {
    fmpq_t normal;
    fmpq_init(normal);
    fmpq_zero(out);
    for (int i = 0; i < d; i++) {
        assert_int_equal(rational_from_double(normal, context, s->normal[i]), GRAZE_OK);
        fmpq_addmul(out, normal, x + i);
    }
    fmpq_clear(normal);
}

/* -1 below, 0 in, 1 above the slab, ends included. */
static int side_of(const slab *s, const fmpq *x, int d) {
    fmpq_t at, end;
    int side = 0;
    fmpq_init(at);
    fmpq_init(end);
    form_at(at, s, x, d);
    if (isfinite(s->low)) {
        assert_int_equal(rational_from_double(end, context, s->low), GRAZE_OK);
        side -= fmpq_cmp(at, end) < 0;
        assert_int_equal(rational_from_double(end, context, s->high), GRAZE_OK);
        side += fmpq_cmp(at, end) > 0;
    }
    fmpq_clear(at);
    fmpq_clear(end);
    return side;
}

/* Hold the exact corners below a node against the slab of one above it. */
static void check_below(const graze_solid *solid, uint32_t index, const slab *s) {
    const tree_node *node = &solid->boxes.node[index];
    int d = solid->input.dimension;
    if (node->child) {
        check_below(solid, node->child, s);
        check_below(solid, node->child + 1, s);
        return;
    }
    for (int c = 0; c < d; c++) {
        size_t vertex = solid->cut.item[node->simplex].vertex[c];
        assert_int_equal(side_of(s, solid->input.coordinates + vertex * (size_t)d, d), 0);
    }
}

static void corners_inside(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof SOLIDS / sizeof *SOLIDS; k++) {
        graze_solid *solid = NULL;
        size_t bounded = 0;
        assert_int_equal(graze_solid_read(&solid, context, SOLIDS[k], 0), GRAZE_OK);
        for (uint32_t n = 0; n < solid->boxes.node_count; n++) {
            const tree_node *node = &solid->boxes.node[n];
            if (!node->child)
                continue;
            const slab *s = slab_below(&solid->slabs, node);
            bounded += isfinite(s->low) && isfinite(s->high);
            for (int i = 0; i < 3; i++)
                assert_true(fabs(s->normal[i]) <= 1);
            check_below(solid, n, s);
        }
        /* A tree that halves n simplices again and again has about n / 3 nodes with four or more;
         * those of a whole small solid have no normal. */
        assert_true(bounded >= solid->cut.count / 8);
        graze_solid_destroy(solid);
    }
}

/* A node whose slab has bounds. */
static const tree_node *random_node(const graze_solid *solid) {
    const tree_node *node;
    do
        node = &solid->boxes.node[draw_below((slong)solid->boxes.node_count)];
    while (!node->child || !isfinite(slab_below(&solid->slabs, node)->low));
    return node;
}

/* About in the node's box, and from as large as it down to much smaller. */
static box random_box(const box *near) {
    box out;
    double thick = ldexp(fabs(random_fraction()), -(int)draw_below(12)) * box_extent(near);
    for (int i = 0; i < 3; i++) {
        double middle = 0.5 * (near->low[i] + near->high[i]);
        double at = middle + random_fraction() * (near->high[i] - near->low[i]);
        out.low[i] = at - thick;
        out.high[i] = at + thick;
    }
    return out;
}

/* The sum of the sides of its eight corners. */
static int sides_of(const slab *s, const box *b) {
    int sum = 0;
    fmpq *x = _fmpq_vec_init(3);
    for (int c = 0; c < 8; c++) {
        for (int i = 0; i < 3; i++)
            assert_int_equal(
                rational_from_double(x + i, context, c >> i & 1 ? b->high[i] : b->low[i]),
                GRAZE_OK);
        sum += side_of(s, x, 3);
    }
    _fmpq_vec_clear(x, 3);
    return sum;
}

/* A box that is said to miss a slab has all its corners beyond one side; a box with all of them
 * well beyond is said to. */
static void boxes(void **state) {
    (void)state;
    graze_solid *solid = NULL;
    int missed = 0, met = 0;
    random_start(20261123);
    assert_int_equal(graze_solid_read(&solid, context, SOLIDS[1], 0), GRAZE_OK);
    curve shape = {.dimension = 3, .corners = &solid->corners};
    for (int k = 0; k < BOXES; k++) {
        const tree_node *node = random_node(solid);
        const slab *s = slab_below(&solid->slabs, node);
        box b = random_box(&node->box);
        span all;
        span_of_box(&all, &shape, &b);
        int meets = chord_meets_slab(&all, all.wide, s), sides = sides_of(s, &b);
        assert_int_equal(meets, sides != 8 && sides != -8);
        missed += !meets;
        met += meets;
    }
    assert_true(missed > BOXES / 20);
    assert_true(met > BOXES / 20);
    graze_solid_destroy(solid);
}

/* The slab 1 <= x <= 2 and chords from x = 0: to the far side, to just before it, and to a place
 * whose thickness alone reaches it; and numbers that are none. */
static void by_hand(void **state) {
    (void)state;
    const slab s = {{1, 0, 0}, 1, 2};
    const double thin[3] = {0.125, 9, 9}, wide[3] = {0.5, 0, 0};
    span piece = {.bounded = 1, .from = {0, 5, 5}, .end = {3, 5, 5}};
    assert_int_equal(chord_meets_slab(&piece, thin, &s), 1);
    piece.end[0] = 0.75;
    assert_int_equal(chord_meets_slab(&piece, thin, &s), 0);
    assert_int_equal(chord_meets_slab(&piece, wide, &s), 1);
    piece.from[0] = 3;
    assert_int_equal(chord_meets_slab(&piece, thin, &s), 1);
    piece.end[0] = 2.25;
    assert_int_equal(chord_meets_slab(&piece, thin, &s), 0);
    assert_int_equal(chord_meets_slab(&piece, wide, &s), 1);
    piece.from[0] = NAN;
    assert_int_equal(chord_meets_slab(&piece, thin, &s), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(corners_inside, set_up, tear_down),
        cmocka_unit_test_setup_teardown(boxes, set_up, tear_down),
        cmocka_unit_test(by_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
