/* Convex hulls of points, for hull, minkowski and offset of OpenSCAD's files.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The hull of flat parts is that of their vertices, and the Minkowski sum of convex ones is the
 * hull of the sums of their vertices, one of each. With a ball the sum is the union of what is flat
 * and of the points that are within the radius of an edge or a face; so is the hull of equal balls
 * about the hull of their centres.
 */
#ifndef GRAZE_INPUT_SCAD_HULL_H
#define GRAZE_INPUT_SCAD_HULL_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "base/context/array.h"
#include "input/scad/writer.h"
#include "input/soup/soup.h"

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

/** The side of the plane of three points on which a point is: 1 before it, seen from where they go
 * round counterclockwise. */
int hull_side(const hull_points *p, const size_t *corner, size_t point);

/**
 * Keep of points of space the corners of their hull and find its faces.
 * @param[out] faces zero at first; none if the points are on a line, of which the ends stay
 * @return GRAZE_EINPUT they are in one plane; GRAZE_ELIMIT `work`; GRAZE_ECANCELED; GRAZE_ESYSTEM
 */
graze_status hull_of_space(hull_faces *faces, hull_points *p, graze_context *context);

/** The points within `radius` of a polyhedron, or of a polygon; below 0 those of it that are not
 * within -radius of its boundary. */
typedef struct scad_shape {
    hull_points points;
    hull_faces faces; /* as of hull_of_space; none in the plane */
    numbers end;      /* in the plane: one past the last point of a ring */
    fmpq_t radius;
    int mitred;   /* 1: of a polygon the edges are moved by `radius`, and meet in corners */
    soup notched; /* with vertices: a part that is not convex, to which the hull is to be added */
} scad_shape;

void scad_shape_init(scad_shape *s);
void scad_shape_clear(scad_shape *s);

/**
 * Find the hull, the Minkowski sum, or the offset of a node's children.
 * @param[out] out as initialised
 * @return GRAZE_EINPUT a part is neither flat nor round, or more than one of a sum is not convex
 */
graze_status scad_hull(scad_shape *out, scad_writer *w, const scad_place *p);

/** Write the sum of the notched part of a shape and its hull. */
graze_status scad_put_sum(scad_writer *w, const scad_place *p, const scad_shape *s);

/** Write the rings of a shape of the plane in the writer's form, and the faces of a hull. */
void scad_put_polygon(scad_writer *w, const scad_place *p, const scad_shape *s);
void scad_put_hull(scad_writer *w, const scad_place *p, const scad_shape *s);

/** Begin what is mapped to a frame: 4 columns, its origin last. */
void scad_put_frame(scad_writer *w, const scad_place *p, const fmpq *frame);

/** Write the prism of rings in a plane of space, whose points become those in the frame, with the
 * first point as its origin; `height` has the two heights in the frame. */
void scad_put_prism(scad_writer *w, const scad_place *p, const fmpq *frame, scad_shape *rings,
                    fmpq *height);

/** Write the points within `radius` of the segment from a to b; within a prism those of a disk
 * about a, and between a and b. */
graze_status scad_put_segment(scad_writer *w, const scad_place *p, const fmpq *a, const fmpq *b,
                              const fmpq_t radius);

/** Find the points between an edge of an outline, from corner[1] to corner[2], and where it is
 * moved to along its normal on the right, or below 0 on the left. Moved edges meet beyond a corner
 * that they turn away from, and end over another one. Irrational normals are taken within 2^-60
 * where rotations near maps are.
 * @param[out] piece as initialised
 * @param corner 4, with those before and behind the edge
 * @return GRAZE_EINPUT a normal is irrational, or two are nearly opposite */
graze_status scad_moved_edge(scad_shape *piece, scad_writer *w, const scad_place *p,
                             const fmpq_t by, const fmpq *const *corner);

#endif
