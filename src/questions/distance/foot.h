/* The place of a simplex nearest to the query point at an instant, and the direction between them:
 * good guesses, which the bounds of gap.h make certain. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_FOOT_H
#define GRAZE_DISTANCE_FOOT_H

#include "questions/distance/window.h"

/** The solid at an instant, seen from the query point. */
typedef struct stance {
    window at;   /* the instant */
    double c[3]; /* the trajectory */
    int rigid, dimension;
    double linear[9]; /* the placing map's linear part, if not rigid */
} stance;

/** 0 if the weight is not certainly positive. */
int stance_make(stance *out, const point_arc *of, double time);

typedef struct foot {
    double q[3]; /* nearest place, in the solid: within the corners' error and rounding of one */
    double m[3]; /* covector of the direction from there to the point, in the solid */
    int inner;   /* in the relative interior of the simplex */
} foot;

/** @param corner the simplex's d corners */
void foot_find(foot *out, const stance *s, const double *corner);

/** The squared distance of the trajectory to a box, in the solid; g points from the box to it. */
double foot_of_box(double *g, const stance *s, const box *b);

#endif
