/* The distance of the query point to the boundary at one instant.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_NEAREST_H
#define GRAZE_DISTANCE_NEAREST_H

#include "questions/distance/foot.h"

/** low <= distance at the instant to the boundary below the nodes asked <= high. */
typedef struct nearest {
    double low, high;
    uint32_t simplex; /* one at which it is at most high, if `found` */
    int found;
} nearest;

/** State of a place in a window of time. */
typedef enum place_state {
    PLACE_NEW,  /* nothing: its bound is that of a longer window */
    PLACE_SEEN, /* the middle of the window has been asked; the bound is that of a larger place */
    PLACE_BOUNDED,
    PLACE_SMALL /* bounded, and no larger than the window */
} place_state;

/** A node of the solid's tree; no simplex below it is nearer than low at the times looked at. */
typedef struct place {
    uint32_t node;
    place_state state;
    double low;
} place;

/**
 * Search below some nodes of the solid's tree, leaving out what is certainly not nearer than
 * `limit`: then low is at most the limit, and high may be infinite.
 * @param visits counts the boxes and simplices asked
 */
void nearest_boundary(nearest *out, const stance *s, const place *list, size_t count, double limit,
                      size_t *visits);

#endif
