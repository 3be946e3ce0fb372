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

/** The points origin + s_0 direction[0] + ...: s_j is their coordinate axis[j]. */
typedef struct flat {
    int dimension, count; /* of space; of parameters */
    int axis[3];
    fmpq *origin, *direction[3]; /* one array of 12, borrowed by `direction` */
} flat;

/** The polynomial v' form v + slope . v + value at the place start + v; one array. */
typedef struct quadratic {
    int count; /* of variables */
    fmpq *start, *slope, *value, *form;
} quadratic;

/** Points of a flat; if `bent`, the zeros of `curve` in it: its start, and the second zeros on
 * lines through the start. */
typedef struct chart {
    flat place;
    int bent;
    int isolated;    /* a singular point of the zeros */
    quadratic curve; /* in the parameters of the flat; only if bent */
    size_t mark;     /* number of what it was made of, given by its maker */
} chart;

typedef struct charts {
    graze_context *context;
    const fmpq_mpoly_ctx_struct *ring; /* of the coordinates */
    int dimension;
    size_t count, capacity, mark; /* mark: that of charts appended from now on */
    chart *item;
} charts;

/** Derivatives of pullbacks by u: of order 1 and 2. */
enum { INSTANT_DERIVATIVES = 2 };

typedef struct instant {
    int dimension;
    size_t piece;
    fmpq_t u, t;
    fmpq *map; /* M at u: d * (d + 1) */
    fmpz
        *inverse; /* a positive multiple of (N, W) at u: (d + 1) * (d + 1), the weight's row last */
    /* Its derivatives of order 1 and 2 times M at u, each by a positive number: body points in,
     * (d + 1) * (d + 1). */
    fmpz *carried[INSTANT_DERIVATIVES];
    int bounded; /* it is set: */
    double
        velocity[16]; /* the first of them times a positive number, each within 2^-52 of itself */
} instant;

/** Charts of the faces, edges and vertices in which all surfaces of a solid meet: not all of their
 * points are on the solid's boundary. */
typedef struct atlas {
    const csg *solid;
    fmpq_mpoly_ctx_t ring;
    charts faces, edges, vertices;
    charts
        touches; /* where a surface's normal velocity is zero: mark is the number of an instant */
} atlas;

/** At `when` the normal velocity is zero on all of the simplex; with `slides`, at all times of the
 * piece. */
typedef struct special {
    instant when;
    size_t simplex;
    int slides;
} special;

typedef struct specials {
    size_t count, capacity;
    special *item;
} specials;

/* A generator, and one point and how it was made. */

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

/* Query points made to be degenerate: a body point y and a rational time are chosen, and P = M(t)
 * y. */

/** Make a generator; `out` is cleared by generator_clear in either case. */
graze_status generator_make(struct graze_generator *out, graze_context *context,
                            const graze_scene *scene, uint64_t seed, const unsigned long *weights,
                            int representable);
void generator_clear(struct graze_generator *g);

/** The point of one row; it depends on generator and row alone.
 * @return GRAZE_OK but for the stratum `level`: GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status generator_sample(sample *out, graze_context *context, const struct graze_generator *g,
                              uint64_t row);

#endif
