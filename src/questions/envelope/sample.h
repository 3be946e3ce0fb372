/* Single contact points spread over times and cells.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_SAMPLE_H
#define GRAZE_ENVELOPE_SAMPLE_H

#include "questions/contact/site.h"
#include "questions/envelope/envelope_record.h"

/**
 * Contact `index` of a seed: a time in one gap between events after another, and there a part of
 * the curve and a point of it, chosen by chance.
 * @param[out] out uninitialised; site_clear after GRAZE_OK and *found
 * @param found    0: there is no contact at that time
 */
graze_status sample_make(graze_site *out, int *found, graze_context *context,
                         const graze_envelope *e, unsigned long seed, unsigned long index);

#endif
