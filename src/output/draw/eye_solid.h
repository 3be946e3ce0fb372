/* The boundary of a curved solid, as segments or triangles made for the eye.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Made in doubles: a picture of the solid decides nothing.
 */
#ifndef GRAZE_DRAW_EYE_SOLID_H
#define GRAZE_DRAW_EYE_SOLID_H

#include "input/solid/solid.h"

/**
 * Fill a solid that stands for a curved one in pictures (shape.h, shown_edges.h) and nowhere else:
 * its vertices' bounds and its simplices are set, segments in the plane, triangles in space. What
 * is narrower than a cell of the lattice, a 256th of the box in the plane and a 64th in space, may
 * be missed. Cleared by eye_solid_clear, also on failure.
 * @param solid with a box
 */
graze_status eye_solid_make(graze_solid *out, graze_context *context, const csg *solid);
void eye_solid_clear(graze_solid *made);

#endif
