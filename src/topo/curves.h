/* The plane curves on which the boundary of a sweep lies.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_CURVES_H
#define GRAZE_TOPO_CURVES_H

#include <flint/fmpq_mpoly.h>
#include "scene/scene.h"

/** Largest degree in time of a line's pullback whose discriminant is taken, and most curves. */
enum { CURVE_DEGREE = 16, CURVE_COUNT = 100000 };

/** Variables of the ring. */
enum { RING_X, RING_Y, RING_T, RING_VARIABLES };

/** Polynomials in x and y, none of them constant; `ring` has t too. */
typedef struct curve_list {
    fmpz_mpoly_ctx_t ring;
    size_t count, capacity;
    fmpz_mpoly_struct *item;
} curve_list;

void curves_init(curve_list *list);
void curves_clear(curve_list *list);

/** Append a copy of a polynomial that is not 0; one without x and y is left out. */
graze_status curves_append(curve_list *list, graze_context *context, const fmpz_mpoly_t curve);

/**
 * Append curves in the zeros of which the boundary of the closed sweep lies (proofs/topology.md
 * C50): the facets' lines at the ends of all pieces, the paths of the vertices, and the
 * discriminants of the lines' pullbacks. Not dependent on any point.
 * @param[out] refused 1 where a curve is too dear: then the list is not whole
 */
graze_status curves_of_scene(curve_list *list, int *refused, graze_context *context,
                             const graze_scene *scene);

#endif
