/* The boundary of a curved solid of the plane, as segments made for the eye.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Made in doubles: a picture of the solid decides nothing.
 */
#ifndef GRAZE_DRAW_EYE_OUTLINE_H
#define GRAZE_DRAW_EYE_OUTLINE_H

#include "input/solid/solid.h"

/**
 * Fill a solid of segments that stands for a curved one in shapes (shape.h) and nowhere else: its
 * vertices' bounds and its simplices are set. Features narrower than a 256th of the box may be
 * missed. Cleared by outline_clear, also on failure.
 * @param solid of the plane, with a box
 */
graze_status outline_make(graze_solid *out, graze_context *context, const csg *solid);
void outline_clear(graze_solid *outline);

#endif
