/* The sides of a rational time of a motion.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_TIME_SIDES_H
#define GRAZE_CONTACT_TIME_SIDES_H

#include "questions/contact/site_record.h"

/**
 * Find the sides of t, but for their flows.
 * @param[out] side initialised; before t first
 * @return GRAZE_EINPUT the motion has no such time
 */
graze_status sides_find(site_side side[2], graze_context *context, const graze_motion *motion,
                        const fmpq_t t);

/** Do two different pieces meet between the sides? Two that are one rational function count as
 * one. */
int sides_break(const site_side side[2], const graze_motion *motion);

#endif
