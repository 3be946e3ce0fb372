/* Discriminants and resultants in time. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_TOPO_GRID_H
#define GRAZE_TOPO_GRID_H

#include "questions/topo/pullback.h"

/** The discriminant with respect to time of a function of degree n >= 2 in time, as a polynomial in
 * x and y. */
graze_status grid_discriminant(fmpz_mpoly_t out, graze_context *context, const pullback_form *f,
                               slong n, const fmpz_mpoly_ctx_t ring);

/** The resultant with respect to time of two functions of degrees n, m >= 1 in time. */
graze_status grid_resultant(fmpz_mpoly_t out, graze_context *context, const pullback_form *f,
                            slong n, const pullback_form *g, slong m, const fmpz_mpoly_ctx_t ring);

#endif
