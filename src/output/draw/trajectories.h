/* The panel of trajectories.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_TRAJECTORIES_H
#define GRAZE_DRAW_TRAJECTORIES_H

#include "output/draw/views.h"

/** Draw the trajectories through the standing S. */
graze_status view_trajectories(canvas *c, graze_context *context, const picture *p);
/** Note in the legend what it shows; after views_fit. */
void trajectories_seen(picture *p);

#endif
