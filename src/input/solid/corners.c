/* Corners in doubles from bounds of the coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/corners.h"

#include <math.h>
#include <stdlib.h>

graze_status corners_make(corners *out, graze_context *context, const soup *s, const simplices *cut,
                          const double *low, const double *high) {
    size_t d = (size_t)s->dimension;
    *out = (corners){.at = NULL};
    for (size_t k = 0; k < s->vertex_count * d; k++) {
        out->error = fmax(out->error, high[k] - low[k]);
        double *reach = &out->axis_reach[k % d];
        *reach = fmax(*reach, fmax(fabs(low[k]), fabs(high[k])));
        out->reach = fmax(out->reach, *reach);
    }
    if (!(out->reach <= CORNER_REACH))
        return GRAZE_OK;
    out->at = malloc((cut->count + 1) * d * d * sizeof *out->at);
    if (!out->at)
        return context_fail(context, GRAZE_ESYSTEM,
                            "out of memory for the corners of %zu simplices", cut->count);
    for (size_t k = 0; k < cut->count; k++)
        for (size_t c = 0; c < d; c++)
            for (size_t i = 0; i < d; i++)
                out->at[(k * d + c) * d + i] = low[cut->item[k].vertex[c] * d + i];
    return GRAZE_OK;
}

void corners_clear(corners *c) {
    free(c->at);
    c->at = NULL;
}
