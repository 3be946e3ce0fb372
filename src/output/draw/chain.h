/* Lines in which the boundary of a solid meets a plane, chained from triangle to triangle.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_CHAIN_H
#define GRAZE_DRAW_CHAIN_H

#include <stddef.h>
#include <stdint.h>
#include "output/draw/canvas.h"

/** A segment in pixels; each end lies on an edge, whose key the neighbouring triangle has too. */
typedef struct chain_segment {
    uint64_t key[2];
    double x[2], y[2];
} chain_segment;

/** Add segments as lines that go from one to the next, closed where they return to the first.
 * @param apart the least distance in pixels of two nodes of a line */
void chain_path(drawn_path *out, const chain_segment *segments, size_t count, double apart);

/** Add a line to a point, unless the point is nearer than `apart` to the node before it. */
void chain_to(drawn_path *out, double x, double y, double apart);

#endif
