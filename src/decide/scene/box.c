/* A dyadic box around a sweep or an unsweep.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * At a fixed time M(t) x is affine in x, so it is extreme at the corners of the solid's coordinate
 * box. The image of a corner is a quotient p/w of polynomials in u, and where all Bernstein
 * coefficients w_k of the weight are positive, p/w lies between the least and the greatest p_k/w_k.
 * Intervals whose bound exceeds the attained values by more than the slack, or whose
 * weight has a coefficient that is not positive, are halved. Far down, where functions change over
 * tiny times, halves are cut only as long as the limit `work` allows; then bounds are taken as they
 * are, and the box is larger.
 */
#include "decide/scene/scene.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/bernstein.h"

enum { CORNERS = 8, POLYNOMIALS = 3 * CORNERS + 1, SIGNIFICANT_BITS = 12 };
/* Levels of halves that are always allowed; the most levels, which the stack holds; operations on
 * words for one unit of the limit `work`. */
enum { FREE_DEPTH = 16, DEEPEST = 4096, WORDS_A_UNIT = 4 };

/* The images of all corners on one interval of u: Bernstein coefficients, degree + 1 of each
 * polynomial, all multiplied by one positive integer. */
typedef struct images {
    int corners;
    slong count, degree; /* polynomials: the coordinates, then the weight */
    fmpz *coefficient;
} images;

typedef struct search {
    graze_context *context;
    int dimension;
    fmpq *reached_low, *reached_high; /* least and greatest values that are attained */
    fmpq *low, *high;                 /* bounds of the intervals done so far */
    fmpq *slack;
    int depth;
    double work; /* operations on words so far */
} search;

static void images_init(images *m, int dimension, slong degree) {
    m->corners = 1 << dimension;
    m->count = dimension * m->corners + 1;
    m->degree = degree;
    m->coefficient = _fmpz_vec_init(m->count * (degree + 1));
}

static void images_clear(images *m) {
    _fmpz_vec_clear(m->coefficient, m->count * (m->degree + 1));
}

static fmpz *weight_of(const images *m) {
    return m->coefficient + (m->count - 1) * (m->degree + 1);
}

/* Coordinate i of a corner's image. */
static fmpz *value_of(const images *m, int i, int corner) {
    return m->coefficient + (i * m->corners + corner) * (m->degree + 1);
}

static void widen(fmpq *low, fmpq *high, const fmpq_t value, int fresh) {
    if (fresh || fmpq_cmp(value, low) < 0)
        fmpq_set(low, value);
    if (fresh || fmpq_cmp(value, high) > 0)
        fmpq_set(high, value);
}

/* Bounds of coordinate i on the interval, and its values at the two ends. The quotients are
 * compared as they come and reduced only once chosen. */
static void bound_coordinate(search *s, fmpq *low, fmpq *high, const images *m, int i) {
    LOCAL(fmpq, ratio);
    for (int corner = 0; corner < m->corners; corner++)
        for (slong k = 0; k <= m->degree; k++) {
            fmpz_set(fmpq_numref(ratio), value_of(m, i, corner) + k);
            fmpz_set(fmpq_denref(ratio), weight_of(m) + k);
            widen(low, high, ratio, corner == 0 && k == 0);
            if (k == 0 || k == m->degree)
                widen(s->reached_low + i, s->reached_high + i, ratio, 0);
        }
    fmpq_canonicalise(low);
    fmpq_canonicalise(high);
    fmpq_canonicalise(s->reached_low + i);
    fmpq_canonicalise(s->reached_high + i);
}

static int weight_is_positive(const images *m) {
    for (slong k = 0; k <= m->degree; k++)
        if (fmpz_sgn(weight_of(m) + k) <= 0)
            return 0;
    return 1;
}

/* Is the bound within the slack of the attained values? */
static int tight(const search *s, const fmpq *low, const fmpq *high, int i) {
    LOCAL_VEC(fmpq, gap, 2);
    fmpq_sub(gap, s->reached_low + i, low);
    fmpq_sub(gap + 1, high, s->reached_high + i);
    return fmpq_cmp(gap, s->slack) <= 0 && fmpq_cmp(gap + 1, s->slack) <= 0;
}

/* Count what bounding and halving an interval cost; 1 if the work is spent. */
static int is_spent(search *s, const images *m) {
    double words = fabs((double)_fmpz_vec_max_bits(weight_of(m), m->degree + 1)) / FLINT_BITS + 1;
    double count = (double)(m->count * (m->degree + 1));
    s->work += count * words * ((double)m->degree + 1 + words / 8);
    double most = (double)s->context->limits[GRAZE_LIMIT_WORK] * WORDS_A_UNIT;
    return s->depth > FREE_DEPTH && (s->work > most || s->depth > DEEPEST);
}

/* Bound the coordinates whose bit is set in `open` over the interval of `m`. */
static graze_status enclose_coordinates(search *s, const images *m, unsigned open);

static graze_status enclose_halves(search *s, const images *m, unsigned open) {
    HELD(images, left, s->dimension, m->degree);
    HELD(images, right, s->dimension, m->degree);
    for (slong k = 0; k < m->count; k++) {
        slong at = k * (m->degree + 1);
        if (k < m->count - 1 && !(open >> k / m->corners & 1))
            continue;
        bernstein_split(left.coefficient + at, right.coefficient + at, m->coefficient + at,
                        m->degree);
    }
    s->depth++;
    graze_status status = enclose_coordinates(s, &left, open);
    if (!status)
        status = enclose_coordinates(s, &right, open);
    s->depth--;
    return status;
}

static graze_status enclose_coordinates(search *s, const images *m, unsigned open) {
    TRY(context_poll(s->context));
    int bounded = weight_is_positive(m), spent = is_spent(s, m);
    if (spent && !bounded)
        return context_limit(s->context, GRAZE_LIMIT_WORK, "a box around the sweep");
    LOCAL_VEC(fmpq, low, 1);
    LOCAL_VEC(fmpq, high, 1);
    for (int i = 0; bounded && i < s->dimension; i++) {
        if (!(open >> i & 1))
            continue;
        bound_coordinate(s, low, high, m, i);
        if (!spent && !tight(s, low, high, i))
            continue;
        open &= ~(1u << i);
        widen(s->low + i, s->high + i, low, 0);
        widen(s->low + i, s->high + i, high, 0);
    }
    return open ? enclose_halves(s, m, open) : GRAZE_OK;
}

/* The images of the corners of a box under a map, in powers of u: coordinates, then the weight, all
 * multiplied by one positive integer that clears the corners' denominators. Returns the degree. */
static slong move_corners(fmpz_poly_struct *out, const point_map *map, const fmpq *box) {
    int d = map->dimension, corners = 1 << d;
    LOCAL_VEC(fmpz, x, 2 * d + 1);
    fmpz *common = x + 2 * d;
    _fmpq_vec_get_fmpz_vec_fmpz(x, common, box, 2 * d);
    slong degree = fmpz_poly_degree(map->weight);
    fmpz_poly_scalar_mul_fmpz(out + d * corners, map->weight, common);
    for (int i = 0; i < d; i++)
        for (int corner = 0; corner < corners; corner++) {
            fmpz_poly_struct *sum = out + i * corners + corner;
            const fmpz_poly_struct *row = map->entry + i * (d + 1);
            fmpz_poly_scalar_mul_fmpz(sum, row + d, common);
            for (int j = 0; j < d; j++)
                fmpz_poly_scalar_addmul_fmpz(sum, row + j, x + (corner >> j & 1 ? d + j : j));
            degree = FLINT_MAX(degree, fmpz_poly_degree(sum));
        }
    return degree;
}

/* The images of the corners of a box, d lower ends and d upper ends, under a map. */
static void images_make(images *m, const point_map *map, const fmpq *box) {
    LOCAL_VEC(fmpz_poly, power, POLYNOMIALS);
    images_init(m, map->dimension, move_corners(power, map, box));
    for (slong k = 0; k < m->count; k++)
        bernstein_from_poly(m->coefficient + k * (m->degree + 1), &power[k], m->degree,
                            &unit_interval);
}

/* Start with the corners at u = 0: a first estimate of the size, never an empty box. */
static void start_search(search *s, const images *m) {
    LOCAL(fmpq, value);
    for (int i = 0; i < s->dimension; i++)
        for (int corner = 0; corner < m->corners; corner++) {
            fmpq_set_fmpz_frac(value, value_of(m, i, corner), weight_of(m));
            widen(s->reached_low + i, s->reached_high + i, value, corner == 0);
            widen(s->low + i, s->high + i, value, corner == 0);
        }
}

/* 2^(e - SIGNIFICANT_BITS), where 2^e <= the longest side of the box < 2^(e+1). */
static void grain(fmpq_t out, const fmpq *low, const fmpq *high, int d) {
    LOCAL_VEC(fmpq, side, 2);
    fmpq *longest = side + 1;
    for (int i = 0; i < d; i++) {
        fmpq_sub(side, high + i, low + i);
        if (fmpq_cmp(side, longest) > 0)
            fmpq_set(longest, side);
    }
    slong e = (slong)fmpz_bits(fmpq_numref(longest)) - (slong)fmpz_bits(fmpq_denref(longest));
    fmpq_one(out);
    rational_shift(out, e);
    if (fmpq_cmp(out, longest) > 0)
        fmpq_div_2exp(out, out, 1);
    fmpq_div_2exp(out, out, SIGNIFICANT_BITS);
}

static void round_outwards(fmpq *low, fmpq *high, int d) {
    LOCAL_VEC(fmpq, step, 2);
    fmpq *quotient = step + 1;
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

graze_status scene_box(fmpq *low, fmpq *high, graze_context *context, const graze_scene *scene) {
    const graze_motion *motion = scene->motion;
    int d = motion->dimension, unsweep = scene->options.operation == GRAZE_UNSWEEP;
    LOCAL_VEC(fmpq, box, 2 * d);
    solid_box(box, box + d, scene->solid);
    images m;
    point_map still;
    LOCAL_VEC(fmpq, kept, 7);
    search s = {.context = context,
                .dimension = d,
                .reached_low = kept,
                .reached_high = kept + 3,
                .low = low,
                .high = high,
                .slack = kept + 6};
    constant_map(&still, &motion->piece[0].inverse);
    images_make(&m, unsweep ? &still : &motion->piece[0].forward, box);
    start_search(&s, &m);
    grain(s.slack, s.reached_low, s.reached_high, d);
    graze_status status = GRAZE_OK;
    for (size_t p = 0; p < (unsweep ? 1 : motion->piece_count) && !status; p++) {
        if (p > 0) {
            images_clear(&m);
            images_make(&m, &motion->piece[p].forward, box);
        }
        status = enclose_coordinates(&s, &m, (1u << d) - 1);
    }
    if (!status)
        round_outwards(low, high, d);
    point_map_clear(&still);
    images_clear(&m);
    return status;
}
