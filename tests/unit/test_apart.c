/* Corners and nodes that meet at a time are never said to be apart, and those that a small gap
 * parts are; corners are said to be nearer than a clearance if two of their points are
 * (proofs/collision.md C108). SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All coordinates are small multiples of 1/8, so that places are doubles exactly. The motion is
 * halfway between two maps at some time.
 */
#include <math.h>
#include "../lib/random.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/collide/collide.h"
#include "questions/collide/near_pairs.h"
#include "questions/collide/placing.h"
#include "fixture.h"

enum { ROUNDS = 4000, NODE_PAIRS = 20000, ROOM = 18 };

static double entry[24], room[ROOM], moving_at[9], fixed_at[9];
static graze_solid moving, fixed;
static const solid_pair pair = {.moving = &moving, .fixed = &fixed};
static control_maps maps = {.count = 2, .entry = entry, .room = room};

static void set_scene(int d) {
    maps.dimension = moving.input.dimension = fixed.input.dimension = d;
    maps.shift = maps.slope = 100;
    moving.corners = (corners){.at = moving_at, .reach = 8};
    fixed.corners = (corners){.at = fixed_at, .reach = 1000};
}

static int are_apart(corner_run a, corner_run b) {
    return corners_nearness(&pair, &maps, a, b, error_of_places(&pair, &maps)) == NEAR_NEVER;
}

/* Eighths of the corners of a run: the last one's are 1, 2, 4 or 8. */
static void random_weights(int out[3], corner_run run, int d) {
    int last = run.count == 1 ? 8 : 1 << draw_below(3);
    int first = run.count < 3 ? 8 - last : (int)draw_below(9 - last);
    const int weight[3][3] = {{8, 0, 0}, {first, last, 0}, {first, 8 - last - first, last}};
    out[0] = out[1] = out[2] = 0;
    for (int k = 0; k < run.count; k++)
        out[(run.first + k) % d] = weight[run.count - 1][k];
}

/* Coordinate i of corner k under both maps together. */
static double moved_twice(int k, int i, int d) {
    double sum = 0;
    for (int m = 0; m < 2; m++) {
        const double *row = entry + m * d * (d + 1) + i * (d + 1);
        sum += row[d];
        for (int j = 0; j < d; j++)
            sum += row[j] * moving_at[k * d + j];
    }
    return sum;
}

/* Put the last corner of the run that stands so that a mean of it is one of the moved run. */
static void let_meet(corner_run a, corner_run b, int d) {
    int w[3], v[3], last = (b.first + b.count - 1) % d;
    random_weights(w, a, d);
    random_weights(v, b, d);
    for (int i = 0; i < d; i++) {
        double rest = 0;
        for (int k = 0; k < d; k++) {
            rest += w[k] * moved_twice(k, i, d) / 2;
            rest -= k == last ? 0 : v[k] * fixed_at[k * d + i];
        }
        fixed_at[last * d + i] = rest / v[last];
    }
}

static void points_in_common(void **state) {
    (void)state;
    random_start(20261126);
    for (int round = 0; round < ROUNDS; round++) {
        int d = 2 + round % 2;
        corner_run a = {0, (int)draw_below(d), 1 + (int)draw_below(d)};
        corner_run b = {0, (int)draw_below(d), 1 + (int)draw_below(d)};
        set_scene(d);
        for (int k = 0; k < 2 * d * (d + 1); k++)
            entry[k] = (double)random_about(4);
        for (int k = 0; k < d * d; k++) {
            moving_at[k] = (double)random_about(8);
            fixed_at[k] = (double)random_about(8);
        }
        let_meet(a, b, d);
        assert_false(are_apart(a, b));
    }
}

/* The corners in place under one map, and moved by 8 along `way` under the other one. */
static void set_triangles(const double a[9], const double b[9], int d, int way) {
    set_scene(d);
    memcpy(moving_at, a, sizeof moving_at);
    memcpy(fixed_at, b, sizeof fixed_at);
    memset(entry, 0, sizeof entry);
    for (int m = 0; m < 2; m++)
        for (int i = 0; i < d; i++)
            entry[m * d * (d + 1) + i * (d + 1) + i] = 1;
    entry[d * (d + 1) + way * (d + 1) + d] = 8;
}

/* Corners that touch are apart once a gap along an axis parts them, whatever way across it they
 * go; but not if they go back through it. */
static void part(const double a[9], const double b[9], int d, int axis, double gap, corner_run run,
                 corner_run other) {
    double moved[9];
    int way = (axis + 1) % d;
    memcpy(moved, a, sizeof moved);
    set_triangles(moved, b, d, way);
    assert_false(are_apart(run, other));
    for (int k = 0; k < d; k++)
        moved[d * k + axis] += gap;
    set_triangles(moved, b, d, way);
    assert_true(are_apart(run, other));
    set_triangles(moved, b, d, axis);
    assert_int_equal(are_apart(run, other), gap > 0);
}

static void gaps(void **state) {
    (void)state;
    static const double flat[9] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    static const double above[9] = {1, 1, 0, 2, 1, 8, 1, 2, 8};
    static const double below[9] = {1, 1, 0, 2, 1, -8, 1, 2, -8};
    static const double beside[9] = {4, 0, 0, 9, -1, 0, 9, 1, 0};
    /* Edges along x and y cross at the origin; only a plane along both parts the triangles. */
    static const double ridge[9] = {0, -2, 0, 0, 2, 0, 9, 0, 9};
    static const double valley[9] = {-2, 0, 0, 2, 0, 0, 0, -9, -9};
    static const double segment[9] = {1, 0, 2, 3}, floor[9] = {0, 0, 4, 0};
    static const corner_run all = {0, 0, 3}, tip = {0, 0, 1}, edge = {0, 0, 2};
    part(above, flat, 3, 2, 0x1p-25, all, all);
    part(above, flat, 3, 2, 0x1p-25, tip, all);
    part(flat, below, 3, 2, 0x1p-25, all, all);
    part(flat, below, 3, 2, 0x1p-25, all, tip);
    part(below, flat, 3, 2, -0x1p-25, all, all);
    part(beside, flat, 3, 0, 0x1p-25, all, all);
    part(ridge, valley, 3, 2, 0x1p-25, all, all);
    part(ridge, valley, 3, 2, 0x1p-25, edge, edge);
    part(segment, floor, 2, 1, 0x1p-25, edge, edge);
    part(floor, segment, 2, 1, -0x1p-25, edge, edge);
    part(segment, floor, 2, 1, 0x1p-25, tip, edge);
}

static nearness nearness_at(double clearance, corner_run a, corner_run b) {
    maps.least = maps.most = clearance;
    nearness found = corners_nearness(&pair, &maps, a, b, error_of_places(&pair, &maps));
    maps.least = maps.most = 0;
    return found;
}

/* A tip is at height 1 over an edge, and moved by `way` along it under the second of two maps,
 * which is the middle one; or the edge is moved. Places that are 1 apart under that map are the
 * root of way^2 + 1 apart under the first. */
static void over_edge(double way, double clearance, nearness expected) {
    static const corner_run tip = {0, 0, 1}, edge = {0, 0, 2};
    for (int d = 2; d <= 3; d++)
        for (int side = 0; side < 2; side++) {
            double one[9] = {0}, other[9] = {0};
            one[1] = 1;
            other[0] = -100;
            other[d] = 100;
            set_triangles(side ? other : one, side ? one : other, d, 0);
            entry[d * (d + 1) + d] = way;
            assert_int_equal(nearness_at(clearance, side ? edge : tip, side ? tip : edge),
                             expected);
        }
}

/* Nearer always if the clearance is above that root, soon if it is above 2 and a 16th of the root,
 * never if it is below 1. */
static void nearness_by_hand(void **state) {
    (void)state;
    const double step = 0x1p-20, far = sqrt(10), further = sqrt(1601);
    over_edge(0, 1 - step, NEAR_NEVER);
    over_edge(0, 1, NEAR_UNKNOWN);
    over_edge(0, 1 + step, NEAR_ALWAYS);
    over_edge(3, 1 - step, NEAR_NEVER);
    over_edge(3, 1 + step, NEAR_UNKNOWN);
    over_edge(3, 2 - step, NEAR_UNKNOWN);
    over_edge(3, 2 + step, NEAR_SOON);
    over_edge(3, far - step, NEAR_SOON);
    over_edge(3, far + step, NEAR_ALWAYS);
    over_edge(40, further / 16 - step, NEAR_UNKNOWN);
    over_edge(40, further / 16 + step, NEAR_SOON);
    over_edge(-40, further - step, NEAR_SOON);
    over_edge(-40, further + step, NEAR_ALWAYS);
    /* (1, -1) and the line x = y: the root of 2, while 2 is the sum of the ways along both axes */
    static const double point[9] = {1, -1}, slope[9] = {-100, -100, 100, 100};
    static const corner_run tip = {0, 0, 1}, edge = {0, 0, 2};
    set_triangles(point, slope, 2, 0);
    entry[8] = 0;
    assert_int_equal(nearness_at(sqrt(2) - step, tip, edge), NEAR_NEVER);
    assert_int_equal(nearness_at(sqrt(2) + step, tip, edge), NEAR_ALWAYS);
}

/* Places past the range in which something is known. */
static void far_off(void **state) {
    (void)state;
    set_scene(3);
    maps.slope = 0x1p201;
    assert_true(isinf(error_of_places(&pair, &maps)));
    maps.slope = 1;
    maps.shift = INFINITY;
    assert_true(isinf(error_of_places(&pair, &maps)));
    maps.shift = 1;
    moving.corners.at = NULL;
    assert_true(isinf(error_of_places(&pair, &maps)));
}

/* Mark the vertices below a node, or look for a marked one. */
static int vertices_below(unsigned char *mark, int look, const graze_solid *solid, uint32_t index) {
    const tree_node *n = &solid->boxes.node[index];
    int found = 0;
    if (n->child) {
        found = vertices_below(mark, look, solid, n->child);
        return vertices_below(mark, look, solid, n->child + 1) || found;
    }
    for (int k = 0; k < solid->input.dimension; k++) {
        unsigned char *m = &mark[solid->cut.item[n->simplex].vertex[k]];
        found |= *m;
        *m = look ? *m : 1;
    }
    return found;
}

/* A solid against itself, halfway at rest: nodes with a vertex in common meet. Of others whose
 * boxes meet, some are told. */
static void nodes(const char *path) {
    graze_solid *solid = NULL;
    int told = 0;
    assert_int_equal(graze_solid_read(&solid, context, path, 0), GRAZE_OK);
    const solid_pair self = {.moving = solid, .fixed = solid};
    const double size = solid->corners.reach;
    for (int k = 0; k < NODE_PAIRS; k++) {
        uint32_t a = (uint32_t)draw_below((slong)solid->boxes.node_count);
        uint32_t b = (uint32_t)draw_below((slong)solid->boxes.node_count);
        set_triangles(moving_at, fixed_at, solid->input.dimension, 0);
        for (int i = 0; i < maps.dimension * (maps.dimension + 1); i++) {
            double by = (double)random_about(8) * 0x1p-12 *
                        (i % (maps.dimension + 1) < maps.dimension ? 1 : size);
            entry[maps.dimension * (maps.dimension + 1) + i] = entry[i] + by;
            entry[i] -= by;
        }
        if (!box_meets(&solid->boxes.node[a].box, &solid->boxes.node[b].box) ||
            !slabs_apart(&self, &maps, a, b, error_of_places(&self, &maps)))
            continue;
        unsigned char *mark = calloc(solid->input.vertex_count, 1);
        assert_non_null(mark);
        vertices_below(mark, 0, solid, a);
        assert_false(vertices_below(mark, 1, solid, b));
        free(mark);
        told++;
    }
    assert_true(told > 20);
    graze_solid_destroy(solid);
}

/* One node and one slab of each solid; a leaf has none. Boxes are [-1, 1] along each axis. */
static tree_node moving_node, fixed_node;
static slab moving_slab[2], fixed_slab[2];

static void set_node(graze_solid *solid, tree_node *node, slab *two, int d, const slab *own) {
    *node = (tree_node){.child = own != NULL, .slab = own ? 1 : 0};
    for (int i = 0; i < d; i++) {
        node->box.low[i] = -1;
        node->box.high[i] = 1;
    }
    two[0] = (slab){{0, 0, 0}, -INFINITY, INFINITY};
    two[1] = own ? *own : two[0];
    solid->boxes = (tree){1, node};
    solid->slabs.item = two;
}

/* The leaf becomes a point. */
static void set_point(tree_node *leaf, const double p[3], int d) {
    for (int i = 0; i < d; i++)
        leaf->box.low[i] = leaf->box.high[i] = p[i];
}

static int are_told(void) {
    return slabs_apart(&pair, &maps, 0, 0, error_of_places(&pair, &maps));
}

/* The plane through the origin across an axis and its image, against the image of a point in it
 * and of one 2^-20 beside it. */
static void moved_slab(int d, int axis) {
    static const double map[3][3] = {{1, 2, 0}, {-1, 1, 1}, {0, 1, 2}};
    slab own = {{0, 0, 0}, 0, 0};
    double p[3];
    own.normal[axis] = 1;
    set_scene(d);
    set_node(&moving, &moving_node, moving_slab, d, &own);
    set_node(&fixed, &fixed_node, fixed_slab, d, NULL);
    for (int side = -1; side <= 1; side++) {
        for (int i = 0; i < d; i++) {
            p[i] = 0;
            for (int j = 0; j < d; j++) {
                entry[i * (d + 1) + j] = map[i][j];
                p[i] += map[i][j] * (j == axis ? side * 0x1p-20 : 0.25);
            }
            entry[i * (d + 1) + d] = 0;
        }
        memcpy(entry + d * (d + 1), entry, (size_t)(d * (d + 1)) * sizeof *entry);
        set_point(&fixed_node, p, d);
        assert_int_equal(are_told(), side != 0);
    }
}

/* An oblique slab that stands against a point that goes along it, then against a slab beside it. */
static void standing_slab(int d) {
    const slab own = {{1, -0.5, d == 3 ? 0.25 : 0}, 0.5, 0.625};
    const double in[3] = {0.5, 0, 0}, below[3] = {0.5 - 0x1p-20, 0, 0},
                 above[3] = {0.625 + 0x1p-20, 0, 0}, along[3] = {0.25, 0.5, 0};
    const double *const point[] = {below, in, above};
    set_triangles(moving_at, fixed_at, d, 0);
    for (int i = 0; i < d; i++)
        entry[d * (d + 1) + i * (d + 1) + d] = along[i];
    set_node(&moving, &moving_node, moving_slab, d, NULL);
    set_node(&fixed, &fixed_node, fixed_slab, d, &own);
    for (int k = 0; k < 3; k++) {
        set_point(&moving_node, point[k], d);
        assert_int_equal(are_told(), k != 1);
        slab other = own;
        other.high = own.low + (k - 1) * 0x1p-20;
        other.low = -1;
        set_node(&moving, &moving_node, moving_slab, d, &other);
        assert_int_equal(are_told(), k == 0);
        set_node(&moving, &moving_node, moving_slab, d, NULL);
    }
}

static void slabs_by_hand(void **state) {
    (void)state;
    for (int d = 2; d <= 3; d++) {
        for (int axis = 0; axis < d; axis++)
            moved_slab(d, axis);
        standing_slab(d);
    }
}

static void slabs_of_nodes(void **state) {
    (void)state;
    random_start(7);
    nodes("cases/ball/solid.off");
    nodes("cases/cartridge/solid.off");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_in_common),
        cmocka_unit_test(gaps),
        cmocka_unit_test(nearness_by_hand),
        cmocka_unit_test(far_off),
        cmocka_unit_test(slabs_by_hand),
        cmocka_unit_test_setup_teardown(slabs_of_nodes, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
