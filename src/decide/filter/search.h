/* The descent of a curve's spans through a solid's tree.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SEARCH_H
#define GRAZE_FILTER_SEARCH_H

#include "decide/filter/curve.h"
#include "decide/filter/findings.h"
#include "decide/filter/interior.h"
#include "input/solid/solid.h"

/** Conditions that end a search early: a time at which the curve is certainly in `state`, or a
 * certain crossing, which has both states beside it (proofs/membership.md C56, proofs/bricks.md
 * C86). */
typedef struct early_end {
    const interior *bricks; /* NULL: crossings alone */
    graze_state state;
    int met;
} early_end;

/** Find all certain crossings and candidates of a curve, unsorted.
 * @param early NULL: the search is complete; else `met` is set if it ends early
 * @return 0 without memory
 */
int search_curve(findings *out, early_end *early, curve *c, const graze_solid *solid);

#endif
