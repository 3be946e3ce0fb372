/* Bricks of space that are certainly inside the solid, or certainly outside it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_INTERIOR_H
#define GRAZE_FILTER_INTERIOR_H

#include "input/solid/solid.h"

/** A grid of equal bricks over the solid's box; `state` is NULL if there is none. */
typedef struct interior {
    int dimension;
    size_t count[3];
    double low[3], step[3];
    unsigned char *state; /* a graze_state for each brick; ABSENT: not certain */
} interior;

/** Gives the certain state of a brick that no simplex meets, by the brick's middle. */
typedef graze_state locate_function(void *data, const double middle[3]);

/** Lay one brick per simplex, or some thousands.
 * @param locate the state at a place in doubles, or ABSENT
 * @return 0 without memory */
int interior_make(interior *out, const graze_solid *solid, locate_function *locate, void *data);
void interior_clear(interior *m);

/** The state of all places of a box, or ABSENT if it is not certain (proofs/bricks.md C86). */
graze_state interior_state(const interior *m, const box *b);

#endif
