/* graze/generate.h - query points by stratum.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_H
#define GRAZE_GENERATE_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * How a query point is made. Of a contact stratum it is P = M(t) y with y a point of the boundary
 * and t a rational time, so that P's trajectory is at y at the time t.
 */
typedef enum graze_stratum {
    GRAZE_STRATUM_RANDOM = 0,   /**< anywhere in the sweep's box */
    GRAZE_STRATUM_NEAR = 1,     /**< a `face` point displaced by 2^-k, k from 4 to 11 */
    GRAZE_STRATUM_FACE = 2,     /**< y in a facet where its normal velocity is zero: even order */
    GRAZE_STRATUM_FACE_ODD = 3, /**< the same with an odd order of 3 or more: it crosses */
    GRAZE_STRATUM_EDGE = 4,     /**< y on an edge (E^3) */
    GRAZE_STRATUM_VERTEX = 5,   /**< y a vertex */
    GRAZE_STRATUM_CROSSING = 6, /**< y in a facet, order 1 */
    GRAZE_STRATUM_START = 7,    /**< t = t0 */
    GRAZE_STRATUM_END = 8,      /**< t = t1 */
    GRAZE_STRATUM_BREAK = 9,    /**< t a break point */
    GRAZE_STRATUM_SLIDE = 10,   /**< y in a facet whose plane the trajectory does not leave */
    GRAZE_STRATUM_MISS = 11,    /**< one of these displaced by 2^-k, k from 8 to 96 */
    GRAZE_STRATUM_COUNT = 12
} graze_stratum;

/** The order of a contact that is a slide in the facet's plane. */
#define GRAZE_ORDER_SLIDE (-1)

/** How one point was made. */
typedef struct graze_sample {
    graze_stratum stratum;
    int order; /**< of the contact with the plane of the cell's facet; 0: made without a contact */
    graze_cell cell; /**< the cell that y lies in; kind 0 without a contact */
    int k;           /**< displaced by 2^-k along the moved facet's normal; 0: not displaced */
    int outward;     /**< 1 if displaced to the outside */
} graze_sample;

typedef struct graze_generator graze_generator;

/** Keep to points whose coordinates a binary64 holds. */
#define GRAZE_GENERATE_REPRESENTABLE 1u

/**
 * Make a generator of query points for a scene, which it borrows. Strata that the scene cannot
 * have, as far as a number of tries tells, get the weight 0. A generator never changes: threads may
 * share it.
 * @param weights GRAZE_STRATUM_COUNT weights, none over 10^6, or NULL for the defaults, with which
 * at least 70 % of the points are degenerate
 * @return GRAZE_EUSE an unknown flag, all weights are 0, or none of the strata that have one can be
 * made
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_generator_create(graze_generator **out, graze_context *context, const graze_scene *scene,
                       unsigned long long seed, const unsigned long *weights, unsigned flags);
GRAZE_API void graze_generator_destroy(graze_generator *generator);
/** The weight in force, 0 for a stratum that cannot be made. */
GRAZE_API unsigned long graze_generator_weight(const graze_generator *generator,
                                               graze_stratum stratum);
/** The default weight. */
GRAZE_API unsigned long graze_stratum_default_weight(graze_stratum stratum);
/** The box of the stratum `random`: d initialised rationals each. */
GRAZE_API void graze_generator_box(mpq_t *low, mpq_t *high, const graze_generator *generator);
/**
 * The point of a row, from 0; it depends on scene, seed, weights, flags and row alone.
 * @param[out] point d initialised rationals
 * @param[out] time  initialised; the contact's time, 0 without a contact
 */
GRAZE_API GRAZE_CHECKED graze_status graze_generator_point(mpq_t *point, mpq_t time,
                                                           graze_sample *out,
                                                           graze_context *context,
                                                           const graze_generator *generator,
                                                           unsigned long long row);
/** "random", "near", ...; NULL past the last. */
GRAZE_API const char *graze_stratum_name(graze_stratum stratum);

#ifdef __cplusplus
}
#endif
#endif
