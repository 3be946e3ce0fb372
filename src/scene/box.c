/* A dyadic box around a sweep or an unsweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * At a fixed time M(t) x is affine in x, so it is extreme at the corners of the solid's coordinate
 * box. The image of a corner is a quotient p/w of polynomials in u, and where all Bernstein
 * coefficients w_k of the weight are positive, p/w lies between the least and the greatest p_k/w_k.
 * Intervals whose bound exceeds what is known to be attained by more than the slack, or whose
 * weight has a coefficient that is not positive, are halved.
 */
#include "scene/box.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>

enum { CORNERS = 8, SIGNIFICANT_BITS = 12 };

/* The images of all corners on one interval of u, brought to [0, 1]. */
typedef struct images {
    fmpz_poly_struct value[3 * CORNERS]; /* coordinate i of corner c at i * CORNERS + c */
    fmpz_poly_t weight;
} images;

typedef struct search {
    graze_context *context;
    int dimension, corners;
    slong degree;
    fmpq reached_low[3], reached_high[3]; /* attained by points of the set bounded */
    fmpq low[3], high[3];                 /* bounds of the intervals done so far */
    fmpq_t slack;
} search;

static void images_init(images *m) {
    for (int k = 0; k < 3 * CORNERS; k++)
        fmpz_poly_init(&m->value[k]);
    fmpz_poly_init(m->weight);
}

static void images_clear(images *m) {
    for (int k = 0; k < 3 * CORNERS; k++)
        fmpz_poly_clear(&m->value[k]);
    fmpz_poly_clear(m->weight);
}

/* Binomial multiples of the Bernstein coefficients on [0, 1]: the substitution u = 1/(1 + x)
 * multiplied by (1 + x)^n. Quotients of two such lists are quotients of the coefficients. */
static void bernstein_multiples(fmpz_poly_t out, const fmpz_poly_t p, slong degree) {
    fmpz_t one;
    fmpz_init_set_ui(one, 1);
    fmpz_poly_reverse(out, p, degree + 1);
    fmpz_poly_taylor_shift(out, out, one);
    fmpz_clear(one);
}

static void widen(fmpq *low, fmpq *high, const fmpq_t value, int fresh) {
    if (fresh || fmpq_cmp(value, low) < 0)
        fmpq_set(low, value);
    if (fresh || fmpq_cmp(value, high) > 0)
        fmpq_set(high, value);
}

/* Bounds of coordinate i on the interval, and what its two ends attain. The quotients are compared
 * as they come and reduced only once chosen. */
static void bound(search *s, fmpq *low, fmpq *high, const images *m, const fmpz_poly_t weight,
                  int i) {
    fmpz_poly_t c;
    fmpq_t ratio;
    fmpz_poly_init(c);
    fmpq_init(ratio);
    for (int corner = 0; corner < s->corners; corner++) {
        bernstein_multiples(c, &m->value[i * CORNERS + corner], s->degree);
        for (slong k = 0; k <= s->degree; k++) {
            fmpz_poly_get_coeff_fmpz(fmpq_numref(ratio), c, k);
            fmpz_poly_get_coeff_fmpz(fmpq_denref(ratio), weight, k);
            widen(low, high, ratio, corner == 0 && k == 0);
            if (k == 0 || k == s->degree)
                widen(&s->reached_low[i], &s->reached_high[i], ratio, 0);
        }
    }
    fmpq_canonicalise(low);
    fmpq_canonicalise(high);
    fmpq_canonicalise(&s->reached_low[i]);
    fmpq_canonicalise(&s->reached_high[i]);
    fmpz_poly_clear(c);
    fmpq_clear(ratio);
}

static int all_positive(const fmpz_poly_t weight, slong degree) {
    if (fmpz_poly_length(weight) <= degree)
        return 0;
    for (slong k = 0; k <= degree; k++)
        if (fmpz_sgn(fmpz_poly_get_coeff_ptr(weight, k)) <= 0)
            return 0;
    return 1;
}

/* Is the bound within the slack of what is attained? */
static int tight(const search *s, const fmpq *low, const fmpq *high, int i) {
    fmpq_t gap;
    fmpq_init(gap);
    fmpq_sub(gap, &s->reached_low[i], low);
    int yes = fmpq_cmp(gap, s->slack) <= 0;
    fmpq_sub(gap, high, &s->reached_high[i]);
    yes = yes && fmpq_cmp(gap, s->slack) <= 0;
    fmpq_clear(gap);
    return yes;
}

/* p(u) -> 2^n p(u/2), then p(u) -> p(u + 1). */
static void left_half(fmpz_poly_t out, const fmpz_poly_t p, slong degree) {
    fmpz_t c;
    fmpz_init(c);
    fmpz_poly_zero(out);
    for (slong k = fmpz_poly_degree(p); k >= 0; k--) {
        fmpz_poly_get_coeff_fmpz(c, p, k);
        fmpz_mul_2exp(c, c, (ulong)(degree - k));
        fmpz_poly_set_coeff_fmpz(out, k, c);
    }
    fmpz_clear(c);
}

/* Enclose the coordinates whose bit is set in `open` over the interval. */
static graze_status enclose(search *s, const images *m, unsigned open);

static graze_status enclose_halves(search *s, const images *m, unsigned open) {
    images half;
    fmpz_t one;
    fmpz_init_set_ui(one, 1);
    images_init(&half);
    for (int k = 0; k < 3 * CORNERS; k++)
        left_half(&half.value[k], &m->value[k], s->degree);
    left_half(half.weight, m->weight, s->degree);
    graze_status status = enclose(s, &half, open);
    if (!status) {
        for (int k = 0; k < 3 * CORNERS; k++)
            fmpz_poly_taylor_shift(&half.value[k], &half.value[k], one);
        fmpz_poly_taylor_shift(half.weight, half.weight, one);
        status = enclose(s, &half, open);
    }
    images_clear(&half);
    fmpz_clear(one);
    return status;
}

static graze_status enclose(search *s, const images *m, unsigned open) {
    graze_status status = context_poll(s->context);
    if (status)
        return status;
    fmpz_poly_t weight;
    fmpq *low = _fmpq_vec_init(1), *high = _fmpq_vec_init(1);
    fmpz_poly_init(weight);
    bernstein_multiples(weight, m->weight, s->degree);
    int bounded = all_positive(weight, s->degree);
    for (int i = 0; bounded && i < s->dimension; i++) {
        if (!(open >> i & 1))
            continue;
        bound(s, low, high, m, weight, i);
        if (!tight(s, low, high, i))
            continue;
        open &= ~(1u << i);
        widen(&s->low[i], &s->high[i], low, 0);
        widen(&s->low[i], &s->high[i], high, 0);
    }
    fmpz_poly_clear(weight);
    _fmpq_vec_clear(low, 1);
    _fmpq_vec_clear(high, 1);
    return open ? enclose_halves(s, m, open) : GRAZE_OK;
}

/* The images of the corners of the box [low, high] under a map; all multiplied by one positive
 * integer that clears the corners' denominators. */
static void images_set(images *m, search *s, const point_map *map, const fmpq *low,
                       const fmpq *high) {
    int d = s->dimension;
    fmpz_t common, c;
    fmpz_poly_t term;
    fmpz_init_set_ui(common, 1);
    fmpz_init(c);
    fmpz_poly_init(term);
    for (int j = 0; j < d; j++) {
        fmpz_lcm(common, common, fmpq_denref(low + j));
        fmpz_lcm(common, common, fmpq_denref(high + j));
    }
    s->degree = fmpz_poly_degree(map->weight);
    fmpz_poly_scalar_mul_fmpz(m->weight, map->weight, common);
    for (int i = 0; i < d; i++)
        for (int corner = 0; corner < s->corners; corner++) {
            fmpz_poly_struct *sum = &m->value[i * CORNERS + corner];
            const fmpz_poly_struct *row = map->entry + i * (d + 1);
            fmpz_poly_scalar_mul_fmpz(sum, row + d, common);
            for (int j = 0; j < d; j++) {
                const fmpq *x = ((corner >> j) & 1 ? high : low) + j;
                fmpz_divexact(c, common, fmpq_denref(x));
                fmpz_mul(c, c, fmpq_numref(x));
                fmpz_poly_scalar_mul_fmpz(term, row + j, c);
                fmpz_poly_add(sum, sum, term);
            }
            slong degree = fmpz_poly_degree(sum);
            s->degree = degree > s->degree ? degree : s->degree;
        }
    fmpz_poly_clear(term);
    fmpz_clear(common);
    fmpz_clear(c);
}

/* What the corners attain at u = 0: a first idea of the size, never an empty box. */
static void start(search *s, const images *m) {
    fmpz_t p, w;
    fmpq_t value;
    fmpz_init(p);
    fmpz_init(w);
    fmpq_init(value);
    fmpz_poly_get_coeff_fmpz(w, m->weight, 0);
    for (int i = 0; i < s->dimension; i++)
        for (int corner = 0; corner < s->corners; corner++) {
            fmpz_poly_get_coeff_fmpz(p, &m->value[i * CORNERS + corner], 0);
            fmpq_set_fmpz_frac(value, p, w);
            widen(&s->reached_low[i], &s->reached_high[i], value, corner == 0);
            widen(&s->low[i], &s->high[i], value, corner == 0);
        }
    fmpz_clear(p);
    fmpz_clear(w);
    fmpq_clear(value);
}

/* 2^(e - SIGNIFICANT_BITS), where 2^e <= the longest side of the box < 2^(e+1). */
static void grain(fmpq_t out, const fmpq *low, const fmpq *high, int d) {
    fmpq_t side, longest;
    fmpq_init(side);
    fmpq_init(longest);
    for (int i = 0; i < d; i++) {
        fmpq_sub(side, high + i, low + i);
        if (fmpq_cmp(side, longest) > 0)
            fmpq_set(longest, side);
    }
    slong e = (slong)fmpz_bits(fmpq_numref(longest)) - (slong)fmpz_bits(fmpq_denref(longest));
    fmpq_one(out);
    if (e >= 0)
        fmpq_mul_2exp(out, out, (flint_bitcnt_t)e);
    else
        fmpq_div_2exp(out, out, (flint_bitcnt_t)-e);
    if (fmpq_cmp(out, longest) > 0)
        fmpq_div_2exp(out, out, 1);
    fmpq_div_2exp(out, out, SIGNIFICANT_BITS);
    fmpq_clear(side);
    fmpq_clear(longest);
}

static void round_outwards(fmpq *low, fmpq *high, int d) {
    fmpq_t step, quotient;
    fmpq_init(step);
    fmpq_init(quotient);
    grain(step, low, high, d);
    for (int i = 0; i < d; i++) {
        fmpq_div(quotient, low + i, step);
        fmpz_fdiv_q(fmpq_numref(quotient), fmpq_numref(quotient), fmpq_denref(quotient));
        fmpz_one(fmpq_denref(quotient));
        fmpq_mul(low + i, quotient, step);
        fmpq_div(quotient, high + i, step);
        fmpz_cdiv_q(fmpq_numref(quotient), fmpq_numref(quotient), fmpq_denref(quotient));
        fmpz_one(fmpq_denref(quotient));
        fmpq_mul(high + i, quotient, step);
    }
    fmpq_clear(step);
    fmpq_clear(quotient);
}

static void solid_box(fmpq *low, fmpq *high, const soup *s) {
    for (size_t v = 0; v < s->vertex_count; v++)
        for (int j = 0; j < s->dimension; j++)
            widen(low + j, high + j, s->coordinates + v * (size_t)s->dimension + j, v == 0);
}

/* The unsweep lies in M(t0)^-1 S, so its only piece is the constant map M(t0)^-1. */
static void constant_map(point_map *out, const point_map *map) {
    out->dimension = map->dimension;
    int count = map->dimension * (map->dimension + 1);
    for (int k = 0; k < 12; k++)
        fmpz_poly_init(&out->entry[k]);
    for (int k = 0; k < count; k++)
        fmpz_poly_set_trunc(&out->entry[k], &map->entry[k], 1);
    fmpz_poly_init(out->weight);
    fmpz_poly_set_trunc(out->weight, map->weight, 1);
}

static void point_map_free(point_map *map) {
    for (int k = 0; k < 12; k++)
        fmpz_poly_clear(&map->entry[k]);
    fmpz_poly_clear(map->weight);
}

static void search_init(search *s, graze_context *context, int dimension) {
    s->context = context;
    s->dimension = dimension;
    s->corners = 1 << dimension;
    for (int i = 0; i < 3; i++) {
        fmpq_init(&s->reached_low[i]);
        fmpq_init(&s->reached_high[i]);
        fmpq_init(&s->low[i]);
        fmpq_init(&s->high[i]);
    }
    fmpq_init(s->slack);
}

static void search_clear(search *s) {
    for (int i = 0; i < 3; i++) {
        fmpq_clear(&s->reached_low[i]);
        fmpq_clear(&s->reached_high[i]);
        fmpq_clear(&s->low[i]);
        fmpq_clear(&s->high[i]);
    }
    fmpq_clear(s->slack);
}

graze_status scene_box(fmpq *low, fmpq *high, graze_context *context, const graze_scene *scene) {
    const graze_motion *motion = scene->motion;
    int d = motion->dimension, unsweep = scene->options.operation == GRAZE_UNSWEEP;
    fmpq *from = _fmpq_vec_init(d), *to = _fmpq_vec_init(d);
    solid_box(from, to, &scene->solid->input);
    search s;
    images m;
    point_map still;
    search_init(&s, context, d);
    images_init(&m);
    constant_map(&still, &motion->piece[0].inverse);
    images_set(&m, &s, unsweep ? &still : &motion->piece[0].forward, from, to);
    start(&s, &m);
    grain(s.slack, s.reached_low, s.reached_high, d);
    graze_status status = GRAZE_OK;
    for (size_t p = 0; p < (unsweep ? 1 : motion->piece_count) && !status; p++) {
        if (!unsweep)
            images_set(&m, &s, &motion->piece[p].forward, from, to);
        status = enclose(&s, &m, (1u << d) - 1);
    }
    for (int i = 0; i < d && !status; i++) {
        fmpq_set(low + i, &s.low[i]);
        fmpq_set(high + i, &s.high[i]);
    }
    if (!status)
        round_outwards(low, high, d);
    point_map_free(&still);
    images_clear(&m);
    search_clear(&s);
    _fmpq_vec_clear(from, d);
    _fmpq_vec_clear(to, d);
    return status;
}
