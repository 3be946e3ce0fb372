/* Tests whether a certain crossing is alone at its time: then the point is inside beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_ALONE_H
#define GRAZE_FILTER_ALONE_H

#include "decide/filter/meet.h"
#include "input/solid/solid.h"

/** Is it certain that no other simplex is met at the time of a certain crossing? Then the curve is
 * outside just before or after that time, and inside on the other side (proofs/membership.md C56).
 * @param at the window of the span in which meet_simplex found the crossing of `simplex`
 * @return 0 if that is not certain */
int crossing_is_alone(const curve *c, const span *piece, const graze_solid *solid, uint32_t simplex,
                      const meet_window *at);

#endif
