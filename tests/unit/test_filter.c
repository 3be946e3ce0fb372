/* The filter's doubles against exact arithmetic: every bound it states, and everything it says of a
 * span and a simplex. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The trajectories stray from a simplex's plane by about as much as the filter can just tell from
 * zero, and by more. Exact touches are those of src/base/number. A failure prints its seed.
 */
#include "decide/bounds/bounds.h"
#include "decide/filter/search.h"
#include "input/solid/solid.h"
#include "filter_scene.h"
#include "numbers.h"

enum { SCENES = 900, DIRECTED = 500, THROUGH = 1500 };

/* ---- the bounds that a span states ---- */

static void check_within(const scene *s, const char *what, double value, const fmpq_t exact,
                         double bound) {
    fmpq_t off, most;
    fmpq_init(off);
    fmpq_init(most);
    set_double(off, value);
    set_double(most, bound);
    fmpq_sub(off, off, exact);
    fmpq_abs(off, off);
    if (fmpq_cmp(off, most) > 0)
        fail_msg("seed %lu: %s: %.17g is further than %.3g from %.17g", s->seed, what, value, bound,
                 fmpq_get_d(exact));
    fmpq_clear(off);
    fmpq_clear(most);
}

static void check_coefficients(const scene *s, const span *piece, forms f) {
    for (int i = 0; i <= s->d; i++)
        for (int k = 0; k <= s->n; k++)
            check_within(s, "coefficient", curve_coefficients(&s->curve, piece, i)[k], &f[i][k],
                         piece->error[i]);
}

static void check_shifts(const scene *s, const span *piece, forms f) {
    fmpq_t exact, before;
    fmpq_init(exact);
    fmpq_init(before);
    const double *w = curve_coefficients(&s->curve, piece, s->d);
    shift_bound bound = curve_shift(&s->curve, piece);
    for (int c = 0; c < s->d; c++)
        for (int i = 0; i < s->d; i++)
            for (int k = 0; k <= s->n; k++) {
                double x = curve_coefficients(&s->curve, piece, i)[k];
                exact_shift(exact, s, f, c, i, k);
                check_within(s, "shifted coefficient", x - s->near[c * s->d + i] * w[k], exact,
                             bound.error);
                check_within(s, "size", 0, exact, bound.size);
                if (k > 0) {
                    fmpq_sub(before, exact, before);
                    fmpq_mul_si(before, before, s->n);
                    check_within(s, "speed", 0, before, bound.speed);
                }
                fmpq_set(before, exact);
            }
    fmpq_clear(exact);
    fmpq_clear(before);
}

/* The control points, whose hull holds the piece, are in the set that a bounded span states. */
static void check_hull(const scene *s, const span *piece, forms f) {
    fmpq_t place, chord, along;
    fmpq_init(place);
    fmpq_init(chord);
    fmpq_init(along);
    for (int k = 0; k <= s->n && piece->bounded; k++) {
        if (fmpq_sgn(&f[s->d][k]) <= 0)
            fail_msg("seed %lu: a bounded span has a weight that is not positive", s->seed);
        for (int i = 0; i < s->d; i++) {
            fmpq_div(place, &f[i][k], &f[s->d][k]);
            set_double(chord, piece->from[i]);
            set_double(along, piece->along[i]);
            fmpq_mul_si(along, along, k);
            fmpz_mul_si(fmpq_denref(along), fmpq_denref(along), s->n);
            fmpq_canonicalise(along);
            fmpq_add(chord, chord, along);
            fmpq_sub(place, place, chord);
            check_within(s, "control point", 0, place, piece->thick[i]);
        }
    }
    fmpq_clear(place);
    fmpq_clear(chord);
    fmpq_clear(along);
}

/* The value at a place, and boxes that the point there is in, alone or on their boundary. */
static void check_place(scene *s, const span *piece, forms f, const fmpq_t at, double place) {
    forms left, right;
    double value[4], error[4];
    box b = {{0, 0, 0}, {0, 0, 0}};
    int within_reach = 1;
    fmpq_t x;
    fmpq_init(x);
    forms_init(left);
    forms_init(right);
    exact_cut(left, right, f, s, at);
    curve_at(value, error, &s->curve, piece, place);
    for (int i = 0; i <= s->d; i++)
        check_within(s, "value", value[i], &right[i][0], error[i]);
    for (int i = 0; i < s->d; i++) {
        fmpq_div(x, &right[i][0], &right[s->d][0]);
        rational_bounds(&b.low[i], &b.high[i], x);
        double reach = s->bounds.axis_reach[i];
        within_reach = within_reach && -reach <= b.low[i] && b.high[i] <= reach;
    }
    if (within_reach && !span_meets(piece, &b))
        fail_msg("seed %lu: a point of a span is said to be off it", s->seed);
    b.low[0] = -s->bounds.axis_reach[0];
    b.high[1] = s->bounds.axis_reach[1];
    if (within_reach && !span_meets(piece, &b))
        fail_msg("seed %lu: a box that touches a span is said to be off it", s->seed);
    fmpq_clear(x);
    forms_clear(left);
    forms_clear(right);
}

static void check_span(scene *s, const span *piece, forms f) {
    check_coefficients(s, piece, f);
    check_shifts(s, piece, f);
    check_hull(s, piece, f);
    fmpq_t at;
    fmpq_init(at);
    double place = draw_below(4) ? 0.5 + 0.5 * random_fraction() : 0.5;
    set_double(at, place);
    check_place(s, piece, f, at, place);
    fmpq_clear(at);
}

/* ---- what it says of the simplex ---- */

typedef struct tally {
    long chord[CHORD_NEAR + 1];
    long meeting[MEET_CUT + 1];
    long several; /* asked or cut, with more than one root */
} tally;

typedef struct truth {
    size_t roots;
    int on, inside, beyond; /* of them in the simplex, in its interior, in it but off the window */
    int first, last;        /* signs of the plane's pullback at the window's ends */
} truth;

/* One time in the plane: is it in the simplex, and then in the window? */
static void judge(truth *out, const scene *s, const fmpz_poly_struct *side, algebraic *time,
                  algebraic *low, algebraic *high) {
    int closed = 1, open = 1;
    for (int k = 0; k < s->d; k++) {
        int sign = sign_of(&side[k], time);
        closed = closed && sign >= 0;
        open = open && sign > 0;
    }
    out->on += closed;
    out->inside += open;
    out->beyond += closed && (order_of(time, low) < 0 || order_of(time, high) > 0);
}

/* All times on the simplex; where the curve slides in its plane, the roots of the sides and the
 * ends of the span stand for them. */
static truth find_truth(const scene *s, forms f, const meet_window *window) {
    truth out = {.on = 0};
    fmpz_poly_struct plane[1], side[3];
    algebraic low, high;
    algebraic_list times;
    dyadic_interval unit;
    fmpz_poly_init(plane);
    algebraic_init(&low);
    algebraic_init(&high);
    algebraic_list_init(&times);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    exact_pullback(plane, s, f, -1);
    for (int k = 0; k < s->d; k++) {
        fmpz_poly_init(&side[k]);
        exact_pullback(&side[k], s, f, k);
    }
    if (fmpz_poly_is_zero(plane)) {
        algebraic_set_dyadic(algebraic_list_append(&times), unit.low, 0);
        algebraic_set_dyadic(algebraic_list_append(&times), unit.high, 0);
        for (int k = 0; k < s->d; k++)
            if (!fmpz_poly_is_zero(&side[k]))
                append_roots(&times, &side[k], &unit);
    } else {
        append_roots(&times, plane, &unit);
    }
    set_double(low.value, window->low);
    set_double(high.value, window->high);
    out.roots = times.count;
    for (size_t k = 0; k < times.count; k++)
        judge(&out, s, side, &times.item[k], &low, &high);
    out.first = rational_sign(plane, low.value);
    out.last = rational_sign(plane, high.value);
    for (int k = 0; k < s->d; k++)
        fmpz_poly_clear(&side[k]);
    algebraic_clear(&low);
    algebraic_clear(&high);
    fmpz_poly_clear(plane);
    algebraic_list_clear(&times);
    dyadic_interval_clear(&unit);
    return out;
}

static void check_meeting(const scene *s, const span *piece, forms f, tally *count) {
    meet_window window;
    meeting said = meet_simplex(&window, &s->curve, piece, s->near, s->bounds.error);
    truth is = find_truth(s, f, &window);
    chord_meeting chord = chord_meets(&s->curve, piece, s->near, s->bounds.error);
    count->chord[chord]++;
    if (chord == CHORD_MISSES && is.on > 0)
        fail_msg("seed %lu: %d times on the simplex, its chord misses it", s->seed, is.on);
    count->meeting[said]++;
    if (said == MEET_NONE && is.on > 0)
        fail_msg("seed %lu: %d times on the simplex, none was seen", s->seed, is.on);
    if (said == MEET_CROSSING && (is.roots != 1 || is.inside != 1 || is.beyond ||
                                  is.first != (window.enters ? 1 : -1) || is.last != -is.first))
        fail_msg("seed %lu: a certain crossing, but %zu roots, %d in the simplex, %d off the "
                 "window, signs %d and %d at its ends, enters %d",
                 s->seed, is.roots, is.inside, is.beyond, is.first, is.last, window.enters);
    if ((said == MEET_ASK || said == MEET_CUT) && is.beyond)
        fail_msg("seed %lu: %d times on the simplex off the window", s->seed, is.beyond);
    count->several += said != MEET_CROSSING && is.roots > 1;
}

/* ---- scenes ---- */

/* About the error that meet_simplex allows the plane's pullback, so that it can be aimed at. */
static double aim(const scene *s, const span *piece, const double *normal) {
    double norm = 0;
    shift_bound bound = curve_shift(&s->curve, piece);
    for (int i = 0; i < s->d; i++)
        norm += fabs(normal[i]);
    return norm * (bound.error + 4 * UNIT_ROUNDING * bound.size);
}

/* Move control point k along the normal so that the pullback's coefficient becomes `value`. */
static void bend(scene *s, int k, double value) {
    fmpq normal[3];
    fmpq_t squares, move;
    fmpq_init(squares);
    fmpq_init(move);
    for (int i = 0; i < 3; i++)
        fmpq_init(&normal[i]);
    direction(normal, s, -1);
    for (int i = 0; i < s->d; i++)
        fmpq_addmul(squares, &normal[i], &normal[i]);
    set_double(move, value);
    fmpq_mul(squares, squares, &s->exact[s->d][k]);
    fmpq_div(move, move, squares);
    for (int i = 0; i < s->d; i++)
        fmpq_addmul(&s->control[i][k], move, &normal[i]);
    for (int i = 0; i < 3; i++)
        fmpq_clear(&normal[i]);
    fmpq_clear(squares);
    fmpq_clear(move);
}

/* Set the curve and how large a pullback must be to have a certain sign; 0 if the simplex is
 * degenerate or there is no curve. */
static int prepare(scene *s, double *certain) {
    fmpq normal[3];
    double near[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        fmpq_init(&normal[i]);
    direction(normal, s, -1);
    for (int i = 0; i < s->d; i++)
        near[i] = fmpq_get_d(&normal[i]);
    for (int i = 0; i < 3; i++)
        fmpq_clear(&normal[i]);
    if (!scene_convert(s) || (near[0] == 0 && near[1] == 0 && near[2] == 0))
        return 0;
    *certain = aim(s, &s->curve.spans[0], near);
    return 1;
}

/* The whole curve and a way down its halves. */
static void check_curve(scene *s, tally *count, int levels) {
    forms whole, left, right;
    uint32_t at = 0;
    fmpq_t half;
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    forms_init(whole);
    forms_init(left);
    forms_init(right);
    forms_set(whole, s->exact);
    for (int level = 0;; level++) {
        check_span(s, &s->curve.spans[at], whole);
        check_meeting(s, &s->curve.spans[at], whole, count);
        if (level == levels)
            break;
        assert_true(curve_cut(&s->curve, at));
        exact_cut(left, right, whole, s, half);
        int later = (int)draw_below(2);
        at = s->curve.spans[at].child + (uint32_t)later;
        forms_set(whole, later ? right : left);
    }
    fmpq_clear(half);
    forms_clear(whole);
    forms_clear(left);
    forms_clear(right);
}

static void test_random(void **state) {
    (void)state;
    tally count = {.several = 0};
    for (ulong seed = 1; seed <= SCENES; seed++) {
        scene s;
        double certain;
        scene_init(&s, seed, 0);
        if (prepare(&s, &certain)) {
            int exponent = draw_below(2) ? 0 : (int)draw_below(50), parts = (int)draw_below(4);
            for (int k = 0; k <= s.n; k++) {
                double value = parts ? 2 * random_fraction() : (double)draw_below(3) - 1;
                bend(&s, k, ldexp(certain * value, exponent));
            }
            if (scene_convert(&s))
                check_curve(&s, &count, (int)draw_below(20) ? (int)draw_below(4) : 20);
        }
        scene_clear(&s);
    }
    for (int k = 0; k <= MEET_CUT; k++)
        assert_true(count.meeting[k] > SCENES / 50);
    for (int k = 0; k <= CHORD_NEAR; k++)
        assert_true(count.chord[k] > SCENES / 50);
}

/* Three roots near the middle, in a simplex's interior: (y - 1)((y - 1)^2 - h) with y = t / (1 - t)
 * has the Bernstein coefficients -1 + h, 1 - h / 3, -1, 1. They are so small that signs are just
 * certain, or just not. */
static void test_triple(void **state) {
    (void)state;
    tally count = {.several = 0};
    for (ulong seed = 1; seed <= DIRECTED; seed++) {
        scene s;
        double certain;
        scene_init(&s, seed, 1);
        if (prepare(&s, &certain)) {
            double h = 0.015 + 0.015 * random_fraction();
            double size = certain * (1.006 + 0.008 * random_fraction()) * (draw_below(2) ? 1 : -1);
            double value[] = {h - 1, 1 - h / 3, -1, 1};
            for (int k = 0; k <= 3; k++)
                bend(&s, k, size * value[k]);
            if (scene_convert(&s))
                check_curve(&s, &count, 0);
        }
        scene_clear(&s);
    }
    assert_true(count.several > DIRECTED / 4);
}

/* Control points evenly along the segment from the first to the last: all that bends is the way
 * through the plane, and the place where it is met moves far. */
static void straighten(scene *s) {
    fmpq_t share, step;
    fmpq_init(share);
    fmpq_init(step);
    for (int i = 0; i <= s->d; i++)
        for (int k = 1; k < s->n; k++) {
            fmpq_set_si(share, k, (ulong)s->n);
            fmpq_sub(step, &s->control[i][s->n], &s->control[i][0]);
            fmpq_mul(step, step, share);
            fmpq_add(&s->control[i][k], &s->control[i][0], step);
        }
    fmpq_clear(share);
    fmpq_clear(step);
}

/* Curves that bend as they go through the plane, in the simplex, past a side of it, or between. */
static void test_through(void **state) {
    (void)state;
    tally count = {.several = 0};
    for (ulong seed = 1; seed <= THROUGH; seed++) {
        scene s;
        double certain;
        scene_init(&s, seed, 0);
        if (seed % 2)
            straighten(&s);
        if (prepare(&s, &certain)) {
            int exponent = 40 + (int)draw_below(14), side = draw_below(2) ? 1 : -1;
            for (int k = 0; k <= s.n; k++)
                bend(&s, k, side * ldexp(certain * (2 * k - s.n + random_fraction()), exponent));
            if (scene_convert(&s))
                check_curve(&s, &count, (int)draw_below(6));
        }
        scene_clear(&s);
    }
    for (int k = 0; k <= CHORD_NEAR; k++)
        assert_true(count.chord[k] > THROUGH / 50);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),
        cmocka_unit_test(test_triple),
        cmocka_unit_test(test_through),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
