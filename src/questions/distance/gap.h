/* Bounds of the distance between the query point and places of the moving solid over a window
 * (proofs/distance.md C69, C70). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_GAP_H
#define GRAZE_DISTANCE_GAP_H

#include "questions/distance/window.h"

/**
 * A distance that no place of a simplex comes below during the window, from a place of it that
 * moves from q0 to q1, linearly in the solid. Exact where that is the nearest place all the time.
 */
double gap_about(const window *w, const double *q0, const double *q1, const double *corner,
                 int count);

/** A distance that the place that moves from q0 to q1 during the window, linearly in the solid,
 * never exceeds. */
double gap_most(const window *w, const double *q0, const double *q1);

#endif
