/* Corners in doubles from bounds of the coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include <math.h>
#include <stdlib.h>

/* Set `error` and `reach` from the corners of the simplices; vertices of no simplex do not count.
 */
static void find_reach(corners *out, size_t d, const simplices *cut, const double *low,
                       const double *high) {
    for (size_t k = 0; k < cut->count; k++)
        for (size_t c = 0; c < d; c++)
            for (size_t i = 0; i < d; i++) {
                size_t at = cut->item[k].vertex[c] * d + i;
                out->error = fmax(out->error, high[at] - low[at]);
                out->axis_reach[i] = fmax(out->axis_reach[i], fmax(fabs(low[at]), fabs(high[at])));
            }
    for (size_t i = 0; i < d; i++)
        out->reach = fmax(out->reach, out->axis_reach[i]);
}

graze_status corners_make(corners *out, graze_context *context, const soup *s, const simplices *cut,
                          const double *low, const double *high) {
    size_t d = (size_t)s->dimension;
    *out = (corners){.at = NULL};
    find_reach(out, d, cut, low, high);
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
