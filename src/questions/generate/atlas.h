/* Rational points of a curved solid's surfaces, of their edges and vertices, and where they are
 * touched at a time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_ATLAS_H
#define GRAZE_GENERATE_ATLAS_H

#include "questions/generate/charts.h"
#include "questions/generate/instant.h"

/** Charts of the arrangement of all surfaces: not all of their points are on the boundary. */
typedef struct atlas {
    const csg *solid;
    fmpq_mpoly_ctx_t ring;
    fmpq low[3], high[3]; /* a box of the solid */
    charts faces, edges, vertices;
    charts
        touches; /* where a surface's normal velocity is zero: mark is the number of an instant */
} atlas;

/**
 * Look for points of a curved solid that has a box, in bounded time: where it has many surfaces,
 * not of all pairs.
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM; atlas_clear in any case
 */
graze_status atlas_make(atlas *out, graze_context *context, const csg *solid,
                        const instant *instants, size_t count);
void atlas_clear(atlas *a);

#endif
