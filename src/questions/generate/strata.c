/* One try at a point of each stratum. A try draws its numbers from the row's stream and may fail.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/generate/charts.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/generate/strata.h"

/* Coordinates of random points are multiples of 2^-20 of the box's sides. Displacements are 2^-k, k
 * = LEAST + STEP j with j < STEPS; STEP is 1 for `near`. */
enum {
    BOX_BITS = 20,
    MISS_LEAST = 8,
    MISS_STEP = 8,
    MISS_STEPS = 12,
    NEAR_LEAST = 4,
    NEAR_STEPS = 8
};

/* Displace by 2^-k along the outward normal, scaled so that its largest coordinate is 1 in size; if
 * only doubles are made, along the axis of that coordinate alone. */
static void displace(sample *s, const struct graze_generator *g, const fmpq *normal, int outward,
                     int k) {
    int d = g->scene->motion->dimension;
    LOCAL_VEC(fmpq, length, 2);
    fmpq *size = length + 1;
    int widest = vector_widest(length, normal, d);
    for (int i = 0; i < d; i++) {
        if (g->representable && i != widest)
            continue;
        fmpq_div(size, normal + i, length);
        fmpq_div_2exp(size, size, (ulong)k);
        (outward ? fmpq_add : fmpq_sub)(s->point + i, s->point + i, size);
    }
    s->made.k = k;
    s->made.outward = outward;
}

static int try_random(sample *out, const struct graze_generator *g, random_stream *r) {
    LOCAL(fmpq, part);
    for (int i = 0; i < g->scene->motion->dimension; i++) {
        fmpq_sub(out->point + i, g->high + i, g->low + i);
        fmpq_set_si(part, (slong)random_below(r, (1u << BOX_BITS) + 1), 1u << BOX_BITS);
        fmpq_mul(out->point + i, out->point + i, part);
        fmpq_add(out->point + i, out->point + i, g->low + i);
    }
    return sample_is_kept(out, g);
}

graze_status stratum_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                             const struct graze_generator *g, graze_stratum stratum,
                             random_stream *r) {
    if (g->atlas)
        return curved_contact(made, out, normal, context, g, stratum, r);
    *made = straight_contact(out, normal, g, stratum, r);
    return GRAZE_OK;
}

/* Try once for a contact of a stratum, displaced by 2^-k to a random side if k is not 0. */
static graze_status try_contact(int *made, sample *out, graze_context *context,
                                const struct graze_generator *g, graze_stratum stratum,
                                random_stream *r, int k) {
    LOCAL_VEC(fmpq, normal, 3);
    graze_status status = stratum_contact(made, out, k ? normal : NULL, context, g, stratum, r);
    if (*made && k)
        displace(out, g, normal, (int)random_below(r, 2), k);
    *made = *made && sample_is_kept(out, g);
    return status;
}

graze_status stratum_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, graze_stratum stratum, random_stream *r) {
    static const graze_stratum missed[] = {GRAZE_STRATUM_FACE, GRAZE_STRATUM_EDGE,
                                           GRAZE_STRATUM_VERTEX, GRAZE_STRATUM_START,
                                           GRAZE_STRATUM_END};
    out->made = (graze_sample){.stratum = stratum};
    switch (stratum) {
    case GRAZE_STRATUM_RANDOM:
        *made = try_random(out, g, r);
        return GRAZE_OK;
    case GRAZE_STRATUM_NEAR:
        return try_contact(made, out, context, g, GRAZE_STRATUM_FACE, r,
                           NEAR_LEAST + (int)random_below(r, NEAR_STEPS));
    case GRAZE_STRATUM_MISS: {
        graze_stratum from = missed[random_below(r, sizeof missed / sizeof *missed)];
        return try_contact(made, out, context, g, from, r,
                           MISS_LEAST + MISS_STEP * (int)random_below(r, MISS_STEPS));
    }
    default:
        return try_contact(made, out, context, g, stratum, r, 0);
    }
}
