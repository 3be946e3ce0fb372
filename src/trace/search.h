/* Which simplices a trajectory can meet, and when: a search of the solid's tree with pieces of the
 * curve. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_SEARCH_H
#define GRAZE_TRACE_SEARCH_H

#include "number/bernstein.h"
#include "solid/solid.h"
#include "trace/trajectory.h"

/** Windows of time are counted in units of 2^-SEARCH_LEVELS of a piece. */
enum { SEARCH_LEVELS = 24 };

/** The trajectory may meet the simplex within the closed window, and meets it in no time outside
 * its windows. */
typedef struct candidate {
    uint32_t simplex;
    uint32_t from, to;
} candidate;

typedef struct candidates {
    size_t count, capacity;
    candidate *item;
} candidates;

/**
 * All candidates, ordered by simplex and time; windows of one simplex do not touch each
 * other.
 * @param[out] out initialised to zero, or used before; freed by the caller
 */
graze_status search_candidates(candidates *out, graze_context *context, const graze_solid *solid,
                               const trajectory *c);

#endif
