/* Convex hulls of points, for hull and minkowski of OpenSCAD's files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The hull of flat parts is that of their vertices, and the Minkowski sum of convex ones is the
 * hull of the sums of their vertices, one of each.
 */
#ifndef GRAZE_INPUT_SCAD_HULL_H
#define GRAZE_INPUT_SCAD_HULL_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "base/context/array.h"
#include "base/context/context.h"
#include "input/scad/arguments.h"
#include "input/scad/writer.h"

/** Points of the plane or of space, each with 3 coordinates; the last is 0 in the plane. */
typedef struct hull_points {
    size_t count, capacity;
    fmpq *at;
} hull_points;

void hull_points_clear(hull_points *p);
void hull_points_swap(hull_points *a, hull_points *b);

/** Append a point; `what` names the points where memory is short. */
graze_status hull_add_point(hull_points *p, graze_context *context, const fmpq *x,
                            const char *what);

/** Three points counterclockwise, seen from outside. */
typedef struct hull_face {
    size_t corner[3];
} hull_face;

typedef struct hull_faces {
    size_t count, capacity;
    hull_face *item;
} hull_faces;

void hull_faces_clear(hull_faces *f);

/**
 * Keep of points of the plane the corners of their hull, counterclockwise.
 * @return GRAZE_OK, also if they are on a line; GRAZE_ESYSTEM
 */
graze_status hull_of_plane(hull_points *p, graze_context *context);

/**
 * Keep of points of space, which are not all in one plane, the corners of their hull and find its
 * faces.
 * @param[out] faces zero at first; the caller clears it, also after a failure
 * @return GRAZE_ELIMIT `work`; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
graze_status hull_of_space(hull_faces *faces, hull_points *p, graze_context *context);

/**
 * Find the hull, or the Minkowski sum, of a node's children.
 * @param[out] points, faces zero at first; the caller clears them, also after a failure. There are
 * no faces in the plane
 * @return GRAZE_EINPUT a part is curved, or of a sum not convex
 */
graze_status scad_hull(hull_points *points, hull_faces *faces, scad_writer *w, const scad_place *p);

#endif
