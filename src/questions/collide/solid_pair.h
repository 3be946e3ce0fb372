/* A moving solid and a fixed one. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_COLLIDE_SOLID_PAIR_H
#define GRAZE_COLLIDE_SOLID_PAIR_H

#include "input/motion/motion.h"
#include "input/solid/solid.h"

/** Two solids and the motion of `moving`, all borrowed, of one dimension; `fixed` does not move. */
typedef struct solid_pair {
    const graze_solid *moving, *fixed;
    const graze_motion *motion;
    int complement; /* 1: the closure of its complement takes the place of `fixed` */
} solid_pair;

/** A simplex of each boundary that may meet. */
typedef struct near_pair {
    uint32_t moving, fixed;
} near_pair;

typedef struct near_list {
    size_t count, capacity;
    near_pair *item;
} near_list;

#endif
