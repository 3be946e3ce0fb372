/* Vertices that are not convex: events of saddles, and what reaches them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_SADDLE_H
#define GRAZE_ENVELOPE_SADDLE_H

#include "questions/envelope/envelope_record.h"

/** `saddle` at a vertex, for all pairs of edges there that span no facet's plane (E^3). */
graze_status saddle_gather(graze_envelope *e, graze_context *context, size_t vertex);
/** Does a slice or a run reach the vertex, and does the velocity or its opposite lead into the
 * solid there? */
graze_status saddle_judge(graze_envelope *e, graze_context *context, size_t vertex);

#endif
