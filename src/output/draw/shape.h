/* The solid at one time, as lines and faces of a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Its vertices are doubles: a picture of the solid decides nothing.
 */
#ifndef GRAZE_DRAW_SHAPE_H
#define GRAZE_DRAW_SHAPE_H

#include "input/motion/motion.h"
#include "input/solid/solid.h"
#include "output/draw/panel.h"

/** The images of the solid's vertices, three coordinates each. The solid is borrowed. */
typedef struct shape {
    const graze_solid *solid;
    double *at;
    int reflected; /* the map turns the boundary inside out */
} shape;

/** The solid where it stands. Cleared by shape_clear, also on failure. */
graze_status shape_standing(shape *out, graze_context *context, const graze_solid *solid);
/** The solid at a time of the motion, t0 <= t <= t1, or under the inverse of the map of that time.
 */
graze_status shape_moved(shape *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, const fmpq_t t, int inverse);
void shape_clear(shape *s);

/** The extent of the shape's image. */
void shape_extent(extent *out, const shape *s, const projection *look);

/** Add the boundary in E^2, ring by ring. */
void shape_rings(drawn_path *out, const shape *s, const panel *p);
/** Add the lines in which the boundary meets the plane normal . x = place (E^3). */
void shape_slice(drawn_path *out, const shape *s, const panel *p, const double normal[3],
                 double place);

#endif
