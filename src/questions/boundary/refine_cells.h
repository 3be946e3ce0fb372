/* The cells of a boundary, level by level.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_REFINE_CELLS_H
#define GRAZE_BOUNDARY_REFINE_CELLS_H

#include "questions/boundary/sampling.h"

/** Points that are asked at least: `contacts` points and the corners of the coarse level. */
unsigned long long boundary_least_points(const struct graze_boundary *b, unsigned long contacts);

/** Refuse a budget that does not suffice for `contacts` points and all cells of the coarse level.
 */
graze_status boundary_refuse_budget(graze_context *context, const struct graze_boundary *b,
                                    unsigned long contacts);
/** Cut the box, level by level. */
graze_status boundary_refine(graze_context *context, struct graze_boundary *b);

#endif
