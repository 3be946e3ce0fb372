/* Affine functions of a plane's coordinates whose coefficients are polynomials in time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_PULLBACK_H
#define GRAZE_TOPO_PULLBACK_H

#include <flint/fmpz_poly.h>
#include "input/motion/motion.h"
#include "questions/topo/plane.h"

/** The function linear[0] x + linear[1] y + linear[2]; its coefficients are polynomials in time. */
typedef struct pullback_form {
    fmpz_poly_struct linear[3];
} pullback_form;

void pullback_init(pullback_form *f);
void pullback_clear(pullback_form *f);

/** Compose a form on the body's space with a map at all times, restricted to the view, times an
 * integer. */
void pullback_of_form(pullback_form *f, const point_map *map, const fmpz *form,
                      const plane_view *view);

/** Divide by the coefficients' common factor, set `common` to it, and return the remaining degree
 * in time. */
slong pullback_reduce(pullback_form *f, fmpz_poly_t common);

/** Evaluate at one time: the result is a line or a constant. */
void pullback_at(fmpz_mpoly_t out, const pullback_form *f, const fmpz_t time,
                 const fmpz_mpoly_ctx_t ring);

#endif
