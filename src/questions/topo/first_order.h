/* The contacts of a trajectory to first order.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_FIRST_ORDER_H
#define GRAZE_TOPO_FIRST_ORDER_H

#include "decide/scene/scene.h"
#include "questions/topo/germ.h"

/** Find the germs of all contacts of a point (proofs/topology.md C46); edge_ways_find adds ways
 * along edges. */
graze_status germs_find(germ_list *list, graze_context *context, const graze_scene *scene,
                        const plane_list *planes, const fmpq *point);

/** Append the germ at a rational time u of a piece, at which the trajectory is on the boundary,
 * with its sides in that piece; without ways along edges. */
graze_status germs_at(germ_list *list, graze_context *context, const graze_scene *scene,
                      const plane_list *planes, const fmpq *point, size_t piece, const fmpq_t u);

#endif
