/* Contacts of order 4 or more within a facet: [AMS] singular trim points.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_SINGULAR_H
#define GRAZE_ENVELOPE_SINGULAR_H

#include "questions/envelope/envelope_record.h"

/** `singular` of a facet (E^3). */
graze_status singular_gather(graze_envelope *e, graze_context *context, size_t facet);

#endif
