/* The descent of a curve's spans through a solid's tree.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SEARCH_H
#define GRAZE_FILTER_SEARCH_H

#include "filter/curve.h"
#include "filter/findings.h"
#include "solid/solid.h"

/**
 * Find all certain crossings and candidates of a curve; not sorted yet.
 * @param[out] crosses NULL; or 1 if a crossing was found beside which the curve is certainly inside
 * and outside (proofs/membership.md C56): the search ends there. Else 0, and all is found
 * @return 0 without memory
 */
int search_curve(findings *out, int *crosses, curve *c, const graze_solid *solid);

#endif
