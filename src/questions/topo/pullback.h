/* Functions that are linear in the coordinates of a plane, with coefficients that depend on time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_PULLBACK_H
#define GRAZE_TOPO_PULLBACK_H

#include <flint/fmpz_poly.h>
#include "input/motion/motion.h"
#include "questions/topo/plane.h"

/** linear[0] x + linear[1] y + linear[2], whose coefficients are polynomials in time. */
typedef struct pullback_form {
    fmpz_poly_struct linear[3];
} pullback_form;

void pullback_init(pullback_form *f);
void pullback_clear(pullback_form *f);

/** The form over the images of all points of E^d under a map, times an integer, as a function of
 * the view's coordinates. */
void pullback_of_form(pullback_form *f, const point_map *map, const fmpz *form,
                      const plane_view *view);

/** Divide by the common factor, which is handed over; returns the degree in time that remains. */
slong pullback_reduce(pullback_form *f, fmpz_poly_t common);

/** At one time: a line, or a constant. */
void pullback_at(fmpz_mpoly_t out, const pullback_form *f, const fmpz_t time,
                 const fmpz_mpoly_ctx_t ring);

#endif
