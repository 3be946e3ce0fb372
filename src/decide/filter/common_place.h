/* Whether places that two simplices of the boundary share can be on a thick chord.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_COMMON_PLACE_H
#define GRAZE_FILTER_COMMON_PLACE_H

#include "decide/filter/curve.h"
#include "input/solid/solid.h"

/**
 * @param wide a bounded span; its set counts, made as thick as the cell (point_box_widen)
 * @return 0 if certainly no place of the set is on both closed simplices (proofs/judging.md C116)
 */
int common_place_is_near(const graze_solid *solid, const span *wide, uint32_t a, uint32_t b);

/** @return 0 if certainly no place inside a, off its sides, is on b (proofs/judging.md C116) */
int may_rest_inside(const graze_solid *solid, uint32_t a, uint32_t b);
/** The corners of b that a has too, as a mask; 0 unless certainly all common places of both closed
 * triangles are among these corners and between them. */
int common_corners(unsigned *of_b, const graze_solid *solid, uint32_t a, uint32_t b);

#endif
