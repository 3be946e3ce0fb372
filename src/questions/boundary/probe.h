/* Normals of a boundary from points of it that lie near one another.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_PROBE_H
#define GRAZE_BOUNDARY_PROBE_H

#include "questions/boundary/sampling.h"

/** 1 if a point lies strictly inside a cell of the level reached. */
int probe_in_cell(const struct graze_boundary *b, const sample_cell *c, const fmpq *point);

/**
 * Look on the line base + s way for the boundary by bisection, s from `low`, where the answer must
 * not be out, to `high`, where it must be.
 * @param[in,out] low, high shares; afterwards at most 2^-`bits` apart
 * @param[out] pmc at `low`; GRAZE_PMC_NONE where the answers at the ends are not those
 */
graze_status probe_line(fmpq_t low, fmpq_t high, graze_pmc *pmc, asker *a, const fmpq *base,
                        const fmpq *way, unsigned bits);

/**
 * Guess the normal at a point from boundary points 2^-7 of a cell beside it.
 * @param[out] out   d rationals
 * @param[out] found 0 where there is no such point
 * @param outside, inside two points near one another, one of them out and the other not
 */
graze_status probe_normal(fmpq *out, int *found, asker *a, const fmpq *outside, const fmpq *inside);

#endif
