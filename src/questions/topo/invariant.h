/* A direction of space on which what the contacts cover does not depend.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_INVARIANT_H
#define GRAZE_TOPO_INVARIANT_H

#include "questions/topo/germ.h"

/** 1 and a direction about the point that stays parallel to all planes of all contacts' cones, at
 * all times of their pieces; else 0. E^3; the list is bounded. */
int invariant_direction(fmpz *out, const germ_list *list);

#endif
