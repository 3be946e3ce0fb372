/* The state of the trajectory at a moment, by the surfaces through its point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_STATE_H
#define GRAZE_CURVED_STATE_H

#include "decide/curved/sign_germ.h"

/** A point c(u) of a trajectory, and the expression over the surfaces there. */
typedef struct state_query {
    const csg *solid;
    const trajectory *c;
    const size_t *surface; /* surfaces through the point on which the expression depends */
    int count;             /* at most CSG_FREE_MOST */
    pattern_set truth;     /* the expression over their signs */
    int near_in, near_out; /* the interior, and the exterior, come arbitrarily near */
} state_query;

/** Decide the state at a time, or on the part of a gap around the sample in which the polynomials
 * that the field keeps have no root (proofs/curved.md C100).
 * @param[out] out I, B, O, or GRAZE_STATE_UNDECIDED if no rule decides */
graze_status state_decide(graze_state *out, const state_query *at, moment_field *f);

#endif
