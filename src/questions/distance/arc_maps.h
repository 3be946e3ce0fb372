/* Data of a scene for distances, beside its filter: the maps that place the solid, in doubles, and
 * which pieces are rigid. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_ARC_MAPS_H
#define GRAZE_DISTANCE_ARC_MAPS_H

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
typedef struct arc_maps {
    const graze_scene *scene;
    const course *whole; /* the filter's */
    size_t arc_count, arc_capacity;
    arc *arc;         /* in the order of time */
    size_t *first;    /* arc of each piece, and their number behind the last */
    ulong deepest;    /* the shortest arc is 2^-deepest of its piece */
    scene_memo *tree; /* the arc_tree, made at need */
} arc_maps;

/**
 * The maps of a scene, made at the first call.
 * @return GRAZE_ESYSTEM; GRAZE_ELIMIT a number of solid or motion is beyond doubles, or a degree
 * beyond CARRIER_DEGREE, beyond SQUARED on a piece that is not rigid
 */
graze_status arc_maps_of(const arc_maps **out, graze_context *context, const graze_scene *scene);

/** The tracing map of an arc. */
const carrier *arc_maps_tracing(const arc_maps *g, size_t index);

#endif
