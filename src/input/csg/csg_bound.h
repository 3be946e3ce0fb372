/* Boxes that hold the nodes of a curved solid (proofs/curved.md C102).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CSG_CSG_BOUND_H
#define GRAZE_CSG_CSG_BOUND_H

#include "input/csg/csg_reader.h"

/** At least the root of a number that is not negative: the root itself if it is rational. */
void csg_upper_root(fmpq_t out, const fmpq_t value);

/**
 * Let the reader's box hold, beside what it holds, the sum of a disk and a ball.
 * @param point the centre of the disk, in the frame of the node at hand
 * @param axis  normal to the disk; unused if `disk` is 0
 * @param ball  radius of the ball, 0 or more
 * @param disk  the square of the disk's radius
 */
void csg_bound_round(csg_reader *r, const fmpq *point, const fmpq *axis, const fmpq_t ball,
                     const fmpq_t disk);

/** Likewise the box with these opposite corners, in the frame of the node at hand. */
void csg_bound_corners(csg_reader *r, const fmpq *low, const fmpq *high);

/** Let the box of some nodes be that of their union, or intersection, with another node. Where two
 * boxes have no interior in common the intersection is empty, and the first stays. */
void csg_bound_union(csg_box *box, const csg_box *other);
void csg_bound_intersection(csg_box *box, const csg_box *other);

#endif
