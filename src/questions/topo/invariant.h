/* A direction of space on which what the contacts cover does not depend.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_INVARIANT_H
#define GRAZE_TOPO_INVARIANT_H

#include "questions/topo/germ.h"

/** 1 and a direction about the point that stays parallel to all planes of all contacts' cones, at
 * all times of their pieces; else 0. E^3; the list is bounded. */
int invariant_direction(fmpz *out, const germ_list *list);

/** A direction that is parallel to all of these planes but those across `step`, which stay where
 * they are and in which the trajectory of the point runs throughout their pieces: 1 if there are
 * such, and the direction crosses them; else 0, and `step` is 0 (proofs/topology.md C128). */
int invariant_beside_step(fmpz *out, fmpz *step, const germ_list *list, const fmpq *point);

#endif
