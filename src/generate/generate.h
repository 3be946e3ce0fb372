/* Query points made to be degenerate: a body point y and a rational time are chosen, and P = M(t)
 * y. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_GENERATE_H
#define GRAZE_GENERATE_GENERATE_H

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

void sample_init(sample *s);
void sample_clear(sample *s);

/** Make a generator; `out` is cleared by generator_clear in either case. */
graze_status generator_make(struct graze_generator *out, graze_context *context,
                            const graze_scene *scene, uint64_t seed, const unsigned long *weights,
                            int representable);
void generator_clear(struct graze_generator *g);

/** The point of one row; it depends on generator and row alone. */
void generator_sample(sample *out, const struct graze_generator *g, uint64_t row);

/** Try once for a point of a stratum; 0 if this try brought none (strata.c). */
int stratum_try(sample *out, const struct graze_generator *g, graze_stratum stratum,
                random_stream *r);

#endif
