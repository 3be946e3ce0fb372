/* Random trajectories near one random simplex, for the filter's test: as the filter holds them, and
 * exactly. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A trajectory is made from rational control points in the simplex's plane, which the test then
 * moves. Its exact coefficients are those it was made from.
 */
#ifndef GRAZE_TESTS_UNIT_FILTER_SCENE_H
#define GRAZE_TESTS_UNIT_FILTER_SCENE_H

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <math.h>
#include "../lib/harness.h"
#include "../lib/random.h"
#include "base/number/bernstein.h"
#include "base/number/rounding.h"
#include "decide/bounds/bounds.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

enum { MOST_DEGREE = 8 };

/* Coefficient k of polynomial i at [i][k]. */
typedef fmpq forms[4][MOST_DEGREE + 1];

typedef struct scene {
    ulong seed;
    int d, n;
    int steep; /* large numbers that all but cancel, near the middle of the simplex */
    fmpq corner[9], point[3];
    double near[9]; /* the corners */
    corners bounds;
    forms control;                   /* X_i / W at k, and W */
    fmpq linear[9][MOST_DEGREE + 1]; /* the entries but for the last column */
    forms exact;                     /* of the curve, scaled as the carrier scales */
    course course;                   /* of one piece; the curve keeps it */
    curve curve;
} scene;

static void set_double(fmpq_t out, double value) {
    assert_int_equal(rational_from_double(out, NULL, value), GRAZE_OK);
}

static void random_number(fmpq_t out, int kind) {
    if (kind == 0)
        fmpq_set_si(out, draw_below(17) - 8, 1);
    else if (kind == 1)
        fmpq_set_si(out, draw_below(2001) - 1000, (ulong)draw_below(998) + 1);
    else
        set_double(out, ldexp(random_fraction(), kind == 2 ? 0 : (int)draw_below(40) - 20));
}

static void forms_init(forms f) {
    for (int i = 0; i < 4; i++)
        for (int k = 0; k <= MOST_DEGREE; k++)
            fmpq_init(&f[i][k]);
}

static void forms_clear(forms f) {
    for (int i = 0; i < 4; i++)
        for (int k = 0; k <= MOST_DEGREE; k++)
            fmpq_clear(&f[i][k]);
}

static void forms_set(forms out, forms f) {
    for (int i = 0; i < 4; i++)
        for (int k = 0; k <= MOST_DEGREE; k++)
            fmpq_set(&out[i][k], &f[i][k]);
}

static void random_corners(scene *s) {
    int kind = (int)draw_below(4), d = s->d, shift = draw_below(4) ? 0 : (int)draw_below(300) - 150;
    s->bounds = (corners){.at = s->near};
    for (int k = 0; k < d * d; k++) {
        random_number(&s->corner[k], kind);
        if (shift > 0)
            fmpq_mul_2exp(&s->corner[k], &s->corner[k], (flint_bitcnt_t)shift);
        else
            fmpq_div_2exp(&s->corner[k], &s->corner[k], (flint_bitcnt_t)-shift);
        double high, *reach = &s->bounds.axis_reach[k % d];
        rational_bounds(&s->near[k], &high, &s->corner[k]);
        s->bounds.error = fmax(s->bounds.error, high - s->near[k]);
        *reach = fmax(*reach, fmax(fabs(s->near[k]), fabs(high)));
        s->bounds.reach = fmax(s->bounds.reach, *reach);
    }
}

/* Control points in the simplex's plane, about a place in or near the simplex. */
static void random_controls(scene *s) {
    int d = s->d, weights = s->steep ? 0 : (int)draw_below(3);
    double spread = ldexp(1, -12 * (s->steep + (int)draw_below(4))), centre[3];
    fmpq_t share, rest, term;
    fmpq_init(share);
    fmpq_init(rest);
    fmpq_init(term);
    for (int v = 1; v < d; v++)
        centre[v] = s->steep || draw_below(4) ? 0.3 : 0;
    for (int k = 0; k <= s->n; k++) {
        for (int i = 0; i < d; i++)
            fmpq_zero(&s->control[i][k]);
        fmpq_one(rest);
        for (int v = d - 1; v >= 0; v--) {
            set_double(share, v ? centre[v] + spread * random_fraction() : 0);
            fmpq_sub(rest, rest, share);
            for (int i = 0; i < d; i++) {
                fmpq_mul(term, v ? share : rest, &s->corner[v * d + i]);
                fmpq_add(&s->control[i][k], &s->control[i][k], term);
            }
        }
        set_double(&s->control[d][k], weights == 0   ? 1
                                      : weights == 1 ? 1 + 0.5 * random_fraction()
                                                     : (double)draw_below(9) + 1);
    }
    fmpq_clear(share);
    fmpq_clear(rest);
    fmpq_clear(term);
}

/* Any scene; or, if `steep`, a cubic with large errors. */
static void scene_init(scene *s, ulong seed, int steep) {
    *s = (scene){.seed = seed, .steep = steep};
    random_start(seed);
    s->d = 2 + (int)draw_below(2);
    s->n = steep ? 3 : 1 + (int)draw_below(MOST_DEGREE);
    for (int k = 0; k < 9; k++)
        fmpq_init(&s->corner[k]);
    forms_init(s->control);
    forms_init(s->exact);
    curve_init(&s->curve);
    random_corners(s);
    random_controls(s);
    int kind = s->steep ? 1 : (int)draw_below(4);
    for (int j = 0; j < 3; j++) {
        fmpq_init(&s->point[j]);
        random_number(&s->point[j], kind);
    }
    kind = s->steep ? 2 : (int)draw_below(4);
    for (int e = 0; e < 9; e++)
        for (int k = 0; k <= MOST_DEGREE; k++) {
            fmpq_init(&s->linear[e][k]);
            random_number(&s->linear[e][k], kind);
            fmpq_mul_2exp(&s->linear[e][k], &s->linear[e][k], s->steep ? 10 : 0);
        }
}

static void scene_clear(scene *s) {
    for (int k = 0; k < 9; k++)
        fmpq_clear(&s->corner[k]);
    for (int j = 0; j < 3; j++)
        fmpq_clear(&s->point[j]);
    for (int e = 0; e < 9; e++)
        for (int k = 0; k <= MOST_DEGREE; k++)
            fmpq_clear(&s->linear[e][k]);
    forms_clear(s->control);
    forms_clear(s->exact);
    curve_clear(&s->curve);
}

/* Sum of b_k C(n, k) t^k (1 - t)^(n - k), times `scale`, which makes it integral. */
static void bernstein_sum(fmpz_poly_t out, const fmpq *b, int n, const fmpz_t scale) {
    fmpz_poly_t t, rest, power, term;
    fmpz_t c, binomial;
    fmpz_poly_init(t);
    fmpz_poly_init(rest);
    fmpz_poly_init(power);
    fmpz_poly_init(term);
    fmpz_init(c);
    fmpz_init(binomial);
    fmpz_poly_set_coeff_si(rest, 0, 1);
    fmpz_poly_set_coeff_si(rest, 1, -1);
    fmpz_poly_zero(out);
    for (int k = 0; k <= n; k++) {
        fmpz_poly_pow(power, rest, (ulong)(n - k));
        fmpz_poly_shift_left(term, power, k);
        fmpz_divexact(c, scale, fmpq_denref(b + k));
        fmpz_mul(c, c, fmpq_numref(b + k));
        fmpz_bin_uiui(binomial, (ulong)n, (ulong)k);
        fmpz_mul(c, c, binomial);
        fmpz_poly_scalar_addmul_fmpz(out, term, c);
    }
    fmpz_clear(c);
    fmpz_clear(binomial);
    fmpz_poly_clear(t);
    fmpz_poly_clear(rest);
    fmpz_poly_clear(power);
    fmpz_poly_clear(term);
}

static void common_denominator(fmpz_t out, const fmpq *b, int n) {
    for (int k = 0; k <= n; k++)
        fmpz_lcm(out, out, fmpq_denref(b + k));
}

/* The map that gives the point the curve: its last column is what the others leave over. */
static void make_map(point_map *map, fmpz_t scale, scene *s) {
    int d = s->d, n = s->n;
    fmpq column[3][MOST_DEGREE + 1];
    fmpq_t term;
    fmpq_init(term);
    fmpz_one(scale);
    common_denominator(scale, s->control[d], n);
    for (int i = 0; i < d; i++) {
        for (int k = 0; k <= n; k++) {
            fmpq_init(&column[i][k]);
            fmpq_mul(&s->exact[i][k], &s->control[i][k], &s->control[d][k]);
            fmpq_set(&column[i][k], &s->exact[i][k]);
            for (int j = 0; j < d; j++) {
                fmpq_mul(term, &s->linear[i * d + j][k], &s->point[j]);
                fmpq_sub(&column[i][k], &column[i][k], term);
            }
        }
        common_denominator(scale, column[i], n);
        for (int j = 0; j < d; j++)
            common_denominator(scale, s->linear[i * d + j], n);
    }
    *map = (point_map){.dimension = d};
    fmpz_poly_init(map->weight);
    bernstein_sum(map->weight, s->control[d], n, scale);
    for (int i = 0; i < d; i++)
        for (int j = 0; j <= d; j++) {
            fmpz_poly_init(&map->entry[i * (d + 1) + j]);
            bernstein_sum(&map->entry[i * (d + 1) + j], j < d ? s->linear[i * d + j] : column[i], n,
                          scale);
        }
    for (int i = 0; i < d; i++)
        for (int k = 0; k <= n; k++)
            fmpq_clear(&column[i][k]);
    fmpq_clear(term);
}

static void clear_map(point_map *map) {
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++)
        fmpz_poly_clear(&map->entry[k]);
    fmpz_poly_clear(map->weight);
}

/* Conversion multiplies by what it makes of the constant 1, then by a power of two that brings the
 * greatest weight into [1/2, 1). */
static void scale_exact(scene *s, const fmpz_t scale) {
    fmpz_t one;
    fmpz_poly_t constant;
    fmpz *c = _fmpz_vec_init(s->n + 1);
    dyadic_interval unit;
    fmpq_t factor, largest;
    fmpz_init(one);
    fmpz_poly_init(constant);
    fmpq_init(factor);
    fmpq_init(largest);
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    fmpz_poly_one(constant);
    bernstein_from_poly(c, constant, s->n, &unit);
    fmpz_mul(fmpq_numref(factor), c, scale);
    fmpz_one(fmpq_denref(factor));
    for (int k = 0; k <= s->n; k++) {
        fmpq_set(&s->exact[s->d][k], &s->control[s->d][k]);
        if (fmpq_cmp(largest, &s->control[s->d][k]) < 0)
            fmpq_set(largest, &s->control[s->d][k]);
    }
    fmpq_mul(largest, largest, factor);
    fmpz_fdiv_q(one, fmpq_numref(largest), fmpq_denref(largest));
    fmpq_div_2exp(factor, factor, fmpz_bits(one));
    for (int i = 0; i <= s->d; i++)
        for (int k = 0; k <= s->n; k++)
            fmpq_mul(&s->exact[i][k], &s->exact[i][k], factor);
    fmpz_clear(one);
    fmpz_poly_clear(constant);
    fmpq_clear(factor);
    fmpq_clear(largest);
    dyadic_interval_clear(&unit);
    _fmpz_vec_clear(c, s->n + 1);
}

/* Set the curve and its exact coefficients; 0 if leading coefficients cancel. */
static int scene_convert(scene *s) {
    point_map map;
    carrier converted;
    filter_point at;
    double high;
    fmpz_t scale;
    fmpz_init(scale);
    make_map(&map, scale, s);
    assert_true(carrier_make(&converted, &map));
    for (int j = 0; j < s->d; j++)
        rational_bounds(&at.at[j], &high, &s->point[j]);
    assert_true(converted.usable);
    piece_group whole = {.child = 0};
    s->course = (course){s->d, converted.degree, 1, 1, &converted, &whole};
    int done = converted.degree == s->n && curve_set(&s->curve, &s->course, &at, &s->bounds) &&
               !s->curve.spans[0].lost;
    scale_exact(s, scale);
    carrier_clear(&converted);
    clear_map(&map);
    fmpz_clear(scale);
    return done;
}

static void cross(fmpq *out, const fmpq *a, const fmpq *b) {
    fmpq_t term;
    fmpq_init(term);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        fmpq_mul(out + i, a + j, b + k);
        fmpq_mul(term, a + k, b + j);
        fmpq_sub(out + i, out + i, term);
    }
    fmpq_clear(term);
}

static void edge(fmpq *out, const scene *s, int from, int to) {
    for (int i = 0; i < s->d; i++)
        fmpq_sub(out + i, &s->corner[to * s->d + i], &s->corner[from * s->d + i]);
}

/* The outward normal of the simplex for form -1, the inward one of a side for the others. */
static void direction(fmpq *out, const scene *s, int form) {
    fmpq *a = _fmpq_vec_init(3), *b = _fmpq_vec_init(3), *n = _fmpq_vec_init(3);
    edge(a, s, 0, 1);
    if (s->d == 2) {
        fmpq_set(out, form < 0 ? a + 1 : a);
        fmpq_set(out + 1, form < 0 ? a : a + 1);
        if (form == 1)
            fmpq_neg(out, out);
        if (form != 0)
            fmpq_neg(out + 1, out + 1);
    } else {
        edge(b, s, 0, 2);
        cross(form < 0 ? out : n, a, b);
        if (form >= 0) {
            edge(a, s, form, (form + 1) % 3);
            cross(out, n, a);
        }
    }
    _fmpq_vec_clear(a, 3);
    _fmpq_vec_clear(b, 3);
    _fmpq_vec_clear(n, 3);
}

/* X_i - v_i W at k, for a corner v. */
static void exact_shift(fmpq_t out, const scene *s, forms f, int corner, int i, int k) {
    fmpq_mul(out, &s->corner[corner * s->d + i], &f[s->d][k]);
    fmpq_sub(out, &f[i][k], out);
}

/* The pullback of a form, times a positive number. */
static void exact_pullback(fmpz_poly_t out, const scene *s, forms f, int form) {
    fmpq normal[3], sum[MOST_DEGREE + 1];
    fmpq_t term;
    fmpz_t scale;
    fmpq_init(term);
    fmpz_init_set_ui(scale, 1);
    for (int i = 0; i < 3; i++)
        fmpq_init(&normal[i]);
    direction(normal, s, form);
    for (int k = 0; k <= s->n; k++) {
        fmpq_init(&sum[k]);
        for (int i = 0; i < s->d; i++) {
            exact_shift(term, s, f, form < 0 ? 0 : form, i, k);
            fmpq_addmul(&sum[k], term, &normal[i]);
        }
    }
    common_denominator(scale, sum, s->n);
    bernstein_sum(out, sum, s->n, scale);
    for (int i = 0; i < 3; i++)
        fmpq_clear(&normal[i]);
    for (int k = 0; k <= s->n; k++)
        fmpq_clear(&sum[k]);
    fmpq_clear(term);
    fmpz_clear(scale);
}

/* The parts on [0, at] and [at, 1], by de Casteljau's scheme. */
static void exact_cut(forms left, forms right, forms whole, const scene *s, const fmpq_t at) {
    fmpq_t step;
    fmpq_init(step);
    for (int i = 0; i <= s->d; i++) {
        for (int k = 0; k <= s->n; k++)
            fmpq_set(&right[i][k], &whole[i][k]);
        for (int level = 0; level <= s->n; level++) {
            fmpq_set(&left[i][level], &right[i][0]);
            for (int k = 0; k < s->n - level; k++) {
                fmpq_sub(step, &right[i][k + 1], &right[i][k]);
                fmpq_addmul(&right[i][k], step, at);
            }
        }
    }
    fmpq_clear(step);
}

#endif
