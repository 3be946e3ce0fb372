/* The pairs of a time and a place that the search for the least distance begins with.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_LEAST_BEGIN_H
#define GRAZE_DISTANCE_LEAST_BEGIN_H

#include "questions/distance/time_search.h"

/**
 * Put aside what a search begins with, each pair with a bound, the nearest first: whole arcs with
 * the whole boundary, of many only those that are nearer than a distance that is reached.
 * @return GRAZE_ELIMIT, GRAZE_ESYSTEM
 */
graze_status least_begin(search *s);

#endif
