/* Bounds of the distance between a point and a simplex that moves (proofs/distance.md C68 to C70),
 * window by window, against exact distances. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The exact distance is that of the point to a place of the simplex, carried by the motion at a
 * rational time of the window: no lower bound of the simplex may exceed it, whatever the place. The
 * places are random ones and that which is nearest then, computed here. Upper bounds are held
 * against the place that they are about. Where a window is short the bounds must be narrow too.
 */
#include <flint/fmpq_vec.h>
#include <math.h>
#include "../lib/harness.h"
#include "../lib/random.h"
#include "base/number/rounding.h"
#include "decide/scene/scene.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/distance/distance.h"
#include "questions/distance/gap.h"
#include "questions/distance/time_search.h"
#include "graze.h"

enum { ROUNDS = 400, PLACES = 12 };

/* Rigid ones, with a weight and without; a shear, a scale; weights that are small at some times. */
static const char *const plane_motions[] = {
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"compose\": [{\"rotate\": "
    "{\"tan_half\": \"3*t-1\"}}, {\"translate\": [\"5*t\", \"t^2\"]}]}}]}",
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"translate\": [\"t^3-t\", "
    "\"4*t\"]}}]}",
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"matrix\": "
    "[[\"1+t\", \"t^2\", \"3*t\"], [\"t/3\", \"2-t\", \"-t\"]]}}]}",
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"matrix\": "
    "[[\"1/(1+99*t)\", 0, \"t\"], [0, \"1/(1+99*t)\", 0]]}}]}",
    "{\"dimension\": 2, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"rotate\": {\"tan_half\": "
    "\"10^6*t-1000\"}}}]}",
};
static const char *const space_motions[] = {
    "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"compose\": [{\"rotate\": "
    "{\"tan_half\": \"t\", \"axis\": [2, 1, 2]}}, {\"translate\": [\"3*t\", 0, \"t^2\"]}]}}]}",
    "{\"dimension\": 3, \"pieces\": [{\"t\": [0, 1], \"transform\": {\"matrix\": "
    "[[\"1+t\", \"t\", 0, \"2*t\"], [0, \"1-t/2\", \"t^2\", 0], [\"t/5\", 0, 1, \"t/(1+t)\"]]}}]}",
};

/* A tetrahedron or a triangle, far from the origin where `shift` is large; all coordinates are
 * doubles. */
static graze_solid *make_solid(graze_context *context, int d, double shift) {
    static const size_t sizes2[] = {3}, index2[] = {0, 1, 2}, sizes3[] = {3, 3, 3, 3},
                        index3[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    static const double corner2[] = {0, 0, 3, 0.5, 1, 2},
                        corner3[] = {0, 0, 0, 3, 0.5, 0.25, 1, 2.25, 0.5, 0.5, 0.5, 2};
    double at[12];
    graze_solid *solid;
    for (int k = 0; k < d * (d + 1); k++)
        at[k] = (d == 2 ? corner2[k] : corner3[k]) + shift;
    assert_int_equal(graze_solid_from_doubles(&solid, context, d, at, (size_t)d + 1,
                                              d == 2 ? sizes2 : sizes3, d == 2 ? 1 : 4,
                                              d == 2 ? index2 : index3, 0),
                     GRAZE_OK);
    return solid;
}

/* A place of a simplex, exactly. */
static void place_at(fmpq *place, const double *share, const double *corner, int d) {
    fmpq_t rest, part, x;
    fmpq_init(rest);
    fmpq_init(part);
    fmpq_init(x);
    fmpq_one(rest);
    for (int i = 0; i < 3; i++)
        fmpq_zero(place + i);
    for (int c = d - 1; c >= 0; c--) {
        if (c)
            assert_int_equal(rational_from_double(part, NULL, share[c]), GRAZE_OK);
        else
            fmpq_set(part, rest);
        fmpq_sub(rest, rest, part);
        for (int i = 0; i < d; i++) {
            assert_int_equal(rational_from_double(x, NULL, corner[c * d + i]), GRAZE_OK);
            fmpq_addmul(place + i, part, x);
        }
    }
    fmpq_clear(rest);
    fmpq_clear(part);
    fmpq_clear(x);
}

/* The squared distance of P to M(u) place. */
static void exact_square(fmpq_t out, const fmpq *map, const fmpq *place, const double *point,
                         int d) {
    fmpq_t sum, x;
    fmpq_init(sum);
    fmpq_init(x);
    fmpq_zero(out);
    for (int i = 0; i < d; i++) {
        assert_int_equal(rational_from_double(sum, NULL, point[i]), GRAZE_OK);
        fmpq_sub(sum, sum, map + i * (d + 1) + d);
        for (int j = 0; j < d; j++) {
            fmpq_mul(x, map + i * (d + 1) + j, place + j);
            fmpq_sub(sum, sum, x);
        }
        fmpq_addmul(out, sum, sum);
    }
    fmpq_clear(sum);
    fmpq_clear(x);
}

/* bound^2 against the square: its sign less the square. */
static int compare_bound(double bound, const fmpq_t square) {
    fmpq_t b;
    fmpq_init(b);
    assert_int_equal(rational_from_double(b, NULL, bound), GRAZE_OK);
    fmpq_mul(b, b, b);
    int order = fmpq_cmp(b, square);
    fmpq_clear(b);
    return order;
}

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Shares of the place of the segment from corner a to b that is nearest to the origin. */
static double nearest_on_edge(double *share, double y[3][3], int a, int b) {
    double e[3], place[3];
    for (int i = 0; i < 3; i++)
        e[i] = y[b][i] - y[a][i];
    double s = fmin(fmax(-dot(y[a], e) / dot(e, e), 0), 1);
    share[0] = share[1] = share[2] = 0;
    share[b] = s;
    share[a] = 1 - s;
    for (int i = 0; i < 3; i++)
        place[i] = y[a][i] + s * e[i];
    return dot(place, place);
}

/* Shares of the place of the plane through the corners that is nearest to the origin; INFINITY if
 * it is outside the triangle. */
static double nearest_within(double *share, double y[3][3]) {
    double a[3], b[3], place[3];
    for (int i = 0; i < 3; i++) {
        a[i] = y[1][i] - y[0][i];
        b[i] = y[2][i] - y[0][i];
    }
    double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), det = aa * bb - ab * ab;
    share[1] = (-dot(y[0], a) * bb + dot(y[0], b) * ab) / det;
    share[2] = (-dot(y[0], b) * aa + dot(y[0], a) * ab) / det;
    share[0] = 1 - share[1] - share[2];
    for (int i = 0; i < 3; i++)
        place[i] = y[0][i] + share[1] * a[i] + share[2] * b[i];
    return share[0] >= 0 && share[1] >= 0 && share[2] >= 0 ? dot(place, place) : INFINITY;
}

/* Shares of the place of the carried simplex nearest to P, as doubles have it: any place will do
 * for a bound, this one asks most of it. */
static void nearest_shares(double *best, const fmpq *map, const double *corner, const double *point,
                           int d) {
    double y[3][3] = {{0}}, share[3], least = INFINITY;
    for (int c = 0; c < d; c++)
        for (int i = 0; i < d; i++) {
            y[c][i] = fmpq_get_d(map + i * (d + 1) + d) - point[i];
            for (int j = 0; j < d; j++)
                y[c][i] += fmpq_get_d(map + i * (d + 1) + j) * corner[c * d + j];
        }
    for (int a = 0; a < 4; a++) {
        if (d == 2 && a)
            break;
        double found = a < 3 ? nearest_on_edge(share, y, a, (a + 1) % d) : nearest_within(share, y);
        if (found < least) {
            least = found;
            memcpy(best, share, 3 * sizeof *best);
        }
    }
}

static void random_shares(double *share, int d) {
    double a = fabs(random_fraction()), b = fabs(random_fraction());
    share[1] = d == 2 ? a : fmin(a, b);
    share[2] = d == 2 ? 0 : fmax(a, b) - fmin(a, b);
    share[0] = 1 - share[1] - share[2];
}

/* One window and one simplex: what the bounds say. */
typedef struct trial {
    const arc_maps *base;
    point_arc p;
    window w;
    foot first, middle, last;
    const double *corner;
    double along, about, most;
} trial;

/* 0 if the window is beyond doubles. */
static int trial_make(trial *t, double from, double to, size_t simplex) {
    stance begin, half, end;
    int d = t->p.dimension;
    t->corner = t->base->scene->solid->corners.at + simplex * (size_t)(d * d);
    if (!window_make(&t->w, &t->p, from, to) || !stance_make(&begin, &t->p, from) ||
        !stance_make(&half, &t->p, from + (to - from) / 2) || !stance_make(&end, &t->p, to))
        return 0;
    foot_find(&t->first, &begin, t->corner);
    foot_find(&t->middle, &half, t->corner);
    foot_find(&t->last, &end, t->corner);
    t->along = gap_along(&t->w, t->middle.m, gap_corners(t->middle.m, t->corner, d, d));
    t->about = gap_about(&t->w, t->first.q, t->last.q, t->corner, d);
    t->most = gap_most(&t->w, t->first.q, t->last.q);
    return 1;
}

/* At the share s of the window: the nearest distance is at least both bounds, and the place that
 * the upper bound is about is no farther than that. Returns the nearest distance. */
static double check_at(const trial *t, const fmpq *map, double s) {
    int d = t->p.dimension;
    fmpq *place = _fmpq_vec_init(3);
    fmpq_t square;
    double share[3], nearest = 0;
    fmpq_init(square);
    for (int k = 0; k < 3; k++) {
        if (k == 0)
            nearest_shares(share, map, t->corner, t->p.point, d);
        else
            random_shares(share, d);
        place_at(place, share, t->corner, d);
        exact_square(square, map, place, t->p.point, d);
        if (compare_bound(t->along, square) > 0 || compare_bound(t->about, square) > 0)
            fail_msg("along %a, about %a, but %a at %a of [%a, %a]", t->along, t->about,
                     sqrt(fmpq_get_d(square)), s, t->w.from, t->w.to);
        if (k == 0)
            nearest = sqrt(fmpq_get_d(square));
    }
    fmpq_t a, b;
    fmpq_init(a);
    fmpq_init(b);
    for (int i = 0; i < d; i++) {
        assert_int_equal(rational_from_double(place + i, NULL, t->first.q[i]), GRAZE_OK);
        assert_int_equal(rational_from_double(a, NULL, t->last.q[i]), GRAZE_OK);
        assert_int_equal(rational_from_double(b, NULL, s), GRAZE_OK);
        fmpq_sub(a, a, place + i);
        fmpq_addmul(place + i, a, b);
    }
    exact_square(square, map, place, t->p.point, d);
    if (compare_bound(t->most, square) < 0)
        fail_msg("at most %a, but %a at %a of [%a, %a]", t->most, sqrt(fmpq_get_d(square)), s,
                 t->w.from, t->w.to);
    fmpq_clear(a);
    fmpq_clear(b);
    fmpq_clear(square);
    _fmpq_vec_clear(place, 3);
    return nearest;
}

/* Bounds and distances at places of a window; 1 if it is one where they must be narrow. */
static int check_window(trial *t, const point_map *placing, double shift) {
    int d = t->p.dimension;
    const arc *of = &t->base->arc[t->p.arc];
    fmpq *map = _fmpq_vec_init(d * (d + 1));
    fmpq_t u, length, part;
    double nearest = 0;
    fmpq_init(u);
    fmpq_init(length);
    fmpq_init(part);
    for (int k = 0; k <= PLACES; k++) {
        double s = k == 0 ? 0 : k == 1 ? 1 : k == 2 ? 0.5 : fabs(random_fraction());
        assert_int_equal(rational_from_double(u, NULL, t->w.from), GRAZE_OK);
        assert_int_equal(rational_from_double(length, NULL, t->w.to), GRAZE_OK);
        assert_int_equal(rational_from_double(part, NULL, s), GRAZE_OK);
        fmpq_sub(length, length, u);
        fmpq_addmul(u, length, part);
        assert_int_equal(rational_from_double(length, NULL, of->length), GRAZE_OK);
        assert_int_equal(rational_from_double(part, NULL, of->from), GRAZE_OK);
        fmpq_mul(u, u, length);
        fmpq_add(u, u, part);
        point_map_at(map, placing, u);
        nearest = check_at(t, map, s);
    }
    int narrow = t->w.to - t->w.from < 0x1p-22 && nearest > 0x1p-8 && shift < 100;
    if (narrow) {
        assert_true(fmax(t->along, t->about) > 0.999 * nearest);
        assert_true(t->most < 1.001 * nearest);
        /* The covector of the middle is good for all of a window in which nothing moves far. */
        assert_true(t->w.to - t->w.from >= 0x1p-30 || t->along > 0.999 * nearest);
    }
    fmpq_clear(u);
    fmpq_clear(length);
    fmpq_clear(part);
    _fmpq_vec_clear(map, d * (d + 1));
    return narrow;
}

static int check_windows(graze_context *context, const graze_scene *scene, double shift) {
    trial t;
    int d = graze_scene_dimension(scene), narrow = 0;
    assert_int_equal(arc_maps_of(&t.base, context, scene), GRAZE_OK);
    const point_map *placing = motion_placing(&scene->motion->piece[0], scene->options.operation);
    for (int round = 0; round < ROUNDS; round++) {
        double point[3], length = ldexp(1, -(int)draw_below(36));
        for (int i = 0; i < d; i++)
            point[i] = shift + 6 * random_fraction() + (round % 8 ? 0 : 1000);
        size_t arc = (size_t)draw_below((slong)t.base->arc_count);
        assert_int_equal(point_arc_make(&t.p, context, t.base, arc, point, point), GRAZE_OK);
        double from = (1 - length) * fabs(random_fraction()), to = fmin(from + length, 1);
        if (trial_make(&t, from, to, (size_t)draw_below(d == 2 ? 3 : 4)))
            narrow += check_window(&t, placing, shift);
    }
    return narrow;
}

static void check_motions(int d, const char *const *motions, size_t count) {
    static const double shifts[] = {0, 0, 1 << 20};
    graze_context *context;
    assert_int_equal(graze_context_create(&context), GRAZE_OK);
    for (size_t k = 0; k < 3 * count; k++) {
        double shift = shifts[k % 3];
        graze_solid *solid = make_solid(context, d, shift);
        graze_motion *motion;
        graze_scene *scene;
        graze_options o = {.size = sizeof o, .operation = k % 3 == 1 ? GRAZE_UNSWEEP : GRAZE_SWEEP};
        random_start(k + 1);
        const char *text = motions[k / 3];
        assert_int_equal(graze_motion_from_json(&motion, context, text, strlen(text)), GRAZE_OK);
        assert_int_equal(graze_scene_create(&scene, context, solid, motion, &o), GRAZE_OK);
        int narrow = check_windows(context, scene, shift);
        if (shift < 100 && narrow < ROUNDS / 8)
            fail_msg("motion %zu: %d short windows", k, narrow);
        graze_scene_destroy(scene);
        graze_motion_destroy(motion);
        graze_solid_destroy(solid);
    }
    graze_context_destroy(context);
}

static void in_the_plane(void **state) {
    (void)state;
    check_motions(2, plane_motions, sizeof plane_motions / sizeof *plane_motions);
}

static void in_space(void **state) {
    (void)state;
    check_motions(3, space_motions, sizeof space_motions / sizeof *space_motions);
}

/* The decimals of a table are wider than the doubles by less than 2^-50 of them, and must be within
 * the tolerance too. */
static void room_for_decimals(void **state) {
    (void)state;
    const search s = {.tolerance = 0x1p-40};
    assert_false(search_is_done(&s, 1, 1 + 0x1p-40));
    assert_false(search_is_done(&s, -1 - 0x1p-40, -1));
    assert_true(search_is_done(&s, 1, 1 + 0x1p-40 - 0x1p-49));
    assert_true(search_is_done(&s, -1 - 0x1p-40 + 0x1p-49, -1));
}

/* An instant of a piece that is not rigid, made by hand: the point is at X, W is 1, the maps are
 * the unit matrix up to `linear_stray` in each entry. Along m the distance is m X / |B m|, where an
 * entry b more in each place makes |B m| of m = (1, 1, 1) as large as (1 + 3 b) sqrt(3). */
static void errors_of_the_map(void **state) {
    (void)state;
    const double first[] = {1, 0, 0}, diagonal[] = {1, 1, 1};
    point_arc still = {.dimension = 3};
    window w = {.of = &still,
                .x = {{8}, {8}, {8}, {1}},
                .linear = {{1}, {0}, {0}, {0}, {1}, {0}, {0}, {0}, {1}}};
    double bound = gap_along(&w, first, 0);
    assert_true(bound <= 8 && bound > 8 - 0x1p-40);
    w.linear_stray = 0.25;
    bound = gap_along(&w, diagonal, 0);
    assert_true(bound <= 24 / (1.75 * sqrt(3)) && bound > 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(in_the_plane), cmocka_unit_test(in_space),
                                       cmocka_unit_test(room_for_decimals),
                                       cmocka_unit_test(errors_of_the_map)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
