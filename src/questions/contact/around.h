/* The planes that decide what a solid is next to a boundary point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_AROUND_H
#define GRAZE_CONTACT_AROUND_H

#include "input/solid/planes.h"

/**
 * The planes of the simplices that meet a box around a point of d rationals, then the planes of the
 * box's sides, in which no simplex is counted. A ray from the point that has met none of them is
 * still in the box, where the boundary has no other simplices: so a cone made of this list
 * (questions/topo/cone.h) is that of the list of all planes, and is made in a time that does not
 * grow with the solid.
 * @param[out] out planes_clear after GRAZE_OK
 * @return GRAZE_ESYSTEM
 */
graze_status around_planes(plane_list *out, graze_context *context, const graze_solid *solid,
                           const fmpq *point);

#endif
