/* Plane curves as squarefree, pairwise coprime polynomials.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_COPRIME_H
#define GRAZE_TOPO_COPRIME_H

#include "questions/topo/plane.h"

/** Add a curve to a list of squarefree, pairwise coprime polynomials, whose zeros are those of all
 * curves added. Small polynomials are factored, since factors without zeros near a point cost
 * little later. Of large ones, whose factors could take minutes, only common factors are split off;
 * a test modulo a prime excludes most of these.
 * @param[out] refused set to 1 if a polynomial with a common factor is beyond the context's limit
 * `bits`; else unchanged */
graze_status coprime_add(curve_list *parts, int *refused, graze_context *context,
                         const fmpz_mpoly_t curve);

#endif
