/* scene: a scene of solid, motion and options; whether the solid at both ends meets itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_SCENE_H
#define GRAZE_DECIDE_SCENE_H

#include <flint/fmpq_mat.h>
#include <pthread.h>
#include "decide/filter/filter.h"
#include "decide/surfaces/surfaces.h"
#include "input/csg/csg.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/* A scene: a solid, a motion of the same dimension, the options its answers depend on, and facts
 * decided about the pair.
 *
 * Invariant: solid and motion are borrowed and legal, their dimensions agree, and `ends` is decided
 * exactly, of a curved solid where it is decided. A scene never changes once made, but for memos
 * under a lock. */

/** A value that a later stage makes of a scene once and keeps; it is made under the lock.
 */
typedef struct scene_memo {
    pthread_mutex_t lock;
    void *value; /* NULL until it is made */
    void (*free)(void *);
} scene_memo;

struct graze_scene {
    const graze_solid *solid;
    const graze_motion *motion;
    graze_options options;
    filter filter;               /* for the operation of the options; unset for a curved solid */
    surface_filter *surfaces;    /* the filter of a curved solid, or NULL if beyond it */
    graze_ends ends;             /* whether S^0 and S^1 have a point in common */
    unsigned char sha256[32];    /* hash of the canonical text of solid and motion, see scene_hash
                                  */
    scene_memo *memo, *arc_maps; /* the memo of topo, and the memo of distances */
    graze_motion *standing;      /* the scene's own motion, of a solid at rest; else NULL */
};

/**
 * Fill a scene: dimensions, the ends, the hash, the filter. On success scene_clear frees it.
 * @return GRAZE_EILLEGAL the dimensions differ, or the ends of a sweep meet, or may meet, where
 * `overlap` rejects it
 */
graze_status scene_make(graze_scene *out, graze_context *context, const graze_solid *solid,
                        const graze_motion *motion, const graze_options *options);

/** Fill the scene of a solid that does not move: `standing` is the identity for t in [0, 1]. What
 * it sweeps is the solid. Statuses of scene_make. */
graze_status scene_at_rest(graze_scene *out, graze_context *context, const graze_solid *solid);

void scene_clear(graze_scene *scene);

/** Decide whether M(t0) S and M(t1) S, closed sets, have a point in common. */
graze_status scene_ends(graze_ends *out, graze_context *context, const graze_solid *solid,
                        const graze_motion *motion);

/* A box that holds the sweep of a scene. */

/**
 * A box of dyadic rationals that holds the sweep (for unsweep the unsweep).
 * @param[out] low, high d initialised rationals each
 * @return GRAZE_ECANCELED; GRAZE_ELIMIT the weight is too near 0 for the limit `work`
 */
graze_status scene_box(fmpq *low, fmpq *high, graze_context *context, const graze_scene *scene);

/* Tests whether a curved solid certainly meets its image, or certainly does not (proofs/curved.md
 * C103). */

/**
 * Test whether the solid's box and its image are disjoint; else look for a point in the interior of
 * the solid and of its image.
 * @param map, inverse homogeneous matrices
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED
 */
graze_status common_point_ends(graze_ends *out, graze_context *context, const csg *solid,
                               const fmpq_mat_t map, const fmpq_mat_t inverse);

/* A bound of the work for many points of a scene, checked before the work begins. */

/** The work of finding a polynomial's roots: n s / 256 for n coefficients, where s is the sum of w
 * + w^2/64 over the coefficients with w words each. */
double demand_of_roots(const fmpz_poly_t p);

/** GRAZE_ELIMIT if this work, for the functions of the motion's largest piece and for `points`
 * points together, exceeds the limit `work`.
 * @param what the points' use, for the message */
graze_status demand_check(graze_context *context, const graze_scene *scene, double points,
                          const char *what);

/* The hash that identifies a scene. */

/**
 * SHA-256 of the scene's canonical text, line by line: `d N`; `v X Y [Z]` for each vertex; for each
 * facet `f` and the vertices of its cycles, cycles parted by ` |`; where a facet's simplices lie in
 * more than one plane (it was fanned) `t A B C` for each of them; for each piece of the motion `p
 * LO HI`, then `m` and the coefficients of each entry of M in the piece's own parameter, row by
 * row, then `w` and those of the weight. A curved solid has, instead of `v`, `f` and `t`, for each
 * surface `s` and its terms, coefficient and powers, and for each node of the expression `n`,
 * operation, complement and operands. Numbers are those in force: after rounding, in lowest terms.
 */
graze_status scene_hash(unsigned char out[32], graze_context *context, const graze_solid *solid,
                        const graze_motion *motion);

/* Tests whether a solid's boundary meets its image under an affine map. */

/**
 * Decide whether the boundary of S and its image have a common point.
 * @param map d*(d+1) rationals, row by row, invertible
 * @return GRAZE_ESYSTEM, GRAZE_ECANCELED
 */
graze_status meeting_find(int *out, graze_context *context, const graze_solid *solid,
                          const fmpq *map);

#endif
