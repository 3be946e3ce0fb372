/* Writing a .csg.json file of OpenSCAD's nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SCAD_WRITER_H
#define GRAZE_INPUT_SCAD_WRITER_H

#include <flint/fmpq.h>
#include "base/context/context.h"
#include "base/number/json.h"
#include "input/scad/arguments.h"
#include "input/scad/scad.h"

/* The state in which the nodes of OpenSCAD's files are written. */

/** Forms in which nodes of the plane are written: themselves, prisms, or solids of revolution about
 * the z axis, where x is the distance from the axis and y the height. */
typedef enum scad_form { SCAD_ITSELF, SCAD_PRISM, SCAD_REVOLVED } scad_form;

typedef struct scad_writer {
    const scad *file;
    graze_context *context;
    const scad_choice *choice;
    json_writer json;
    size_t line;     /* of the text so far */
    const char *key; /* of the node that is next, NULL in a list */
    int dimension;   /* of the solid */
    scad_form form;
    fmpq *height; /* 2, of the prism */
    fmpq *map;    /* 6, rows a b c of (a x + b y + c): from the frame of the node at hand to that of
                     what is revolved; else the identity */
    fmpq *reach, *moved; /* of the last node: no point of its primitives is further from the origin
                            of its frame, or is moved further by rotations taken */
    size_t turned;       /* maps replaced by rotations */
} scad_writer;

/** Begin a node in the line in which the file has it. `key` is its kind, whose value, an object or
 * a list as `bracket` says, stays open. */
void scad_open(scad_writer *w, const scad_place *p, const char *key, char bracket);
/** End a primitive, an object, and name it after its line. */
void scad_end(scad_writer *w, const scad_place *p);

/** Read an argument that must be a positive number. */
graze_status scad_size(fmpq_t out, const scad_place *p, const char *name);

/** GRAZE_EINPUT if $fn asks for a number of sides, unless the caller takes that as round. */
graze_status scad_round(const scad_writer *w, const scad_place *p);

/** Let `reach` be at least the distance of a point from the origin. */
void scad_hold(fmpq_t reach, const fmpq *x, int dimension);

/** The corners of a cube, or in the plane of a square; `low` is 0 before; `reach` is set. */
graze_status scad_box(fmpq *low, fmpq *high, scad_writer *w, const scad_place *p, int dimension);
void scad_put_box(scad_writer *w, const scad_place *p, const fmpq *low, const fmpq *high,
                  int dimension);

/* Primitives of space of OpenSCAD's files. */

/** Write a cube, a sphere, a cylinder or a polyhedron; `reach` is set. */
graze_status scad_write_body(scad_writer *w, const scad_place *p);

/* Maps of OpenSCAD's nodes. */

/** A map: its linear part, 9 in rows, and its shift of 3; a node of the plane keeps z apart. */
typedef struct scad_map {
    fmpq *linear, *shift;
    fmpq_t error; /* at least the norm of what a rotation that is taken changes */
} scad_map;

void scad_map_init(scad_map *m);
void scad_map_clear(scad_map *m);

/** Read a multmatrix.
 * @param[out] turned whether a rotation is taken instead of its linear part */
graze_status scad_map_read(scad_map *out, scad_writer *w, const scad_place *p, int *turned);

/** The composition of a map of what is revolved, as scad_writer has it, with another one, which
 * acts first; `out` is not `map`. */
void scad_compose(fmpq *out, const fmpq *map, const scad_map *m);

/** Let `reach` and `moved` be those of the image of the last node. */
void scad_map_bounds(scad_writer *w, const scad_map *m);

/* Rotations near matrices of few digits. */

/**
 * Replace a linear part by a number times a rotation or reflection, if each entry divided by that
 * number is within the tolerance of the rotation's.
 * @param[in,out] matrix 9 entries, rows
 * @param[out] error     at least the norm of the difference; 0 if none is taken
 * @return whether one is taken; not if the matrix is such a one itself
 */
int scad_turn(fmpq *matrix, fmpq_t error, graze_context *context, const fmpq_t tolerance);

/** At least the norm of a linear part, and no more for a rotation or reflection times a rational
 * number. */
void scad_norm(fmpq_t out, const fmpq *matrix);

/* Primitives of the plane of OpenSCAD's files. */

/** Write a square, a circle or a polygon in the form at hand; `reach` is set. */
graze_status scad_write_outline(scad_writer *w, const scad_place *p);

/** Ends of an interval that holds its first coordinates, after the map at hand. */
graze_status scad_outline_extent(fmpq *low_high, scad_writer *w, const scad_place *p);

#endif
