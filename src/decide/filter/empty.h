/* Whether a box of space holds no part of the boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_EMPTY_H
#define GRAZE_FILTER_EMPTY_H

#include "input/solid/solid.h"

/**
 * @param[in,out] tests how many simplices may be looked at, and how many of those are left
 * @return 0 if some simplex may meet the box, or `tests` do not suffice (proofs/bricks.md C87)
 */
int box_is_empty(const graze_solid *solid, const box *b, size_t *tests);

#endif
