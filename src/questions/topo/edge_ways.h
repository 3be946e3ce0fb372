/* Cover by a germ of the direction opposite to a leading direction, and of those along an edge.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_EDGE_WAYS_H
#define GRAZE_TOPO_EDGE_WAYS_H

#include "questions/topo/germ.h"

/** Set `edge_way` of a germ's sides and `covers_edge` (proofs/topology.md C52). */
graze_status edge_ways_find(germ *g, graze_context *context);

#endif
