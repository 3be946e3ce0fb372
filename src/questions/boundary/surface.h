/* The surface of a boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_SURFACE_H
#define GRAZE_BOUNDARY_SURFACE_H

#include "questions/boundary/sampling.h"

/** The surface between `out` and the rest at the level reached. */
graze_status boundary_surface(graze_context *context, struct graze_boundary *b);

#endif
