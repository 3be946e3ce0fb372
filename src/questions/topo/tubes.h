/* What a germ covers opposite to its leading directions, and along an edge.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_TUBES_H
#define GRAZE_TOPO_TUBES_H

#include "questions/topo/germ.h"

/** Set `tube` of a germ's sides and `covers_edge` (proofs/topology.md C52). */
graze_status tubes_find(germ *g, graze_context *context);

#endif
