/* Second order: contacts that close on both sides of a plane through the point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SECOND_H
#define GRAZE_TOPO_SECOND_H

#include "questions/topo/thin_gap.h"

/** Do the germs of a point of E^3 cover every direction of the plane across `normal`, with a
 * neighbourhood, by the leading terms of what they cover below and above it (proofs/topology.md
 * C55)? 0 says nothing.
 * @param[out] gap initialised; one that is left by these terms, if one is seen
 */
graze_status second_covers(int *out, plane_gap *gap, germ_list *list, graze_context *context,
                           const fmpq *point, const fmpz *normal);

#endif
