/* The certified floating-point filter of a scene: it finds the certain crossings of the boundary,
 * and the windows of time for which the exact path must be asked.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * For a simplex it reports no contact, one certain crossing, or a question; it never decides a
 * tangency, an edge, a vertex or an end (proofs/filter.md C36, C37).
 */
#ifndef GRAZE_FILTER_FILTER_H
#define GRAZE_FILTER_FILTER_H

#include <pthread.h>
#include <stdatomic.h>
#include "decide/filter/curve.h"
#include "decide/filter/findings.h"
#include "decide/filter/interior.h"
#include "decide/filter/surface_curve.h"
#include "input/solid/known.h"
#include "input/solid/solid.h"

/** Bricks; one thread lays them, under the lock, when memberships alone are first asked for. */
typedef struct brick_memo {
    pthread_mutex_t lock;
    interior all;
    atomic_int laid; /* once set, `all` does not change */
} brick_memo;

/** Data of a scene for the filter; immutable but for the memo, shared by threads. */
typedef struct filter {
    const graze_solid *solid; /* borrowed */
    course course;
    brick_memo *bricks;
    graze_state proves; /* a time in this state decides the membership */
} filter;

/**
 * @param operation which of the motion's point maps carries the query points */
graze_status filter_make(filter *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, graze_operation operation);
void filter_clear(filter *f);
/** The bricks, or NULL if none are laid. */
const interior *filter_bricks(const filter *f);

/** Memory of one thread, reused from query to query. */
typedef struct filter_workspace {
    int set; /* `curve` is that of the point */
    curve curve, ray;
    findings found, ray_found;
    form_memory forms; /* of the solid that was asked last */
    /* For a curved solid: products along the curve, and truths at the start of the motion. */
    surface_curve along;
    truths truths;
} filter_workspace;

/** Set the workspace's curve, unless it is set; 0 if the filter cannot be used for it. */
int filter_set(filter_workspace *w, const filter *f, const filter_point *point);

/** The context's workspace, made at the first call; NULL if memory runs out. */
filter_workspace *filter_workspace_of(graze_context *context);

/** Forget the last point. */
void filter_begin(filter_workspace *w);

/** Search all pieces. The findings stand in the workspace until the next search.
 * @param[out] settled NULL; or 1 if the point is somewhere in the state that decides its
 * membership: then there are no findings. Else 0
 * @param bricks  with `settled`: those that are asked; NULL: crossings alone settle it
 * @return 0 if the filter cannot be used for this point, or without memory: ask the exact search */
int filter_search(filter_workspace *w, int *settled, const interior *bricks, const filter *f,
                  const filter_point *point);

#endif
