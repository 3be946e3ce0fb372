/* Query points of one stratum.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_STRATA_H
#define GRAZE_GENERATE_STRATA_H

#include "graze/generate.h"
#include "generate/random.h"
#include "generate/special.h"

struct graze_generator {
    const graze_scene *scene;
    uint64_t seed;
    int representable;                         /* keep to points that a double holds */
    unsigned long weight[GRAZE_STRATUM_COUNT]; /* 0 where the scene has no such point */
    unsigned long total;
    fmpq low[3], high[3]; /* the box of the random stratum */
    size_t instant_count; /* times that most strata draw from */
    instant *instants;
    size_t joint_count; /* t0, the break points, t1 */
    instant *joints;
    specials special;
};

/** One point and how it was made. */
typedef struct sample {
    graze_sample made;
    fmpq point[3];
    fmpq_t time;
} sample;

/** Try once for a point of a stratum; 0 if this try made none. */
int stratum_try(sample *out, const struct graze_generator *g, graze_stratum stratum,
                random_stream *r);

#endif
