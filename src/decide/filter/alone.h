/* Whether a certain crossing is the only contact near it, which proves that the point is inside
 * beside it. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_ALONE_H
#define GRAZE_FILTER_ALONE_H

#include "decide/filter/meet.h"
#include "input/solid/solid.h"

/**
 * Whether no other simplex is met at the time of a certain crossing: then the curve is outside on
 * one side of that time and inside on the other (proofs/membership.md C56).
 * @param at where in the span meet_simplex found the crossing of `simplex`
 * @return 0 if that is not certain
 */
int crossing_is_alone(const curve *c, const span *piece, const graze_solid *solid, uint32_t simplex,
                      const meet_window *at);

#endif
