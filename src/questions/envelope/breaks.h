/* Contact on one side of a break of the motion, and the solid's interior on the other.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_BREAKS_H
#define GRAZE_ENVELOPE_BREAKS_H

#include "questions/envelope/envelope_record.h"

/** Look at the break at the beginning of a piece (proofs/events.md C83). */
graze_status breaks_judge(graze_envelope *e, graze_context *context, size_t piece);

#endif
