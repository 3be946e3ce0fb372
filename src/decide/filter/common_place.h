/* Tests whether the common points of two simplices of the boundary can be on a thick chord.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_COMMON_PLACE_H
#define GRAZE_FILTER_COMMON_PLACE_H

#include "decide/filter/curve.h"
#include "input/solid/solid.h"

/**
 * @param wide a bounded span, widened by the cell (point_box_widen); its set is tested
 * @return 0 if it is certain that no place of the set is on both closed simplices
 * (proofs/judging.md C116) */
int common_place_is_near(const graze_solid *solid, const span *wide, uint32_t a, uint32_t b);

/** @return 0 if it is certain that b has no point in the relative interior of a (proofs/judging.md
 * C116) */
int may_rest_inside(const graze_solid *solid, uint32_t a, uint32_t b);
/** Find the corners of b that are corners of a too, as a mask; 0 unless it is certain that the
 * common points of both closed triangles are in the convex hull of these corners. */
int common_corners(unsigned *of_b, const graze_solid *solid, uint32_t a, uint32_t b);

#endif
