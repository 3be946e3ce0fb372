/* The panels of a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DRAW_VIEWS_H
#define GRAZE_DRAW_VIEWS_H

#include "output/draw/marks.h"
#include "output/draw/request.h"
#include "output/draw/shape.h"
#include "output/draw/trail.h"

/** All that a picture shows, made before the canvas is, whose size follows from it. */
typedef struct picture {
    const graze_scene *scene;
    const draw_request *request;
    cells cells;
    section section;  /* where the request has a normal */
    graze_solid made; /* for the eye, of a curved solid */
    size_t undecided; /* cells */
    shape *moved;     /* at request->times times; for an unsweep under the inverse motion */
    shape standing;
    trail *trails;  /* one a point */
    double *points; /* three coordinates each */
    legend legend;
    panel classes, positions, trajectories;
    int has_positions, has_trajectories, failed; /* without memory */
} picture;

/** Choose the windows and sizes of the panels, not yet their places.
 * @return GRAZE_ELIMIT a window beyond what doubles can draw (range_check) */
graze_status views_fit(picture *p, graze_context *context);
/** Note in the legend what the panels show; after views_fit. */
void views_seen(picture *p);
/** 1 in E^2. */
int picture_is_plane(const picture *p);
/** How many points lie outside the panel that shows points where they are; after views_fit. */
size_t views_outside(const picture *p);
/** The classes of the cells, with the positions of S and the points in their plane. */
graze_status view_classes(canvas *c, graze_context *context, const picture *p);
/** The positions of S in space, seen from the onlooker. */
graze_status view_positions(canvas *c, graze_context *context, const picture *p);

#endif
