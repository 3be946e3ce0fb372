/* Query points of one stratum.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_STRATA_H
#define GRAZE_GENERATE_STRATA_H

#include "base/number/random.h"
#include "graze/generate.h"
#include "questions/generate/special.h"

/** A decade of |s| and a side of which the scene has points. */
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
    size_t level_count, missing_count;
    level levels[MOST_LEVELS], missing[MOST_LEVELS]; /* tries found none of the missing ones */
};

/** One point and how it was made. */
typedef struct sample {
    graze_sample made;
    fmpq point[3];
    fmpq_t time;
} sample;

void sample_init(sample *s);
void sample_clear(sample *s);

/** The stream that the search for levels draws from: no row of a table has it. */
#define LEVEL_STREAM (UINT64_C(5) << 61)

/** Try once for a contact of a stratum; 0 if this try made none.
 * @param[out] normal d rationals, an outward normal of the moved facet; may be NULL */
int stratum_contact(sample *out, fmpq *normal, const struct graze_generator *g,
                    graze_stratum stratum, random_stream *r);

/** 1 unless the generator keeps to points that a double holds, and this is none. */
int sample_is_kept(const sample *s, const struct graze_generator *g);

/** Try once for a point of a stratum but `level`; 0 if this try made none. */
int stratum_try(sample *out, const struct graze_generator *g, graze_stratum stratum,
                random_stream *r);

#endif
