/* Rounds exact contacts to doubles on either side. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/generate/strata.h"

#include <float.h>
#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"

/* Doubles on both sides of each coordinate of a point; low[i] equals high[i] for a coordinate that
 * stays as it is. */
typedef struct neighbours {
    int d, moved; /* moved: number of coordinates with low[i] < high[i] */
    double low[3], high[3];
} neighbours;

/* The distance from 0 of the neighbours of a coordinate 0: 2^-53 times the point's largest
 * coordinate, or 2^-53 at the origin. */
static double step_from_zero(const double *nearest, int d) {
    double largest = 0;
    for (int i = 0; i < d; i++)
        largest = fmax(largest, fabs(nearest[i]));
    return (largest > 0 ? largest : 1) * (DBL_EPSILON / 2);
}

/* Set the neighbours of one coordinate; both are the coordinate itself if it is a double that
 * `stays`. */
static graze_status find_neighbours(neighbours *out, int i, graze_context *context, const fmpq_t x,
                                    double nearest, double step, int stays) {
    LOCAL(fmpq, rounded);
    TRY(rational_from_double(rounded, context, nearest));
    int side = fmpq_cmp(rounded, x);
    double low = nearest != 0 ? nextafter(nearest, -DBL_MAX) : -step;
    double high = nearest != 0 ? nextafter(nearest, DBL_MAX) : step;
    out->low[i] = side < 0 || (side == 0 && stays) ? nearest : low;
    out->high[i] = side > 0 || (side == 0 && stays) ? nearest : high;
    out->moved += out->low[i] != out->high[i];
    return GRAZE_OK;
}

static graze_status point_neighbours(neighbours *out, graze_context *context, const fmpq *point,
                                     int d, random_stream *r) {
    double nearest[3];
    *out = (neighbours){.d = d};
    for (int i = 0; i < d; i++)
        TRY(rational_nearest(&nearest[i], context, point + i));
    for (int i = 0; i < d; i++) {
        int stays = (int)random_below(r, 2);
        TRY(find_neighbours(out, i, context, point + i, nearest[i], step_from_zero(nearest, d),
                            stays));
    }
    return GRAZE_OK;
}

/* Go through the choices from a random one on until the point is on the wanted side; if none is,
 * the last choice is kept. */
static graze_status take_side(sample *out, graze_context *context, const struct graze_generator *g,
                              const neighbours *n, random_stream *r) {
    size_t choices = (size_t)1 << n->d, first = random_below(r, choices);
    graze_pmc wanted = random_below(r, 2) ? GRAZE_IN : GRAZE_OUT;
    out->made.pmc = GRAZE_ON;
    for (size_t k = 0; k < choices && (k == 0 || out->made.pmc != wanted); k++) {
        graze_verdict found;
        for (int i = 0; i < n->d; i++)
            TRY(rational_from_double(out->point + i, context,
                                     (first + k) % choices >> i & 1 ? n->high[i] : n->low[i]));
        TRY(classify_answer(&found, context, g->scene, (query_point){.rational = out->point},
                            TRACE_PMC_BESIDE));
        out->made.pmc = found.pmc;
    }
    return GRAZE_OK;
}

graze_status rounded_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, random_stream *r) {
    static const graze_stratum from[] = {
        GRAZE_STRATUM_FACE,   GRAZE_STRATUM_FACE_ODD, GRAZE_STRATUM_EDGE,
        GRAZE_STRATUM_VERTEX, GRAZE_STRATUM_CROSSING, GRAZE_STRATUM_START,
        GRAZE_STRATUM_END,    GRAZE_STRATUM_BREAK,    GRAZE_STRATUM_SLIDE};
    neighbours near;
    out->made = (graze_sample){.stratum = GRAZE_STRATUM_ROUNDED,
                               .origin = from[random_below(r, sizeof from / sizeof *from)]};
    TRY(stratum_contact(made, out, NULL, context, g, out->made.origin, r));
    if (!*made)
        return GRAZE_OK;
    TRY(point_neighbours(&near, context, out->point, g->scene->motion->dimension, r));
    *made = near.moved > 0;
    return *made && !out->alone ? take_side(out, context, g, &near, r) : GRAZE_OK;
}
