/* Triangles and lines as pixels, for meshes so dense that their paths would be a large file.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_RASTER_H
#define GRAZE_DRAW_RASTER_H

#include "output/draw/panel.h"

/** The pixels of a panel's frame. Zeroed by raster_init where memory is short. */
typedef struct raster {
    int width, height;
    unsigned *pixel; /* a paint, or 0 */
} raster;

/** Pixels of a frame, all empty; 0 without memory. */
int raster_init(raster *r, const panel *p);
void raster_clear(raster *r);
/** Paint the pixels whose centres a triangle holds, which is given in pixels from the frame's upper
 * left corner. */
void raster_triangle(raster *r, const double x[3], const double y[3], unsigned paint,
                     double faintness);
void raster_line(raster *r, const double from[2], const double to[2], unsigned paint,
                 double faintness);
/** Draw the pixels as runs of one colour; shades are merged until the runs are few. */
void raster_draw(canvas *c, const raster *r, const panel *p);

#endif
