/* Facets whose g vanishes all over.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_WHOLE_H
#define GRAZE_ENVELOPE_WHOLE_H

#include "questions/envelope/envelope_record.h"

/** Times at which g vanishes all over a facet: whether theta is negative there, or an edge or
 * corner of it reflex. */
graze_status gather_whole(graze_envelope *e, graze_context *context, size_t facet);

#endif
