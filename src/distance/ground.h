/* What distances need of a scene beside its filter: the maps that place the solid, in doubles, and
 * which pieces are rigid. SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_GROUND_H
#define GRAZE_DISTANCE_GROUND_H

#include "filter/course.h"
#include "scene/scene.h"

typedef struct ground_piece {
    int rigid;       /* distances of the space of query points are those of the solid's */
    carrier placing; /* motion_placing; set only if not rigid */
} ground_piece;

/** Immutable once made; belongs to the scene. */
typedef struct ground {
    const graze_scene *scene;
    const course *tracing; /* the filter's */
    ground_piece *piece;
} ground;

/**
 * The ground of a scene, made at the first call.
 * @return GRAZE_ESYSTEM; GRAZE_ELIMIT a number of solid or motion is beyond doubles, or a degree
 * beyond CARRIER_DEGREE, beyond SQUARED on a piece that is not rigid
 */
graze_status ground_of(const ground **out, graze_context *context, const graze_scene *scene);

#endif
