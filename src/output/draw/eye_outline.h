/* The boundary of a curved solid of the plane, as segments made for the eye (eye_solid.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_EYE_OUTLINE_H
#define GRAZE_DRAW_EYE_OUTLINE_H

#include "input/solid/solid.h"

/** Add vertices and segments to an empty solid of the plane. */
graze_status eye_outline_make(graze_solid *out, graze_context *context, const csg *solid);

#endif
