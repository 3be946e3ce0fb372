/* Points of a boundary at its edges and corners.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_FEATURE_H
#define GRAZE_BOUNDARY_FEATURE_H

#include "questions/boundary/tangent.h"

/** 1 if two tangent planes are known and more than about 18 degrees apart. */
int feature_between(const tangent *a, const tangent *b);

/**
 * Look for a corner or a point of an edge of the boundary strictly inside a cell: where two or
 * three of the tangent planes meet, nearest to a point of reference. It is taken only if it is
 * between two exactly classified points of the cell (sampling.h, feature).
 * @param[out] out   uninitialised; its numbers are set where *found is 1
 * @param reference  d rationals
 */
graze_status feature_find(feature *out, int *found, asker *a, const sample_cell *c,
                          const tangent *const *list, size_t count, const fmpq *reference);

#endif
