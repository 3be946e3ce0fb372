/* A generator, and one point and how it was made.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_GENERATOR_H
#define GRAZE_GENERATE_GENERATOR_H

#include "base/number/random.h"
#include "graze/generate.h"
#include "questions/generate/atlas.h"
#include "questions/generate/special.h"

/** A decade of |s| and a side in which the scene has points. */
typedef struct level {
    int decade, outward;
} level;

enum { MOST_LEVELS = 20 };

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
    atlas *atlas; /* of a curved solid; else NULL */
    size_t level_count, missing_count;
    level levels[MOST_LEVELS], missing[MOST_LEVELS]; /* tries found none of the missing ones */
};

/** One point and how it was made. */
typedef struct sample {
    graze_sample made;
    fmpq point[3];
    fmpq_t time;
    unsigned undecided; /* points that were tried and have no answer */
} sample;

void sample_init(sample *s);
void sample_clear(sample *s);

/** The name and the default weight of a stratum; NULL and 0 of none. */
const char *stratum_name(graze_stratum stratum);
unsigned long stratum_weight(graze_stratum stratum);

/** A time for a contact of a stratum; NULL if there is none. */
const instant *stratum_instant(const struct graze_generator *g, graze_stratum stratum,
                               random_stream *r);

/** Whether a contact of this order belongs to the stratum. */
int stratum_takes_order(graze_stratum stratum, int order);

/** 1 unless the generator keeps to points that a double holds, and this is none. */
int sample_is_kept(const sample *s, const struct graze_generator *g);

#endif
