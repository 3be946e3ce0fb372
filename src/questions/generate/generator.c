/* Names of strata, samples, and tests of the points and orders that a stratum takes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include "base/context/scope.h"

static const struct {
    const char *name;
    unsigned long weight;
} strata[GRAZE_STRATUM_COUNT] = {{"random", 4}, {"near", 4},    {"face", 16},    {"face-odd", 4},
                                 {"edge", 15},  {"vertex", 15}, {"crossing", 4}, {"start", 9},
                                 {"end", 9},    {"break", 7},   {"slide", 3},    {"miss", 4},
                                 {"level", 0},  {"rounded", 0}};

static int is_stratum(graze_stratum stratum) {
    return (int)stratum >= 0 && stratum < GRAZE_STRATUM_COUNT;
}

const char *stratum_name(graze_stratum stratum) {
    return is_stratum(stratum) ? strata[stratum].name : NULL;
}

unsigned long stratum_weight(graze_stratum stratum) {
    return is_stratum(stratum) ? strata[stratum].weight : 0;
}

void sample_init(sample *s) {
    memset(&s->made, 0, sizeof s->made);
    s->point = _fmpq_vec_init(4);
    s->time = s->point + 3;
    s->undecided = 0;
    s->alone = s->unkept = 0;
}

void sample_clear(sample *s) {
    _fmpq_vec_clear(s->point, 4);
}

const instant *stratum_instant(const struct graze_generator *g, graze_stratum stratum,
                               random_stream *r) {
    const instant *any = &g->instants[random_below(r, g->instant_count)];
    if (stratum == GRAZE_STRATUM_START)
        return &g->joints[0];
    if (stratum == GRAZE_STRATUM_END)
        return &g->joints[g->joint_count - 1];
    if (stratum != GRAZE_STRATUM_BREAK)
        return any;
    return g->joint_count < 3 ? NULL : &g->joints[1 + random_below(r, g->joint_count - 2)];
}

int order_of_root(fmpz_poly_t f, const fmpq_t u) {
    int order = 0;
    LOCAL(fmpq, value);
    if (fmpz_poly_is_zero(f))
        return GRAZE_ORDER_SLIDE;
    fmpz_poly_evaluate_fmpq(value, f, u);
    for (; fmpq_is_zero(value); order++) {
        fmpz_poly_derivative(f, f);
        fmpz_poly_evaluate_fmpq(value, f, u);
    }
    return order;
}

int stratum_takes_order(graze_stratum stratum, int order) {
    switch (stratum) {
    case GRAZE_STRATUM_FACE:
        return order >= 2 && order % 2 == 0;
    case GRAZE_STRATUM_FACE_ODD:
        return order >= 3 && order % 2 == 1;
    case GRAZE_STRATUM_CROSSING:
        return order == 1;
    case GRAZE_STRATUM_SLIDE:
        return order == GRAZE_ORDER_SLIDE;
    default:
        return 1;
    }
}

/* Is x a binary64 number that is not near the ends of the exponent's range? */
static int is_double(const fmpq_t x) {
    const fmpz *p = fmpq_numref(x), *q = fmpq_denref(x);
    if (fmpz_is_zero(p))
        return 1;
    return fmpz_val2(q) + 1 == fmpz_bits(q) && fmpz_bits(p) - fmpz_val2(p) <= 53 &&
           fmpz_bits(p) < 1000 && fmpz_bits(q) < 1000;
}

int sample_place(sample *out, const instant *when, const fmpz *y, int dyadic) {
    int d = when->dimension;
    LOCAL_VEC(fmpz, value, 3);
    fmpz *common = value + 1, *odd = value + 2; /* odd part of the common denominator */
    fmpz_mul(common, when->map + d * (d + 1) + d, y + d);
    fmpz_tdiv_q_2exp(odd, common, fmpz_val2(common));
    for (int i = 0; i < d; i++) {
        _fmpz_vec_dot(value, when->map + i * (d + 1), y, d + 1);
        if (dyadic && !fmpz_divisible(value, odd)) {
            out->unkept = 1;
            return 0;
        }
        fmpq_set_fmpz_frac(out->point + i, value, common);
    }
    return 1;
}

int sample_is_kept(sample *s, const struct graze_generator *g) {
    for (int i = 0; g->representable && i < g->scene->motion->dimension; i++)
        if (!is_double(s->point + i)) {
            s->unkept = 1;
            return 0;
        }
    return 1;
}
