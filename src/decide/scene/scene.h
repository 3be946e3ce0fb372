/* A scene: a solid, a motion of the same dimension, the options its answers depend on, and facts
 * decided about the pair.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant: solid and motion are borrowed and legal, their dimensions agree, and `ends` is decided
 * exactly, of a curved solid where it is decided. A scene never
 * changes once made, but for its memo.
 */
#ifndef GRAZE_SCENE_SCENE_H
#define GRAZE_SCENE_SCENE_H

#include <pthread.h>
#include "decide/filter/filter.h"
#include "decide/filter/surfaces.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/** A value that a later stage makes of a scene once and keeps: the only part that changes, under
 * the lock.
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
    filter filter;               /* for the operation of the options; not of a curved solid */
    surface_filter *surfaces;    /* that of a curved solid; or NULL */
    graze_ends ends;             /* whether S^0 and S^1 have a point in common */
    unsigned char sha256[32];    /* of the canonical text of solid and motion, see scene_hash */
    scene_memo *memo, *arc_maps; /* of topo and of distances */
};

/**
 * Fill a scene: dimensions, the ends, the hash, the filter. On success scene_clear frees it.
 * @return GRAZE_EILLEGAL the dimensions differ, or the ends meet where `overlap` rejects it
 */
graze_status scene_make(graze_scene *out, graze_context *context, const graze_solid *solid,
                        const graze_motion *motion, const graze_options *options);

void scene_clear(graze_scene *scene);

/** Decide whether M(t0) S and M(t1) S, closed sets, have a point in common. */
graze_status scene_ends(graze_ends *out, graze_context *context, const graze_solid *solid,
                        const graze_motion *motion);

#endif
