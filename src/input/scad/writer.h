/* Writing a .csg.json file of OpenSCAD's nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SCAD_WRITER_H
#define GRAZE_INPUT_SCAD_WRITER_H

#include <flint/fmpq.h>
#include "input/scad/arguments.h"

/* The state in which the nodes of OpenSCAD's files are written. */

/** Forms in which nodes of the plane are written: themselves, prisms, or solids of revolution about
 * the z axis, where x is the distance from the axis and y the height. */
typedef enum scad_form { SCAD_ITSELF, SCAD_PRISM, SCAD_REVOLVED } scad_form;

typedef struct scad_writer {
    const scad *file;
    graze_context *context;
    const scad_choice *choice;
    json_writer json;
    size_t line;     /* number of the line in which the text so far ends */
    const char *key; /* JSON key of the next node, NULL in a list */
    int dimension;   /* of the solid */
    scad_form form;
    fmpq *height; /* 2: those of the prism's bottom and top */
    fmpq *scale;  /* 2: by which the prism's x and y are scaled at its top */
    fmpq *map;    /* 6, rows a b c of (a x + b y + c): within a revolution from the frame of the
                   * current node to that of the outline revolved; else the identity */
    fmpq *reach, *moved; /* bounds for the last node: how far points of its primitives are from the
                          * origin of its frame, and how far rotations taken move them */
    size_t turned;       /* maps replaced by rotations */
    size_t round, sided; /* parts with and without $fn that are round; those with sides */
    /* Write a node, or with `inner` the union of its children, as a solid of its own. */
    graze_status (*part)(text *out, struct scad_writer *w, size_t node, int inner);
} scad_writer;

/** Begin a node in the line in which the file has it. `key` is its kind, whose value, an object or
 * a list as `bracket` says, stays open. */
void scad_open(scad_writer *w, const scad_place *p, const char *key, char bracket);
/** Name a primitive after its line, and close its object. */
void scad_end(scad_writer *w, const scad_place *p);

/** Read an argument that must be a positive number. */
graze_status scad_size(fmpq_t out, const scad_place *p, const char *name);

/** Find the number of sides of a part that is not taken as round, else 0. GRAZE_EINPUT: $fn asks
 * for some, and the choice has no `smooth`. GRAZE_ELIMIT `cells`. */
graze_status scad_sides(size_t *sides, const scad_writer *w, const scad_place *p);

/** Corner k of a regular polygon about the origin, whose corner 0 is on the x axis, within 2^-60
 * radii. */
void scad_corner(fmpq *out, size_t k, size_t count, const fmpq_t radius);

/** Write a polyhedron of regular polygons about the z axis.
 * @param ring radius and height of each, upwards; the first or the last may have radius 0 */
void scad_put_rings(scad_writer *w, const scad_place *p, const fmpq *ring, size_t rings,
                    size_t sides);

/** Let `reach` be at least the distance of a point from the origin. */
void scad_hold(fmpq_t reach, const fmpq *x, int dimension);

/** Read the low and the high corner of a cube, or of a square in the plane; the caller sets `low`
 * to 0. `reach` is raised to hold the box. */
graze_status scad_box(fmpq *low, fmpq *high, scad_writer *w, const scad_place *p, int dimension);
void scad_put_box(scad_writer *w, const scad_place *p, const fmpq *low, const fmpq *high,
                  int dimension);

/** Whether the prism around a node is scaled as it rises. */
int scad_is_tapered(const scad_writer *w);

/* Primitives of space of OpenSCAD's files. */

/** Write a cylinder, or a cone. `ring` has radius and height of the bottom and of the top. */
void scad_put_cylinder(scad_writer *w, const scad_place *p, const fmpq *ring);

/** Write a cube, a sphere, a cylinder, a polyhedron, a hull or a sum; `reach` is set. */
graze_status scad_write_body(scad_writer *w, const scad_place *p);

/* Maps of OpenSCAD's nodes. */

/** A map: its linear part, 9 in rows, and its shift of 3; in the map of a node of the plane, z
 * depends on z alone. */
typedef struct scad_map {
    fmpq *linear, *shift;
    fmpq_t error; /* at least the norm of the change, if a rotation is taken */
} scad_map;

void scad_map_init(scad_map *m);
void scad_map_clear(scad_map *m);

/** Read a multmatrix.
 * @param[out] turned 1 if a rotation is taken instead of the linear part */
graze_status scad_map_read(scad_map *out, scad_writer *w, const scad_place *p, int *turned);

/** Compose `map`, which has the form of scad_writer.map, with `m`, which acts first; `out` is not
 * `map`. */
void scad_compose(fmpq *out, const fmpq *map, const scad_map *m);

/** Let `reach` and `moved` be those of the image of the last node. */
void scad_map_bounds(scad_writer *w, const scad_map *m);

/* Rotations near matrices of few digits. */

/**
 * Replace a linear part by a number times a rotation or reflection, if each entry divided by that
 * number is within the tolerance of the rotation's entry.
 * @param[in,out] matrix 9 entries, rows
 * @param[out] error at least the norm of the difference; 0 if none is taken
 * @return 1 if the matrix is replaced; 0 if none is near enough, or if it is a rotation or
 * reflection times a scale already
 */
int scad_turn(fmpq *matrix, fmpq_t error, graze_context *context, const fmpq_t tolerance);

/** An upper bound of the norm of a linear part, equal to the norm for a rotation or reflection
 * times a rational number. */
void scad_norm(fmpq_t out, const fmpq *matrix);

/* Primitives of the plane of OpenSCAD's files. */

/** Write a square, a circle, a polygon, a hull or a sum in the writer's form; `reach` is set. */
graze_status scad_write_outline(scad_writer *w, const scad_place *p);

/** Find the ends of an interval that holds the first coordinates of an outline after
 * scad_writer.map. */
graze_status scad_outline_extent(fmpq *low_high, scad_writer *w, const scad_place *p);

#endif
