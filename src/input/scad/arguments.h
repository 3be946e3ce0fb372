/* The tree of a .csg file, and arguments of its nodes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_SCAD_ARGUMENTS_H
#define GRAZE_INPUT_SCAD_ARGUMENTS_H

#include <flint/fmpq.h>
#include "input/delimited/delimited.h"
#include "input/scad/scad.h"

/* The nodes of OpenSCAD's `.csg` files (src/program/cli/formats.md, OpenSCAD). */

/** Kind of a node; groups, colors and renders are unions. */
typedef enum scad_role {
    SCAD_UNION,
    SCAD_DIFFERENCE,
    SCAD_INTERSECTION,
    SCAD_MAP,
    SCAD_EXTRUSION,
    SCAD_REVOLUTION,
    SCAD_HULL,
    SCAD_MINKOWSKI,
    SCAD_OFFSET,
    SCAD_CUBE,
    SCAD_SPHERE,
    SCAD_CYLINDER,
    SCAD_POLYHEDRON,
    SCAD_SQUARE,
    SCAD_CIRCLE,
    SCAD_POLYGON
} scad_role;

typedef struct scad_node {
    field name, arguments;
    size_t line;
    char mark;     /* `%`, `*` or `!`; 0 without one of these */
    int absent;    /* 1: no part of the solid, by its own mark, one around it, or `!` of a node
                    * elsewhere */
    int empty;     /* 1: it has no children, or an operation on empty children leaves nothing */
    int dimension; /* 2 or 3; 0 if it holds no primitive */
    scad_role role;
    size_t parent, first, last, next; /* 0: none */
} scad_node;

/** How many parts are left out for a reason, and the line of the first. */
typedef struct scad_nothing {
    size_t parts, first;
} scad_nothing;

/** A file: node 0 is the union of what it holds; a node stands before its children. */
typedef struct scad {
    const char *source; /* name of the file, borrowed, for messages */
    scad_node *node;
    size_t count, capacity, root; /* the root is node 0 or the first one with `!` */
    scad_nothing nothing, mixed;  /* parts that are empty by themselves, and of another dimension
                                   * than what stands before them */
} scad;

/**
 * Read the nodes of a text, which must outlive them.
 * @param[out] out cleared by scad_clear, also after a failure
 * @return GRAZE_EINPUT with the line: the text is not as OpenSCAD writes it, or has a node that is
 * not taken; GRAZE_EILLEGAL the solid is empty; GRAZE_ELIMIT `depth`, `cells`; GRAZE_ESYSTEM
 */
graze_status scad_parse(scad *out, graze_context *context, const char *source, const char *text,
                        size_t length);
void scad_clear(scad *file);

/** The first child of a node, or the one after a child, that is part of the solid; 0 if none. */
size_t scad_first(const scad *file, size_t node);
size_t scad_next(const scad *file, size_t child);

/* Arguments of the nodes of OpenSCAD's `.csg` files. */

/** The node whose arguments are read, and the context that takes failures. */
typedef struct scad_place {
    const scad *file;
    graze_context *context;
    size_t node;
} scad_place;

/** Fail with "source:line: name: message". */
graze_status scad_fail(const scad_place *p, graze_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Whether a part is empty by its own arguments: of size zero, without points, or a singular map.
 */
int scad_is_nothing(const scad_place *p);

/** Take the next item of a list whose items stand between commas.
 * @param[in,out] rest the list; afterwards the items behind this one
 * @return 0 at the end */
int scad_item(field *item, field *rest);

/** Find the value of the argument `name`, or of the argument without a name if `name` is NULL.
 * @return 0 if it is not given, or `undef` */
int scad_value(field *out, const scad_place *p, const char *name);

/** GRAZE_EINPUT unless each argument's name is one of `names`, which blanks separate, or begins
 * with
 * $. */
graze_status scad_known(const scad_place *p, const char *names);

/** Find the items of a list, whose value stands in brackets. */
graze_status scad_list(field *out, const scad_place *p, field value);

/** The number that a value is. */
graze_status scad_number(fmpq_t out, const scad_place *p, field value);

/** Read a list of exactly `count` numbers. */
graze_status scad_vector(fmpq *out, const scad_place *p, field value, size_t count);

/** Read the numbers of an argument that must be given, exactly `count`. */
graze_status scad_named_vector(fmpq *out, const scad_place *p, const char *name, size_t count);

/** Read the number of an argument that must be given. */
graze_status scad_named_number(fmpq_t out, const scad_place *p, const char *name);

/** The items of an argument that must be given. */
graze_status scad_named_list(field *out, const scad_place *p, const char *name);

/** Read a whole number from 0 to `count` - 1. */
graze_status scad_index(size_t *out, const scad_place *p, field value, size_t count);

/** Whether an argument is `true`. */
int scad_flag(const scad_place *p, const char *name);

#endif
