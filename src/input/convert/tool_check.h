/* Decides whether two polyhedra hold a tool between them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_TOOL_CHECK_H
#define GRAZE_CONVERT_TOOL_CHECK_H

#include "input/convert/tool_pair.h"

/**
 * Decide exactly whether the inner polyhedron is a convex part of the body, the body is a part of
 * the outer one, which is convex too, and no corner is further than `tolerance` from its partner:
 * then either is within `tolerance` of the body (proof in tool_check.c).
 * @param[out] square the largest square of the distance of partners
 */
int tool_pair_holds(fmpq_t square, const tool_pair *p, const tool *s, const fmpq_t tolerance);

#endif
