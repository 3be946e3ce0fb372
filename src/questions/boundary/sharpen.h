/* The sharp edges and corners of a boundary, put into its surface.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_BOUNDARY_SHARPEN_H
#define GRAZE_BOUNDARY_SHARPEN_H

#include "questions/boundary/sampling.h"

/**
 * Give each cell with a feature (feature.h) a vertex there. The surface stays a manifold without
 * degenerate faces and without self-intersections, closed where it was; vertices that no face has
 * any more are gone.
 */
graze_status boundary_sharpen(graze_context *context, struct graze_boundary *b);

#endif
