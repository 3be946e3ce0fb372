/* The distance of the query point to the boundary at one instant.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_NEAREST_H
#define GRAZE_DISTANCE_NEAREST_H

#include "distance/foot.h"

/** low <= distance at the instant to the boundary below the nodes asked <= high. */
typedef struct nearest {
    double low, high;
    uint32_t simplex; /* one at which it is at most high, if `found` */
    int found;
} nearest;

/**
 * Search below some nodes of the solid's tree, leaving out what is certainly not nearer than
 * `limit`: then low is at most the limit, and high may be infinite.
 * @param visits counts the boxes and simplices asked
 */
void nearest_boundary(nearest *out, const stance *s, const uint32_t *node, size_t count,
                      double limit, size_t *visits);

#endif
