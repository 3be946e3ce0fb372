/* Query points that touch a curved solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_CURVED_CONTACT_H
#define GRAZE_GENERATE_CURVED_CONTACT_H

#include "questions/generate/generator.h"

/** As stratum_contact, of a solid with an atlas. The point is traced: it has a contact at the time,
 * with the primitive that is named, and no state that is undecided. */
graze_status curved_contact(int *made, sample *out, fmpq *normal, graze_context *context,
                            const struct graze_generator *g, graze_stratum stratum,
                            random_stream *r);

#endif
