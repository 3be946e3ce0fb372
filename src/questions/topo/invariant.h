/* A direction of E^3 along which the cover by the contacts is invariant.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_INVARIANT_H
#define GRAZE_TOPO_INVARIANT_H

#include "questions/topo/germ.h"

/** Find a direction about the point that is parallel to all planes of all contacts' cones at all
 * times of their pieces; 0 if there is none. E^3; the list is bounded. */
int invariant_direction(fmpz *out, const germ_list *list);

/** Find a direction parallel to all of these planes but the ones with the normal `step`, which do
 * not move and contain the trajectory throughout their pieces. Returns 1 if there are such planes
 * and the direction crosses them, else 0 with a zero `step` (proofs/topology.md C128). */
int invariant_beside_step(fmpz *out, fmpz *step, const germ_list *list, const fmpq *point);

#endif
