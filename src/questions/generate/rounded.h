/* Query points within an ulp of a contact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_ROUNDED_H
#define GRAZE_GENERATE_ROUNDED_H

#include "questions/generate/strata.h"

/**
 * Try once for the point of a contact whose coordinates become doubles next to them: those that are
 * none one of the two neighbours, the others perhaps the double before or behind. Among these
 * points one of a side that is drawn is taken, if there is one; the exact answer stands in the
 * sample.
 * @param[out] made 0 if this try made none
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status rounded_try(int *made, sample *out, graze_context *context,
                         const struct graze_generator *g, random_stream *r);

#endif
