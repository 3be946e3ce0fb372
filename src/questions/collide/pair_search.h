/* A search for the times at which two boundaries meet, in order of time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COLLIDE_PAIR_SEARCH_H
#define GRAZE_COLLIDE_PAIR_SEARCH_H

#include "questions/collide/pair_walk.h"

/** Walk through the whole motion or, if only the first contact is asked for, up to that. */
graze_status pair_search(pair_walk *walk);

#endif
