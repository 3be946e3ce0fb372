/* The corners of all simplices in doubles, for filters.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SOLID_CORNERS_H
#define GRAZE_SOLID_CORNERS_H

#include "input/soup/soup.h"
#include "input/validate/simplices.h"

/**
 * `at` holds d corners of d coordinates for each simplex, in the order of its vertices. Each
 * differs from the exact coordinate by at most `error`, which is 0 if all coordinates are doubles;
 * none is larger than `reach` in absolute value. `at` is NULL if a coordinate is beyond
 * CORNER_REACH: then there is no filter.
 */
typedef struct corners {
    double *at;
    double error, reach;
    double axis_reach[3]; /* the same for each coordinate alone */
} corners;

/** Beyond it products of coordinates might leave the range of doubles (proofs/filter.md C32). */
#define CORNER_REACH 0x1p200

/** @param low, high bounds of all coordinates of the soup's vertices */
graze_status corners_make(corners *out, graze_context *context, const soup *s, const simplices *cut,
                          const double *low, const double *high);
void corners_clear(corners *c);

#endif
