/* generate: query points by stratum, degenerate by construction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_GENERATE_H
#define GRAZE_QUESTIONS_GENERATE_H

#include <flint/fmpq_mpoly.h>
#include "base/context/context.h"
#include "base/number/random.h"
#include "decide/bounds/bounds.h"
#include "decide/scene/scene.h"
#include "graze/generate.h"
#include "input/csg/csg.h"
#include "input/validate/validate.h"

/** The points origin + s_0 direction[0] + s_1 direction[1] + ...; the parameter s_j is the
 * coordinate axis[j] of the point. */
typedef struct flat {
    int dimension, count; /* `dimension` of space, `count` of parameters */
    int axis[3];
    fmpq *origin, *direction[3]; /* one array of 12, borrowed by `direction` */
} flat;

/** The polynomial whose value at start + v is v' form v + slope . v + value. All members are in one
 * array. */
typedef struct quadratic {
    int count; /* of variables */
    fmpq *start, *slope, *value, *form;
} quadratic;

/** Points of a flat. If `bent`, the zeros of `curve` in the flat: points are found as second zeros
 * on lines through the start of `curve`, itself a zero. */
typedef struct chart {
    flat place;
    int bent;
    int isolated;    /* the chart is a singular point of the zeros */
    quadratic curve; /* in the parameters of the flat; only if bent */
    size_t mark;     /* number of the surface or instant that the chart was made of */
} chart;

typedef struct charts {
    graze_context *context;
    const fmpq_mpoly_ctx_struct *ring; /* of the coordinates */
    int dimension;
    size_t count, capacity, mark; /* mark: given to charts that are appended from now on */
    chart *item;
} charts;

/** Number of derivatives of pullbacks by u: those of order 1 and 2. */
enum { INSTANT_DERIVATIVES = 2 };

typedef struct instant {
    int dimension;
    size_t piece;
    fmpq_t u, t;
    fmpz *map, *inverse; /* positive multiples of M and of the tracing map (N, W) at u: (d + 1) *
                            (d + 1), the weight's row last */
    /* The derivatives of order 1 and 2 of (N, W) at u, times M at u and a positive number each: (d
     * + 1) * (d + 1) integers that are applied to body points. */
    fmpz *carried[INSTANT_DERIVATIVES];
    int bounded;         /* `velocity` is set */
    double velocity[16]; /* carried[0] times a positive number, each entry with a relative error of
                            at most 2^-52 */
} instant;

/** Charts of the surfaces of a solid (`faces`) and of their intersections (`edges`, `vertices`).
 * Not all of their points are on the solid's boundary. */
typedef struct atlas {
    const csg *solid;
    fmpq_mpoly_ctx_t ring;
    charts faces, edges, vertices;
    charts touches; /* points of surfaces where the normal velocity is zero at an instant; `mark` is
                       the number of the instant */
} atlas;

/** A simplex all of whose points have the normal velocity zero at `when`; if `slides`, at all times
 * of the piece. */
typedef struct special {
    instant when;
    size_t simplex;
    int slides;
} special;

typedef struct specials {
    size_t count, capacity;
    special *item;
} specials;

/* A generator, and one point with the way in which it was made. */

/** A decade of |s| and a side, outside or inside. */
typedef struct level {
    int decade, outward;
} level;

enum { MOST_LEVELS = 20 };

struct graze_generator {
    const graze_scene *scene;
    uint64_t seed;
    int representable;                         /* make only points whose coordinates are doubles */
    unsigned long weight[GRAZE_STRATUM_COUNT]; /* 0 where the scene has no such point */
    unsigned unrepresentable; /* set of 1 << stratum: it has points, but none of doubles */
    unsigned long total;
    fmpq *low, *high;     /* the box of the random stratum, one array of 6 */
    size_t instant_count; /* number of times from which most strata draw */
    instant *instants;
    size_t joint_count; /* number of times at which pieces begin or end: t0, the break points, t1 */
    instant *joints;
    specials special;
    atlas *atlas; /* of a curved solid; else NULL */
    size_t level_count, missing_count;
    level levels[MOST_LEVELS], missing[MOST_LEVELS]; /* `missing`: no try found them */
};

/** One point and the way in which it was made. */
typedef struct sample {
    graze_sample made;
    fmpq *point, *time; /* one array of 4 */
    unsigned undecided; /* number of points that were tried but have no answer */
    int alone;          /* 1: the stratum is asked for, the point is not */
    int unkept;         /* 1: a point that was tried is left out for its coordinates */
} sample;

void sample_init(sample *s);
void sample_clear(sample *s);

/** The name and the default weight of a stratum; NULL and 0 for an unknown one. */
const char *stratum_name(graze_stratum stratum);
unsigned long stratum_weight(graze_stratum stratum);

/* Query points made to be degenerate: a body point y and a rational time are chosen, and P = M(t)
 * y. */

/** Make a generator; the caller clears `out` by generator_clear, on failure too. */
graze_status generator_make(struct graze_generator *out, graze_context *context,
                            const graze_scene *scene, uint64_t seed, const unsigned long *weights,
                            unsigned flags);
void generator_clear(struct graze_generator *g);

/** Make the point of one row; the point depends only on the generator and the row.
 * @return GRAZE_OK but for the stratum `level`: GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status generator_sample(sample *out, graze_context *context, const struct graze_generator *g,
                              uint64_t row);

#endif
