/* Bounds of the distance to convex sets along a covector (proofs/distance.md C69).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_ALONG_H
#define GRAZE_DISTANCE_ALONG_H

#include "input/solid/tree.h"
#include "questions/distance/window.h"

/**
 * A distance that no place of a convex set comes below during the window: that along the covector
 * m. 0 if m says nothing.
 * @param m    3 numbers in the solid's space, any
 * @param most at least m . v for all places v of the set, but for the stray
 */
double gap_along(const window *w, const double *m, double most);

/** The greatest m . v of a box, or of `count` corners of d coordinates. */
double gap_box(const double *m, const box *b);
double gap_corners(const double *m, const double *corner, int count, int dimension);

#endif
