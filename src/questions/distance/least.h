/* The least distance to the boundary over the whole motion (proofs/distance.md C71).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_LEAST_H
#define GRAZE_DISTANCE_LEAST_H

#include "questions/distance/time_search.h"

/** @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status search_least(search *s);

#endif
