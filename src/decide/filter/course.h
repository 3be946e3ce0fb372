/* All pieces of a motion in doubles, under a tree in time, which carry query points in the filter.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_COURSE_H
#define GRAZE_FILTER_COURSE_H

#include <stdint.h>
#include "decide/filter/carrier.h"

/** Successive pieces. If `bounded`, each of their maps P -> A P + b is, entry by entry,
 * a mean of matrices first + s (last - first) + R with s in [0, 1] and |R| <= off (proofs/filter.md
 * C34); entry (i, j) stands at i (d + 1) + j, the translation at j = d. */
typedef struct piece_group {
    uint32_t child; /* groups at child and child + 1; 0: one piece, and nothing below is set */
    uint32_t piece; /* the first */
    int bounded;
    double first[POINT_MAP_ENTRIES], last[POINT_MAP_ENTRIES], off[POINT_MAP_ENTRIES];
} piece_group;

typedef struct course {
    int dimension, degree; /* the largest of any piece */
    size_t piece_count, group_count;
    carrier *piece;
    piece_group *group; /* group 0 is the whole motion */
} course;

/** Convert the point maps that carry query points; 0 if memory runs out. */
int course_make(course *out, const graze_motion *motion, graze_operation operation);
void course_clear(course *c);

#endif
