/* Pairs of segments that may meet during an interval, the bounds that leave others out, and the
 * times that a deep vertex gives, of quadrilaterals that move along x (proofs/collision.md C108,
 * C112). SPDX-License-Identifier: GPL-3.0-or-later
 *
 * S = [x, x + 1] x [0, 1], where x is a polynomial in t. Its segments are its sides.
 */
#include <math.h>
#include "base/number/text.h"
#include "questions/collide/near_pairs.h"
#include "motion_fixture.h"

#define STEP 0x1p-20

static const double unit_square[] = {0, 0, 1, 0, 1, 1, 0, 1};
/* [3, 4] x [0, 1] */
static const double wall[] = {3, 0, 4, 0, 4, 1, 3, 1};

enum { RING_MOST = 32 };

static graze_solid *polygon(const double *at, size_t count) {
    size_t ring[RING_MOST];
    graze_solid *out = NULL;
    for (size_t k = 0; k < count; k++)
        ring[k] = k;
    assert_int_equal(graze_solid_from_doubles(&out, context, 2, at, count, &count, 1, ring, 0),
                     GRAZE_OK);
    return out;
}

/* S, a motion, a fixed polygon, and the motion's control maps. */
typedef struct scene {
    graze_solid *moving, *fixed;
    graze_motion *motion;
    solid_pair pair;
    dyadic_interval unit;
    map_forms forms;
    control_maps maps;
} scene;

static void scene_open(scene *s, const char *x, const double *fixed) {
    char text[200];
    snprintf(text, sizeof text,
             "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
             "{\"translate\": [\"%s\", 0]}}]}",
             x);
    *s = (scene){
        .moving = polygon(unit_square, 4), .fixed = polygon(fixed, 4), .motion = make(text)};
    s->pair = (solid_pair){.moving = s->moving, .fixed = s->fixed, .motion = s->motion};
    dyadic_interval_init(&s->unit);
    dyadic_interval_set_si(&s->unit, 0, 1);
    map_forms_init(&s->forms, &s->motion->piece[0].forward, &s->unit);
    assert_int_equal(control_maps_set(&s->maps, &s->forms), 1);
}

static void scene_close(scene *s) {
    control_maps_clear(&s->maps);
    map_forms_clear(&s->forms);
    dyadic_interval_clear(&s->unit);
    graze_motion_destroy(s->motion);
    graze_solid_destroy(s->fixed);
    graze_solid_destroy(s->moving);
}

/* The list that is left with bounds of the clearance; `coarse`: the number of pairs of nodes that
 * wait for shorter intervals, or NULL for a list at once. */
static node_list refined(const scene *s, double least, double most, size_t *coarse) {
    node_pair roots = {0, 0};
    const node_list all = {.count = 1, .item = &roots};
    node_list near = {0}, waiting = {0};
    control_maps maps = s->maps;
    maps.least = least;
    maps.most = most;
    assert_int_equal(near_pairs_refine(&near, coarse ? &waiting : NULL, context, &s->pair, &maps,
                                       &all, coarse == NULL),
                     GRAZE_OK);
    if (coarse)
        *coarse = waiting.count;
    node_list_clear(&waiting);
    node_list_clear(&near);
    return near;
}

/* S at rest, 2 from the wall. Within 2 of one another: right side and left side, each of these and
 * the two sides beside the other, bottom and bottom, top and top. Bottom and top are at the root of
 * 5, other pairs at 3. */
static void clearances_at_rest(void **state) {
    (void)state;
    scene s;
    scene_open(&s, "0", wall);
    assert_int_equal(refined(&s, 0, 0, NULL).count, 0);
    assert_int_equal(refined(&s, 0, 2 - STEP, NULL).count, 0);
    assert_int_equal(refined(&s, 0, 2, NULL).count, 7);
    assert_int_equal(refined(&s, 0, 2 + STEP, NULL).count, 7);
    assert_int_equal(refined(&s, 0, sqrt(5) + STEP, NULL).count, 9);
    assert_int_equal(refined(&s, 2, 2, NULL).within, 0);
    assert_int_equal(refined(&s, 2 + STEP, 2 + STEP, NULL).within, 1);
    scene_close(&s);
}

/* Beyond the range of corners in doubles only boxes tell: sides of 2^201, 2 of them apart. A corner
 * at exactly the clearance is near: 3, 4, 5. */
static void boxes_alone(void **state) {
    (void)state;
    const double unit = 0x1p201,
                 far[] = {1 + 3e13, 1 + 4e13, 2 + 3e13, 1 + 4e13, 2 + 3e13, 2 + 4e13};
    double large[8], larger_wall[8];
    scene s;
    for (int k = 0; k < 8; k++) {
        large[k] = unit_square[k] * unit;
        larger_wall[k] = wall[k] * unit;
    }
    scene_open(&s, "0", larger_wall);
    graze_solid *small = s.moving;
    s.pair.moving = s.moving = polygon(large, 4);
    graze_solid_destroy(small);
    assert_null(s.pair.moving->corners.at);
    assert_int_equal(refined(&s, 0, 0, NULL).count, 0);
    assert_int_equal(refined(&s, 0, 1.99 * unit, NULL).count, 0);
    assert_int_equal(refined(&s, 0, 2.01 * unit, NULL).count, 7);
    /* right and left side: the diagonal of [1, 3] x [0, 1] */
    assert_int_equal(refined(&s, 2.23 * unit, 2.23 * unit, NULL).within, 0);
    assert_int_equal(refined(&s, 2.24 * unit, 2.24 * unit, NULL).within, 1);
    scene_close(&s);
    /* side by side, of length 2^-700 */
    for (int k = 0; k < 8; k++) {
        large[k] = unit_square[k] * 0x1p-700;
        larger_wall[k] = (unit_square[k] + (k % 2 == 0)) * 0x1p-700;
    }
    scene_open(&s, "0", larger_wall);
    small = s.moving;
    s.pair.moving = s.moving = polygon(large, 4);
    graze_solid_destroy(small);
    assert_int_equal(refined(&s, 0, 0, NULL).count, 7);
    scene_close(&s);
    scene_open(&s, "0", wall);
    graze_solid_destroy(s.fixed);
    s.pair.fixed = s.fixed = polygon(far, 3);
    assert_int_equal(refined(&s, 0, 5e13, NULL).count, 4);
    assert_int_equal(refined(&s, 0, 4.99e13, NULL).count, 0);
    scene_close(&s);
}

/* x = c + w t: S sweeps a box of length w + 1. It waits for shorter intervals if that is more than
 * 1 and the length of the other's sides, 1 or 8, or 1/16 of the clearance. */
static void waiting_for_shorter(void **state) {
    (void)state;
    static const double hall[] = {3, 0, 11, 0, 11, 8, 3, 8};
    size_t waiting;
    scene s;
    scene_open(&s, "t*1048575/1048576+2", wall);
    assert_true(refined(&s, 0, 0, &waiting).count > 0);
    assert_int_equal(waiting, 0);
    scene_close(&s);
    scene_open(&s, "t*1048577/1048576+2", wall);
    assert_int_equal(refined(&s, 0, 0, &waiting).count, 0);
    assert_int_equal(waiting, 1);
    assert_true(refined(&s, 0, 0, NULL).count > 0);
    scene_close(&s);
    scene_open(&s, "t*8388607/1048576+2", hall);
    assert_true(refined(&s, 0, 0, &waiting).count > 0);
    assert_int_equal(waiting, 0);
    scene_close(&s);
    scene_open(&s, "t*8388609/1048576+2", hall);
    assert_int_equal(refined(&s, 0, 0, &waiting).count, 0);
    assert_int_equal(waiting, 1);
    scene_close(&s);
    /* 66 to 62 from the wall, clearance 64 */
    scene_open(&s, "t*4194303/1048576-64", wall);
    assert_int_equal(refined(&s, 64, 64, &waiting).within, 0);
    assert_true(refined(&s, 64, 64, &waiting).count > 0);
    assert_int_equal(waiting, 0);
    scene_close(&s);
    scene_open(&s, "t*4194305/1048576-64", wall);
    assert_int_equal(refined(&s, 64, 64, &waiting).count, 0);
    assert_int_equal(waiting, 1);
    scene_close(&s);
}

/* x = 2 t: both maps are moved by 0 and 2. On halves: by 0 and 1, by 1 and 2. */
static void maps_of_a_translation(void **state) {
    (void)state;
    map_forms right;
    box image;
    scene s;
    scene_open(&s, "2*t-1", wall);
    const double *e = s.maps.entry;
    assert_int_equal(s.maps.count, 2);
    assert_true(s.maps.slope == 1 && s.maps.shift == 1);
    for (int k = 0; k < 2; k++, e += 6)
        assert_true(e[0] == 1 && e[1] == 0 && e[2] == 2 * k - 1 && e[3] == 0 && e[4] == 1 &&
                    e[5] == 0);
    control_maps_bound(&image, &s.maps, &s.moving->boxes.node[0].box);
    assert_true(fabs(image.low[0] + 1) < STEP && fabs(image.high[0] - 2) < STEP);
    assert_true(image.low[0] <= -1 && image.high[0] >= 2 && image.low[1] <= 0 &&
                image.high[1] >= 1 && image.high[1] < 1 + STEP && image.high[2] == 0);
    map_forms_split(&s.forms, &right);
    assert_int_equal(control_maps_set(&s.maps, &s.forms), 1);
    assert_true(s.maps.entry[2] == -1 && s.maps.entry[8] == 0 && s.maps.shift == 1);
    assert_int_equal(control_maps_set(&s.maps, &right), 1);
    assert_true(s.maps.entry[2] == 0 && s.maps.entry[8] == 1);
    map_forms_clear(&right);
    scene_close(&s);
}

/* Set control maps of the plane: entries `entry` times the identity, moved by `shift`, over
 * `weight`. */
static int maps_of(control_maps *maps, const char *entry, const char *shift, const char *weight) {
    point_map map;
    map_forms forms;
    dyadic_interval unit;
    point_map_init(&map, 2);
    fmpz_poly_set_str(&map.entry[0], entry);
    fmpz_poly_set_str(&map.entry[4], entry);
    fmpz_poly_set_str(&map.entry[2], shift);
    fmpz_poly_set_str(map.weight, weight);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    map_forms_init(&forms, &map, &unit);
    int made = control_maps_set(maps, &forms);
    map_forms_clear(&forms);
    dyadic_interval_clear(&unit);
    point_map_clear(&map);
    return made;
}

/* Quotients, those past doubles too; a weight whose Bernstein coefficients are not all positive
 * gives none. */
static void maps_by_weight(void **state) {
    (void)state;
    control_maps maps = {0};
    box image;
    const box square = {{0, 0, 0}, {1, 1, 0}};
    /* weight 1 + 2 t: 1 and 3; entries 3 + 2 t: 3 and 5, so 3 and 5/3 */
    assert_int_equal(maps_of(&maps, "2  3 2", "1  -7", "2  1 2"), 1);
    assert_int_equal(maps.count, 2);
    assert_true(maps.entry[0] == 3 && fabs(maps.entry[6] * 3 - 5) < 0x1p-45);
    assert_true(maps.entry[2] == -7 && maps.shift == 7 && maps.slope == 3);
    /* 1 - 3 t + 3 t^2 > 0 has the coefficients 1, -1/2, 1 */
    assert_int_equal(maps_of(&maps, "1  1", "1  1", "3  1 -3 3"), 1);
    assert_int_equal(maps.count, 0);
    control_maps_bound(&image, &maps, &square);
    assert_true(image.low[0] == -INFINITY && image.high[1] == INFINITY && image.high[2] == 0);
    /* 1 - 2 t + t^2 has a root at 1 */
    assert_int_equal(maps_of(&maps, "1  1", "1  1", "3  1 -2 1"), 1);
    assert_int_equal(maps.count, 0);
    control_maps_clear(&maps);
    char large[400] = "1  1";
    memset(large + 4, '0', 330);
    assert_int_equal(maps_of(&maps, "1  1", large, "1  1"), 1); /* 10^330 */
    assert_true(maps.entry[2] == INFINITY && maps.shift == INFINITY);
    control_maps_bound(&image, &maps, &square);
    assert_true(image.low[0] == -INFINITY && image.high[0] == INFINITY && image.high[1] < 2);
    assert_int_equal(maps_of(&maps, "1  1", "1  -1", large), 1); /* 10^-330 is 0 */
    assert_true(maps.entry[0] == 0 && maps.entry[2] == 0);
    large[4 + 300] = 0;
    assert_int_equal(maps_of(&maps, "1  1", large, "1  1"), 1); /* 10^300 */
    assert_true(fabs(maps.entry[2] / 1e300 - 1) < 0x1p-45);
    control_maps_clear(&maps);
}

/* The bounds of a clearance of 2 times the root of over / under on [0, 1], or on its left half. */
static void check_clearance(const char *over, const char *under, int left, double least,
                            double most) {
    clearance near;
    fmpq_t distance;
    dyadic_interval interval, half;
    control_maps maps = {0};
    const solid_pair pair = {0};
    fmpq_init(distance);
    fmpq_set_si(distance, 2, 1);
    clearance_init(&near, distance);
    fmpz_poly_set_str(&near.ratio[0].square[0], over);
    fmpz_poly_set_str(&near.ratio[0].square[1], under);
    const placing p = {.pair = &pair, .near = &near};
    dyadic_interval_init(&interval);
    dyadic_interval_init(&half);
    dyadic_interval_set_si(&interval, 0, 1);
    if (left)
        dyadic_interval_halves(&interval, &half, &interval);
    clearance_enclose(&maps, &p, &interval);
    assert_true(maps.least <= least && maps.least >= least * (1 - STEP));
    assert_true(maps.most >= most && (isinf(most) || maps.most <= most * (1 + STEP)));
    dyadic_interval_clear(&interval);
    dyadic_interval_clear(&half);
    clearance_clear(&near);
    fmpq_clear(distance);
}

/* Quotients of Bernstein coefficients, where those of the denominator are positive. */
static void bounds_of_clearance(void **state) {
    (void)state;
    check_clearance("1  1", "1  1", 0, 2, 2);
    /* (1 + t)^2: 1, 2, 4; on [0, 1/2] 1, 3/2, 9/4 */
    check_clearance("3  1 2 1", "1  1", 0, 2, 4);
    check_clearance("3  1 2 1", "1  1", 1, 2, 3);
    /* 4 - 3 t: 4, 1 over 1 + 3 t: 1, 4 */
    check_clearance("2  4 -3", "2  1 3", 0, 1, 4);
    /* 1 - 3 t + 3 t^2: 1, -1/2, 1 */
    check_clearance("1  1", "3  1 -3 3", 0, 0, INFINITY);
    check_clearance("3  1 -3 3", "1  1", 0, 0, INFINITY);
    /* 1 - 2 t + t^2: 1, 0, 0; t is 0 at 0 */
    check_clearance("1  1", "3  1 -2 1", 0, 0, INFINITY);
    check_clearance("2  0 1", "1  1", 0, 0, 2);
}

/* The interval of [from, to] / 2^exponent about whose middle a vertex is deep. */
static void find_deep(deep_interval *out, scene *s, slong from, slong to, ulong exponent) {
    node_pair roots = {0, 0};
    const node_list all = {.count = 1, .item = &roots};
    node_list leaves = {0};
    near_list near = {0};
    placing whole;
    assert_int_equal(near_pairs_refine(&leaves, NULL, context, &s->pair, &s->maps, &all, 1),
                     GRAZE_OK);
    assert_int_equal(near_pairs_take(&near, context, &s->pair, &leaves), GRAZE_OK);
    fmpz_set_si(s->unit.low, from);
    fmpz_set_si(s->unit.high, to);
    s->unit.exponent = exponent;
    placing_init(&whole, context, &s->pair, 0, NULL);
    assert_int_equal(deep_vertex_find(out, &whole, 0, &near, &s->unit), GRAZE_OK);
    placing_clear(&whole);
    near_list_clear(&near);
    node_list_clear(&leaves);
}

static void expect(const deep_interval *deep, slong low, ulong of, slong high, ulong over) {
    fmpq_t want;
    fmpq_init(want);
    fmpq_set_si(want, low, of);
    assert_true(fmpq_equal(want, deep->low));
    fmpq_set_si(want, high, over);
    assert_true(fmpq_equal(want, deep->high));
    fmpq_clear(want);
}

/* x = 16 t. A vertex is inside between its places on the boundary, whatever the interval. */
static void deep_vertices(void **state) {
    (void)state;
    static const double hall[] = {3, -9, 11, -9, 11, 9, 3, 9};
    static const double upper[] = {3, 0.5, 11, 0.5, 11, 9, 3, 9};
    static const double slanted[] = {3, -5, 6, -5, 16, 5, 3, 5};
    static const double small[] = {3, 0.25, 3.25, 0.25, 3.25, 0.5, 3, 0.5};
    deep_interval deep;
    scene s;
    fmpq_init(deep.low);
    fmpq_init(deep.high);
    /* vertices 1 and 2 are in [3, 11] if 2 < x < 10; 0 and 3 if 3 < x < 11 */
    scene_open(&s, "16*t", hall);
    find_deep(&deep, &s, 0, 1, 2); /* x = 2 in the middle: vertex 1 is on the side */
    expect(&deep, 0, 1, 0, 1);
    find_deep(&deep, &s, 1, 2, 3); /* x = 3: vertex 1 is inside, 0 on the side */
    expect(&deep, 1, 8, 5, 8);
    find_deep(&deep, &s, 5, 6, 3); /* x = 11 */
    expect(&deep, 0, 1, 0, 1);
    find_deep(&deep, &s, 10, 11, 4); /* x = 21/2: vertex 0 is inside */
    expect(&deep, 3, 16, 11, 16);
    scene_close(&s);
    /* 3 <= x <= 11 + y: the lower vertices are inside for 8/16, the upper ones, 9/16 */
    scene_open(&s, "16*t", slanted);
    find_deep(&deep, &s, 1, 3, 3); /* x = 4 */
    fmpq_sub(deep.high, deep.high, deep.low);
    fmpq_mul_2exp(deep.high, deep.high, 4);
    assert_int_equal(fmpq_cmp_si(deep.high, 9), 0);
    scene_close(&s);
    /* x = 17/8: the side x = 3 is in S if 2 < x < 3, the side x = 13/4 is not */
    scene_open(&s, "16*t", small);
    find_deep(&deep, &s, 8, 9, 6);
    expect(&deep, 1, 8, 3, 16);
    scene_close(&s);
    /* vertices 2 and 3 are inside all the time */
    scene_open(&s, "t+4", upper);
    find_deep(&deep, &s, 0, 1, 0);
    expect(&deep, -1, 1, 2, 1);
    scene_close(&s);
    fmpq_clear(deep.low);
    fmpq_clear(deep.high);
}

/* A comb: a bar [0, 104] x [-4, 1], seven bars [0, 104] x [2 k, 2 k + 1] above, joined for x >=
 * 100. */
static graze_solid *comb(void) {
    double at[2 * RING_MOST] = {0, -4, 104, -4, 104, 15};
    double *next = at + 6;
    for (int k = 7; k >= 1; k--) {
        const double bar[] = {0, 2 * k + 1, 0, 2 * k, 100, 2 * k, 100, 2 * k - 1};
        memcpy(next, bar, sizeof bar);
        next += 8;
    }
    next[1] = 1;
    return polygon(at, RING_MOST);
}

/* The times that the walk of [20, 22] x [y - 1, y + 20] through the comb keeps, between commas; the
 * word must be "I". */
static void check_times(const char *y, const char *expected) {
    static const double tall[] = {20, -1, 22, -1, 22, 20, 20, 20};
    char text[200], found[200] = "";
    snprintf(text, sizeof text,
             "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": "
             "{\"translate\": [\"t\", \"%s\"]}}]}",
             y);
    graze_solid *moving = polygon(tall, 4), *fixed = comb();
    graze_motion *motion = make(text);
    graze_pair pair = {.pair = {.moving = moving, .fixed = fixed, .motion = motion}};
    fmpq_init(pair.distance);
    assert_int_equal(collide_answer(&pair, context), GRAZE_OK);
    assert_string_equal(pair.walk.word, "I");
    for (size_t k = 0; k < pair.walk.time_count; k++) {
        char *time = rational_text(pair.walk.time[k]->u.value);
        strcat(strcat(found, k ? "," : ""), time);
        free(time);
    }
    assert_string_equal(found, expected);
    collide_clear(&pair);
    graze_motion_destroy(motion);
    graze_solid_destroy(moving);
    graze_solid_destroy(fixed);
}

/* Its upright sides cross the 15 levels of the comb: 30 pairs are near. Where a deep vertex, one of
 * the lower corners, covers a quarter of an interval, that is halved; where it covers all, it is
 * passed over. At times at which the corners reach a level the interiors meet, too. */
static void passes(void **state) {
    (void)state;
    check_times("0", "1/2,1");
    /* y - 1 = 32 t/9 - 1 is 1 at 9/16, 2 at 27/32: past 1/2 an eighth is covered */
    check_times("32*t/9", "1/2,9/16,27/32");
    /* backwards: between 1/2 and 1 a vertex is sought anew */
    check_times("32*(1-t)/9", "5/32,7/16,3/4,1");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(clearances_at_rest, set_up, tear_down),
        cmocka_unit_test_setup_teardown(boxes_alone, set_up, tear_down),
        cmocka_unit_test_setup_teardown(waiting_for_shorter, set_up, tear_down),
        cmocka_unit_test_setup_teardown(maps_of_a_translation, set_up, tear_down),
        cmocka_unit_test_setup_teardown(maps_by_weight, set_up, tear_down),
        cmocka_unit_test_setup_teardown(bounds_of_clearance, set_up, tear_down),
        cmocka_unit_test_setup_teardown(deep_vertices, set_up, tear_down),
        cmocka_unit_test_setup_teardown(passes, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
