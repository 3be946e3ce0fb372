/* Curves as squarefree parts without common factors.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_COPRIME_H
#define GRAZE_TOPO_COPRIME_H

#include "questions/topo/plane.h"

/**
 * Add a curve to a list of squarefree, pairwise coprime polynomials with the same zeros as all that
 * was added. Small ones are factored, since factors that stay away from a point are cheap;
 * factoring large ones can take minutes, so only their common factors are looked for, and most of
 * these are excluded modulo a prime.
 * @param[out] refused 1 if a polynomial with a common factor has more digits than that is bounded
 *                     for (the context's limit `bits`); else as it was
 */
graze_status coprime_add(curve_list *parts, int *refused, graze_context *context,
                         const fmpz_mpoly_t curve);

#endif
