/* T-junctions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_MEND_SPLIT_H
#define GRAZE_MEND_SPLIT_H

#include "input/mend/mesh.h"

/** Split edges that an odd number of facets have at the ends of other such edges in their middle.
 * Facets keep their points. */
graze_status split_edges(mesh *m);

/** The ends of edges that an odd number of facets have, malloc'ed, each once. */
graze_status split_open_ends(uint32_t **out, size_t *count, mesh *m);

#endif
