/* The vertices of a boundary's surface, moved along their edges onto the boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_BISECT_H
#define GRAZE_BOUNDARY_BISECT_H

#include "questions/boundary/sampling.h"

/* The longest edge is sqrt(3) cells, so both points are within 2^-20 of a cell's longest side. */
enum { BISECT_BITS = 21 };

/** Set the places of all vertices. */
graze_status boundary_bisect(graze_context *context, struct graze_boundary *b);
/** How many vertices there are: those of the table, and features behind them. */
size_t bisect_count(const struct graze_boundary *b);
/** The two points of vertex `index`: the one that is out, and the other. d rationals each. */
void bisect_between(fmpq *outside, fmpq *inside, const struct graze_boundary *b, size_t index);
/** Vertex `index`, d rationals. */
void bisect_vertex(fmpq *out, const struct graze_boundary *b, size_t index);

#endif
