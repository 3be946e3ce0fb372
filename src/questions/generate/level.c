/* Displaces contacts by a length in the decade that is drawn, and computes the signed distance to
 * see whether the displaced point lies in the decade.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/strata.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/distance/distance.h"

/* Lengths are 1 + 8 (j / 64)^2 times the power of ten; coordinates are multiples of a power of two
 * that is at most 2^-15 of the length; the enclosure of the distance is no wider than 2^-8 of the
 * length. */
enum { STEPS = 64, PLACE_BITS = 16, WIDTH_BITS = 8 };

/* The number of decades below that of the diagonal that are searched, and the number of tries for
 * one level. */
enum { DECADES_DOWN = 9, LEVEL_TRIES = 150 };

/* 10^decade */
static void power_of_ten(fmpq_t out, int decade) {
    fmpq_set_si(out, 10, 1);
    fmpq_pow_si(out, out, decade);
}

/* Draw a length in the decade; small ones are drawn more often. */
static graze_status draw_length(double *out, graze_context *context, int decade, random_stream *r) {
    slong j = 1 + (slong)random_below(r, STEPS - 1);
    LOCAL_VEC(fmpq, length, 2);
    fmpq *part = length + 1;
    power_of_ten(length, decade);
    fmpq_set_si(part, STEPS * STEPS + 8 * j * j, STEPS * STEPS);
    fmpq_mul(length, length, part);
    return rational_nearest(out, context, length);
}

/* Move a point by about `length` along a direction and round it down; the distance is computed
 * afterwards. */
static graze_status move_along(fmpq *point, graze_context *context, const fmpq *normal, int d,
                               double length) {
    double n[3] = {0, 0, 0}, size = 0;
    LOCAL_VEC(fmpq, most, 2);
    fmpq *part = most + 1;
    (void)vector_widest(most, normal, d);
    for (int i = 0; i < d; i++) {
        fmpq_div(part, normal + i, most);
        TRY(rational_nearest(&n[i], context, part));
        size += n[i] * n[i];
    }
    int exponent;
    LOCAL(fmpz, whole);
    (void)frexp(length, &exponent);
    for (int i = 0; i < d; i++) {
        TRY(rational_from_double(part, context, n[i] / sqrt(size) * length));
        fmpq_add(point + i, point + i, part);
        rational_shift(point + i, PLACE_BITS - exponent);
        fmpz_fdiv_q(whole, fmpq_numref(point + i), fmpq_denref(point + i));
        fmpq_set_fmpz(point + i, whole);
        rational_shift(point + i, exponent - PLACE_BITS);
    }
    return GRAZE_OK;
}

/* Trace a point; if `length` is positive, enclose its distance too, to 2^-8 of `length`. */
static graze_status measure(graze_pmc *pmc, distance *found, graze_context *context,
                            const graze_scene *scene, const fmpq *point, double length) {
    graze_trace trace;
    graze_status status = GRAZE_OK;
    TRY(classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS));
    *pmc = trace.verdict.pmc;
    if (length > 0)
        status = distance_find(found, context, scene, point, &trace, ldexp(length, -WIDTH_BITS));
    trace_clear(&trace);
    return status;
}

/* Is |s| certainly in the decade? */
static int is_in_decade(const distance *found, graze_context *context, int decade) {
    double low = fmin(fabs(found->low), fabs(found->high));
    double high = fmax(fabs(found->low), fabs(found->high));
    LOCAL_VEC(fmpq, from, 4);
    fmpq *to = from + 1, *least = from + 2, *greatest = from + 3;
    power_of_ten(from, decade);
    power_of_ten(to, decade + 1);
    return !rational_from_double(least, context, low) &&
           !rational_from_double(greatest, context, high) && fmpq_cmp(least, from) >= 0 &&
           fmpq_cmp(greatest, to) < 0;
}

/* Displace the point of a contact. *made becomes 1 if the contact is `on`, and the displaced point
 * is on the wanted side and certainly in the decade. */
static graze_status place_beside(int *made, sample *out, graze_context *context,
                                 const struct graze_generator *g, const fmpq *normal, level where,
                                 random_stream *r) {
    double length;
    distance found;
    graze_pmc pmc, wanted = where.outward ? GRAZE_OUT : GRAZE_IN;
    TRY(draw_length(&length, context, where.decade, r));
    TRY(measure(&pmc, &found, context, g->scene, out->point, 0));
    if (pmc != GRAZE_ON)
        return GRAZE_OK;
    TRY(move_along(out->point, context, normal, g->scene->motion->dimension,
                   where.outward ? length : -length));
    if (!sample_is_kept(out, g))
        return GRAZE_OK;
    TRY(measure(&pmc, &found, context, g->scene, out->point, length));
    *made = pmc == wanted && is_in_decade(&found, context, where.decade);
    return GRAZE_OK;
}

static graze_status try_level(int *made, sample *out, graze_context *context,
                              const struct graze_generator *g, level where, random_stream *r) {
    static const graze_stratum from[] = {GRAZE_STRATUM_FACE,  GRAZE_STRATUM_SLIDE,
                                         GRAZE_STRATUM_START, GRAZE_STRATUM_END,
                                         GRAZE_STRATUM_EDGE,  GRAZE_STRATUM_VERTEX};
    LOCAL_VEC(fmpq, normal, 3);
    int touches = 0;
    *made = 0;
    out->made = (graze_sample){.stratum = GRAZE_STRATUM_LEVEL};
    TRY(stratum_contact(&touches, out, normal, context, g,
                        from[random_below(r, sizeof from / sizeof *from)], r));
    if (touches)
        TRY(place_beside(made, out, context, g, normal, where, r));
    out->made.outward = where.outward;
    out->made.decade = where.decade;
    return GRAZE_OK;
}

graze_status level_try(int *made, sample *out, graze_context *context,
                       const struct graze_generator *g, random_stream *r) {
    return try_level(made, out, context, g, g->levels[random_below(r, g->level_count)], r);
}

static graze_status look_for(int *found, graze_context *context, const struct graze_generator *g,
                             level where, random_stream *r) {
    HELD(sample, s);
    *found = 0;
    for (int k = 0; k < LEVEL_TRIES && !*found; k++) {
        TRY(try_level(found, &s, context, g, where, r));
        TRY(context_poll(context));
    }
    return GRAZE_OK;
}

graze_status levels_find(struct graze_generator *g, graze_context *context) {
    double diagonal;
    int deepest = 0, found;
    random_stream r;
    random_seed(&r, g->seed, LEVEL_STREAM);
    TRY(distance_diagonal(&diagonal, context, g->scene));
    int top = (int)floor(log10(diagonal));
    for (int k = 0; k <= DECADES_DOWN; k++)
        for (int outward = 0; outward < 2; outward++) {
            level where = {top - k, outward};
            if (outward && !deepest)
                continue; /* no `in` point is found in this or a larger decade */
            TRY(look_for(&found, context, g, where, &r));
            deepest |= found && !outward;
            if (found)
                g->levels[g->level_count++] = where;
            else if (deepest)
                g->missing[g->missing_count++] = where;
        }
    return GRAZE_OK;
}
