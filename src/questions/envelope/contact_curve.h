/* The contact points of all cells at one time: the curve of contact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_CONTACT_CURVE_H
#define GRAZE_ENVELOPE_CONTACT_CURVE_H

#include "questions/envelope/envelope_record.h"

/**
 * The curve at a time of the motion that is neither an end nor a break.
 * Its parts have no verdict and no chain.
 * @param[out] out uninitialised; contact_curve_clear after GRAZE_OK
 * @return GRAZE_EINPUT the time is not such a one
 */
graze_status contact_curve_find(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t);
/** contact_curve_find with the verdicts of all middles, and chains. */
graze_status contact_curve_make(graze_curve *out, graze_context *context, const graze_envelope *e,
                                const fmpq_t t);
void contact_curve_clear(graze_curve *c);

#endif
