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
 * Way to make a query point. A point of a contact stratum is P = M(t) y, with y a boundary point
 * and t a rational time: the trajectory of P is at y at the time t. The facets of a curved solid
 * are its surfaces, with their tangent planes; its edges are the curves in which two surfaces meet
 * or touch; its vertices are the apexes and the points in which more than two surfaces meet or two
 * touch, and in the plane all points in which two curves meet.
 */
typedef enum graze_stratum {
    GRAZE_STRATUM_RANDOM = 0,   /**< anywhere in the box of the sweep */
    GRAZE_STRATUM_NEAR = 1,     /**< a `face` point displaced by 2^-k, k from 4 to 11 */
    GRAZE_STRATUM_FACE = 2,     /**< y in a facet where its normal velocity is zero: even order */
    GRAZE_STRATUM_FACE_ODD = 3, /**< as `face`, with an odd order, at least 3 */
    GRAZE_STRATUM_EDGE = 4,     /**< y on an edge (E^3) */
    GRAZE_STRATUM_VERTEX = 5,   /**< y a vertex */
    GRAZE_STRATUM_CROSSING = 6, /**< y in a facet, order 1 */
    GRAZE_STRATUM_START = 7,    /**< t = t0 */
    GRAZE_STRATUM_END = 8,      /**< t = t1 */
    GRAZE_STRATUM_BREAK = 9,    /**< t a break point */
    GRAZE_STRATUM_SLIDE = 10,   /**< y in a facet whose plane the trajectory does not leave */
    GRAZE_STRATUM_MISS = 11,    /**< a point of face, edge, vertex, start or end, displaced by 2^-k,
                                   k from 8 to 96 */
    GRAZE_STRATUM_LEVEL = 12,   /**< beside an `on` contact; the signed distance is in a random
                                   decade, which its enclosure proves; default weight 0 */
    GRAZE_STRATUM_ROUNDED = 13, /**< a contact of a stratum from `face` to `slide`, with its
                                   coordinates replaced by neighbouring doubles, on a random side
                                   where such a point exists; default weight 0 */
    GRAZE_STRATUM_COUNT = 14
} graze_stratum;

/** Order of a contact that is a slide in the plane of the facet. */
#define GRAZE_ORDER_SLIDE (-1)

/** Way in which one point was made. */
typedef struct graze_sample {
    graze_stratum stratum;
    int order;       /**< of the contact with the plane of the facet; 0: no contact */
    graze_cell cell; /**< the cell of y; kind 0: no contact */
    int k;           /**< displaced by 2^-k along the normal of the moved facet; 0: not displaced */
    int outward;     /**< 1 if displaced to the outside */
    int decade;      /**< level: 10^decade <= |s| < 10^(decade + 1), s < 0 unless outward */
    graze_stratum origin; /**< rounded: stratum of the contact that order and cell describe */
    graze_pmc pmc;        /**< rounded: the exact answer for the point, else GRAZE_PMC_NONE */
    unsigned undecided;   /**< points tried for this row and left out, because their answers are
                             undecided; 0 unless the solid is curved */
} graze_sample;

/** Source of query points. It never changes: threads may share it. */
typedef struct graze_generator graze_generator;

/** Make only points whose coordinates are binary64 numbers. */
#define GRAZE_GENERATE_REPRESENTABLE 1u
/** Make only such points, and give the weight of each unrepresentable stratum to `rounded` too. */
#define GRAZE_GENERATE_ROUNDED 3u

/**
 * Make a generator of query points for a scene, which is borrowed and must outlive it. A stratum
 * that a number of tries does not find in the scene gets the weight 0; for a curved solid these are
 * `level` and strata in which no rational point is found. The decades of `level` go, on both
 * sides, from that of the deepest `in` point found down to 1e-9 of the diagonal of S^0's box;
 * decades in which a number of tries finds no point are missing.
 * @param weights GRAZE_STRATUM_COUNT weights of at most 10^6, or NULL for the defaults, with which
 * at least 70 % of the points are degenerate
 * @param flags   0, GRAZE_GENERATE_REPRESENTABLE or GRAZE_GENERATE_ROUNDED
 * @return GRAZE_EINPUT a curved solid without a box; GRAZE_EUSE an unknown flag, all weights 0, or
 * no stratum with a weight can be made; GRAZE_ELIMIT, with `level` also as in graze_distances;
 * GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
GRAZE_API GRAZE_CHECKED graze_status
graze_generator_create(graze_generator **out, graze_context *context, const graze_scene *scene,
                       unsigned long long seed, const unsigned long *weights, unsigned flags);
/** Free a generator; the scene stays. NULL is allowed. */
GRAZE_API void graze_generator_destroy(graze_generator *generator);
/** Weight in force; 0 for a stratum that cannot be made, and for NULL. */
GRAZE_API unsigned long graze_generator_weight(const graze_generator *generator,
                                               graze_stratum stratum);
/** Has a stratum with a weight, by trials, points in the scene, but none of binary64 numbers? 0 for
 * a generator that makes other points too, and for NULL. */
GRAZE_API int graze_generator_is_unrepresentable(const graze_generator *generator,
                                                 graze_stratum stratum);
/** A decade of `level` that is missing, by index from 0: 10^*decade <= |s| < 10^(*decade + 1), s >
 * 0 if *outward. Returns 0, and sets nothing, past the last one and for NULL. */
GRAZE_API int graze_generator_missing_decade(int *decade, int *outward,
                                             const graze_generator *generator, size_t index);
/** Default weight of a stratum. */
GRAZE_API unsigned long graze_stratum_default_weight(graze_stratum stratum);
/** Box of the stratum `random`.
 * @param[out] low, high d initialised rationals each; unchanged for NULL
 */
GRAZE_API void graze_generator_box(mpq_t *low, mpq_t *high, const graze_generator *generator);
/**
 * Make the point of a row; rows count from 0. The point depends on scene, seed, weights, flags and
 * row alone; different rows may have equal points. If point and time are NULL, only the stratum of
 * `out` is sure to be set, which is cheaper for some strata.
 * @param[out] point d initialised rationals
 * @param[out] time  initialised; the time of the contact, 0 without a contact
 * @param[out] out   the way in which the point was made
 * @return GRAZE_EUSE, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_generator_point(mpq_t *point, mpq_t time,
                                                           graze_sample *out,
                                                           graze_context *context,
                                                           const graze_generator *generator,
                                                           unsigned long long row);
/** Name of a stratum, such as "near"; NULL for an unknown one. Static. */
GRAZE_API const char *graze_stratum_name(graze_stratum stratum);

#ifdef __cplusplus
}
#endif
#endif
