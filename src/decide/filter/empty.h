/* Tests whether a box of space is free of the boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_EMPTY_H
#define GRAZE_FILTER_EMPTY_H

#include "input/solid/solid.h"

/**
 * @param[in,out] tests bound of the number of simplices to test; what remains of it
 * @return 0 if some simplex may meet the box, or `tests` do not suffice (proofs/bricks.md C87) */
int box_is_empty(const graze_solid *solid, const box *b, size_t *tests);

#endif
