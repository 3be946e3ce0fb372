/* Corners in doubles from exact coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "solid/corners.h"

#include <math.h>
#include <stdlib.h>
#include "number/rational.h"

/* The coordinates of all vertices; sets error and reach. NULL without memory. */
static double *vertex_doubles(corners *out, const soup *s) {
    size_t n = s->vertex_count * (size_t)s->dimension;
    double *value = malloc((n ? n : 1) * sizeof *value);
    if (!value)
        return NULL;
    for (size_t k = 0; k < n; k++) {
        double low, high;
        rational_bounds(&low, &high, s->coordinates + k);
        value[k] = low;
        out->error = fmax(out->error, high - low);
        out->reach = fmax(out->reach, fmax(fabs(low), fabs(high)));
    }
    return value;
}

graze_status corners_make(corners *out, graze_context *context, const soup *s,
                          const simplices *cut) {
    size_t d = (size_t)s->dimension;
    *out = (corners){.at = NULL};
    double *vertex = vertex_doubles(out, s);
    if (vertex && out->reach <= CORNER_REACH)
        out->at = malloc(cut->count * d * d * sizeof *out->at);
    int enough = vertex && (out->at || !(out->reach <= CORNER_REACH));
    for (size_t k = 0; out->at && k < cut->count; k++)
        for (size_t c = 0; c < d; c++)
            for (size_t i = 0; i < d; i++)
                out->at[(k * d + c) * d + i] = vertex[cut->item[k].vertex[c] * d + i];
    free(vertex);
    return enough ? GRAZE_OK
                  : context_fail(context, GRAZE_ESYSTEM,
                                 "out of memory for the corners of %zu simplices", cut->count);
}

void corners_clear(corners *c) {
    free(c->at);
    c->at = NULL;
}
