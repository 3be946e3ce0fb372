/* The boundary of a curved solid of space, as triangles made for the eye (eye_solid.h).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_EYE_SURFACE_H
#define GRAZE_DRAW_EYE_SURFACE_H

#include "input/solid/solid.h"

/** Add vertices and triangles to an empty solid of space, outer sides counterclockwise. */
graze_status eye_surface_make(graze_solid *out, graze_context *context, const csg *solid);

#endif
