/* Data for tracing one point: the scene, the point, its exact trajectories when they are needed;
 * and the location of a time off the boundary.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_TRACER_H
#define GRAZE_TRACE_TRACER_H

#include "decide/trace/trace.h"
#include "decide/trace/trajectory.h"

/** The last finding, against which the next one is checked (decide/trace/crosscheck.h). */
typedef struct last_seen {
    int any;
    size_t piece;
    graze_state after; /* of a certain crossing; ABSENT for an exact window */
    uint32_t to;       /* the end of an exact window, in 2^-WINDOW_LEVELS */
} last_seen;

typedef struct tracer {
    graze_trace *out;
    graze_context *context;
    const graze_scene *scene;
    query_point point;
    trace_detail detail;
    filter_workspace *workspace; /* NULL: no filter */
    filter_point near;
    fmpz *homogeneous;       /* the point as d + 1 integers, the last one positive, and */
    trajectory *exact;       /* its trajectories, one per piece; NULL until the first is needed */
    unsigned char *is_exact; /* which of them are set */
    candidates list;
    last_seen last;
} tracer;

/** Begin with a filter, unless the context wants none. `r` holds the scene,
 * the context, the point and the trace to be filled, and zeros. */
void tracer_begin(tracer *r);
void tracer_clear(tracer *r);

/** The exact trajectory of a piece, owned by `r`; NULL without memory, which is reported. */
const trajectory *tracer_exact(tracer *r, size_t piece);

/** The span of the filter's curve that is a whole piece, until the curve is cut; NULL if it cannot
 * be used. */
const span *tracer_quick(tracer *r, size_t piece);

/** The state at a rational time at which the trajectory is off the boundary. */
graze_status tracer_locate(graze_state *out, tracer *r, size_t piece, const fmpq_t u);

#endif
