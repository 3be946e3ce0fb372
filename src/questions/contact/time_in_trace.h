/* Where the time of a site stands in the trace of its point.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_TIME_IN_TRACE_H
#define GRAZE_CONTACT_TIME_IN_TRACE_H

#include "questions/contact/site_record.h"

/**
 * From the trace of a site: `left`, `right` and `trim` of its facts, `near`, `near_in` and, if one
 * of them is t, `itself` (proofs/envelope.md C63).
 * @return GRAZE_EINTERNAL no contact of the trace holds t
 */
graze_status nearest_find(graze_site *site, graze_context *context);

/** The facts alone, without the times. */
graze_status nearest_trim(graze_site *site, graze_context *context);

#endif
