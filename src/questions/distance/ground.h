/* What distances need of a scene beside its filter: the maps that place the solid, in doubles, and
 * which pieces are rigid. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_GROUND_H
#define GRAZE_DISTANCE_GROUND_H

#include "decide/filter/course.h"
#include "decide/scene/scene.h"

/**
 * A part of a piece on which no weight varies much, so that its rounding is small everywhere: the
 * whole piece, of most motions. Its own parameter v runs from 0 to 1, the piece's is from +
 * length v, with `from` and `length` dyadic and exact.
 */
typedef struct arc {
    size_t piece;
    double from, length;
    int rigid;       /* distances of the space of query points are those of the solid's */
    carrier tracing; /* of a part; unset where the arc is the piece, whose map the filter has */
    carrier placing; /* motion_placing; set only if not rigid */
} arc;

/** Immutable once made; belongs to the scene. */
typedef struct ground {
    const graze_scene *scene;
    const course *whole; /* the filter's */
    size_t arc_count, arc_capacity;
    arc *arc;         /* in the order of time */
    size_t *first;    /* arc of each piece, and their number behind the last */
    ulong deepest;    /* the shortest arc is 2^-deepest of its piece */
    scene_memo *tree; /* the arc_tree, made at need */
} ground;

/**
 * The ground of a scene, made at the first call.
 * @return GRAZE_ESYSTEM; GRAZE_ELIMIT a number of solid or motion is beyond doubles, or a degree
 * beyond CARRIER_DEGREE, beyond SQUARED on a piece that is not rigid
 */
graze_status ground_of(const ground **out, graze_context *context, const graze_scene *scene);

/** The tracing map of an arc. */
const carrier *ground_tracing(const ground *g, size_t index);

#endif
