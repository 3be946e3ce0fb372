/* Events and findings of facets, edges and vertices, each by the speeds at its ends.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_GATHER_H
#define GRAZE_ENVELOPE_GATHER_H

#include "questions/envelope/envelope_record.h"

/** `reach` at a vertex of a facet, and `cusp` where the slice ends at it all the time. */
graze_status gather_corner(graze_envelope *e, graze_context *context, size_t facet, size_t vertex);
/** `theta` and `turn` where the slice of a facet ends on an edge in it; in E^2 the slice itself. */
graze_status gather_slice(graze_envelope *e, graze_context *context, size_t facet, size_t edge);
/** `meet` of two facets of an edge; whether a slice of either crosses it, if it is reflex. */
graze_status gather_meet(graze_envelope *e, graze_context *context, size_t edge, size_t first,
                         size_t second);

#endif
