/* The greatest distance to the boundary over stretches of time (proofs/distance.md C72).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_GREATEST_H
#define GRAZE_DISTANCE_GREATEST_H

#include "questions/distance/time_search.h"

/** A stretch of one arc whose times [sure_from, sure_to] are certainly of a visit; none if
 * sure_from > sure_to. */
typedef struct stretch_of_time {
    size_t arc;
    double from, to, sure_from, sure_to;
} stretch_of_time;

/** @return GRAZE_ELIMIT, GRAZE_ECANCELED */
graze_status search_greatest(search *s, const stretch_of_time *stretch, size_t count);

#endif
