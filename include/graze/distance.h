/* graze/distance.h - how far a point is from the sweep, with proof.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * s(P) is the least signed distance of P to the boundary of M(t) S over all t, negative where P is
 * inside; for an unsweep the greatest (semantics.md 8). Its sign is that of the exact answer. The
 * value is enclosed by two doubles, which are bounds.
 */
#ifndef GRAZE_DISTANCE_H
#define GRAZE_DISTANCE_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * low <= s <= high. `out`: low >= 0 < high; `in`: low < 0 and high <= 0; `on`: both 0.
 */
typedef struct graze_enclosure {
    double low, high;
    double time; /**< double nearest to a time at which the signed distance to the solid is at most
                    high; for an unsweep at least low; for `on` that of a contact */
    graze_pmc pmc; /**< the exact answer */
    int wide; /**< 1: high - low is more than the tolerance, because doubles near s are too coarse,
                 or because the work for one point has reached its limit */
} graze_enclosure;

/**
 * Enclose the signed distances of points. The enclosure for a smaller tolerance lies in that for a
 * larger one.
 * @param[out] out  n enclosures in the order of the points; on failure those from the one that
 * failed on are zero
 * @param points    n*d canonical rationals, point after point; may be NULL if n is 0
 * @param tolerance greatest width wanted, positive and finite
 * @return GRAZE_EUSE; GRAZE_ELIMIT, also for numbers of solid, motion or point beyond 2^200, and
 * for a degree beyond 32, or beyond 20 on a piece that is not rigid; GRAZE_ECANCELED;
 * GRAZE_ESYSTEM; GRAZE_EINTERNAL
 */
GRAZE_API GRAZE_CHECKED graze_status graze_distances(graze_enclosure *out, graze_context *context,
                                                     const graze_scene *scene,
                                                     graze_rationals points, size_t n,
                                                     double tolerance);
/** graze_distances for finite doubles, which are taken exactly. */
GRAZE_API GRAZE_CHECKED graze_status graze_distances_doubles(graze_enclosure *out,
                                                             graze_context *context,
                                                             const graze_scene *scene,
                                                             const double *points, size_t n,
                                                             double tolerance);
/**
 * The diagonal of the box of S^0's corners, rounded down: the unit of relative tolerances.
 * @return GRAZE_EUSE; GRAZE_ELIMIT if it is not between 2^-300 and 2^300; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_diagonal(double *out, graze_context *context,
                                                          const graze_scene *scene);
/** A tolerance: `fraction`, positive and finite, times the diagonal, rounded down.
 * @return as graze_scene_diagonal; GRAZE_ELIMIT also if it is beyond doubles */
GRAZE_API GRAZE_CHECKED graze_status graze_scene_width(double *out, graze_context *context,
                                                       const graze_scene *scene, double fraction);

#ifdef __cplusplus
}
#endif
#endif
