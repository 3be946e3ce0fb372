/* Stacks: the signs of surfaces on two vertical lines beside a point of the plane, so near the
 * point that all patterns near it occur on them. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CURVED_STACK_H
#define GRAZE_CURVED_STACK_H

#include "decide/curved/truth.h"

/** Decide the state in the plane at a time, or along a gap by its sample (proofs/curved.md C126,
 * C127).
 * @param[out] out I, B or O; UNDECIDED if the surfaces exceed the limit `work`
 * @param signs    signs of the surfaces that do not vanish there
 * @param surface  the surfaces through the point on which the expression depends: two or more, or
 * one singular one
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status stack_decide(graze_state *out, const expression *signs, const trajectory *c,
                          const size_t *surface, size_t count, algebraic *time);

#endif
