/* The state in which the nodes of OpenSCAD's files are written.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_SCAD_WRITER_H
#define GRAZE_SCAD_WRITER_H

#include "base/number/json.h"
#include "input/scad/arguments.h"

/** Changes to a file that the caller allows. */
typedef struct scad_choice {
    int smooth; /* a number of sides, $fn, stands for a round surface */
    const fmpq
        *near_rotation; /* an exact rotation, times a scale, is taken instead of a linear part
                   whose entries over the scale are as near to it as this; NULL: none is */
} scad_choice;

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

/** Begin a node, in the line in which the file has it, where `key` is what it is; the value of that
 * is open, an object or a list. */
void scad_open(scad_writer *w, const scad_place *p, const char *key, char bracket);
/** Begin a primitive. */
void scad_begin(scad_writer *w, const scad_place *p, const char *key);
/** End it. */
void scad_end(scad_writer *w, const scad_place *p);

/** A list of numbers. */
void scad_put_vector(scad_writer *w, const char *key, const fmpq *x, size_t count);

/** The number of an argument, positive. */
graze_status scad_size(fmpq_t out, const scad_place *p, const char *name);

/** GRAZE_EINPUT for a number of sides, unless it means a round surface. */
graze_status scad_round(const scad_writer *w, const scad_place *p);

/** Let `reach` be at least the distance of a point from the origin. */
void scad_hold(fmpq_t reach, const fmpq *x, int dimension);

/** The corners of a cube, or in the plane of a square; `reach` is set. */
graze_status scad_box(fmpq *low, fmpq *high, scad_writer *w, const scad_place *p, int dimension);
void scad_put_box(scad_writer *w, const scad_place *p, const fmpq *low, const fmpq *high,
                  int dimension);

#endif
