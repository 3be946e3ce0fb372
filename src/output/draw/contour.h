/* Contours between points of a grid, found by bisection of exact classifications.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_CONTOUR_H
#define GRAZE_DRAW_CONTOUR_H

#include "output/draw/class_grid.h"

/** Parts of a pixel to which a contour's nodes are exact. */
enum { CONTOUR_FINENESS = 32 };

/**
 * Add the region of the points of the set (in or on) whose tone is `least` or one after it, as
 * closed polygons: marching squares between the cells' centres. A node is the middle of an interval
 * on a side, at most 1 / CONTOUR_FINENESS of a pixel long, of whose ends one is in the region. The
 * middle of a square of four nodes is classified to tell which are neighbours. Undecided points are
 * outside. Beyond the outermost centres lines go straight on to the frame.
 * @param scene NULL: the region of distances below `level`, interpolated between the centres
 */
graze_status contour_path(drawn_path *out, graze_context *context, const graze_scene *scene,
                          const cells *c, const panel *p, tone least, double level);

#endif
