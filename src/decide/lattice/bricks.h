/* The bricks of a grid; each is decided once, when one of its points is first asked for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_LATTICE_BRICKS_H
#define GRAZE_LATTICE_BRICKS_H

#include <pthread.h>
#include "decide/lattice/brick.h"

/** A brick; once decided it has one membership for all points, or one for each point. */
typedef struct brick_state {
    int busy;             /* a thread is deciding it */
    unsigned char common; /* 0: see pmc */
    unsigned char *pmc;   /* NULL: not decided, or `common` */
} brick_state;

/** All bricks, shared by threads. Bricks far before the last one asked for are freed. */
typedef struct bricks {
    const graze_scene *scene; /* borrowed */
    const lattice *lattice;
    size_t side, count[3];
    pthread_mutex_t lock;
    pthread_cond_t changed;
    size_t kept; /* bricks before this one, along the last axis, are freed */
    brick_state *state;
} bricks;

/** @return 0 without memory; bricks_clear in any case */
int bricks_make(bricks *out, const graze_scene *scene, const lattice *l);
void bricks_clear(bricks *b);

/**
 * Give the memberships of a point and of the points after it in its row of a brick, at most `most`.
 * @param[out] pmc   as of brick_decide
 * @param[out] count the number of points
 * @return as brick_decide
 */
graze_status bricks_row(unsigned char *pmc, size_t *count, graze_context *context, bricks *b,
                        size_t index, size_t most);

#endif
