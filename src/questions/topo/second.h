/* Contacts that cover the directions of a plane from both sides, by terms of second order.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_SECOND_H
#define GRAZE_TOPO_SECOND_H

#include "questions/topo/plane_gap.h"

/** Does every direction of the plane across `normal` have a neighbourhood that the germs of the
 * point, in E^3, cover? Leading terms of the germs below and above the plane decide it
 * (proofs/topology.md C55). 0: not proved.
 * @param[out] gap initialised; set if these terms are seen to leave a gap */
graze_status second_covers(int *out, plane_gap *gap, germ_list *list, graze_context *context,
                           const fmpq *point, const fmpz *normal);

#endif
