/* Shapes of space as the onlooker sees them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_SHAPE_PAINT_H
#define GRAZE_DRAW_SHAPE_PAINT_H

#include "output/draw/shape.h"

/** Paint of the faces of a shape. */
typedef struct finish {
    unsigned colour; /* 0xRRGGBB, in full light */
    double faintness;
    int edges; /* draw the boundary's edges, of a dense mesh the sharp ones */
} finish;

/** Paint the faces of shapes in E^3 that are turned towards the onlooker, the far ones first. */
graze_status shapes_paint(canvas *c, graze_context *context, const shape *shapes,
                          const finish *finishes, size_t count, const panel *p);

#endif
