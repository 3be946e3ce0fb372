/* Reading a Boolean expression over surfaces.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_CSG_CSG_READER_H
#define GRAZE_INPUT_CSG_CSG_READER_H

#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_mpoly.h>
#include <stdint.h>
#include "input/csg/csg.h"
#include "input/motion/motion.h"

void csg_box_set(csg_box *to, const csg_box *from);
/** Enlarge coordinate i of a box until it holds an interval, or set it to the interval if the box
 * has dimension 0. The caller sets the dimension. */
void csg_box_hold(csg_box *box, int i, const fmpq_t low, const fmpq_t high);

/* The state in which the nodes of a curved solid are read. */

/** A reader, with the frame of the node that is being read: `coordinate` expresses the node's
 * coordinates as linear forms in the solid's, and `place` maps the node's frame to the solid's. The
 * other polynomials are temporary. */
typedef struct csg_reader {
    graze_context *context;
    csg *out;
    fmpq_mpoly_ctx_t ring; /* of the coordinates */
    int dimension;
    fmpq_mat_t place; /* from the frame of the node to that of the solid, homogeneous */
    csg_box box;      /* holds what counts of the node read last; in the frame of the solid */
    fmpq *cut; /* half-spaces around the node, in the frame of the solid: 4 numbers each; the first
                  d + 1 are a form that is 0 or less there */
    int cuts;  /* at most CSG_CUTS_MOST */
    unsigned long cut_work;                       /* left for boxes within half-spaces */
    fmpq_mpoly_struct poly[10], *coordinate;      /* all polynomials; 3 of them */
    fmpq_mpoly_struct *from;                      /* 3: the point minus a primitive's own point */
    fmpq_mpoly_struct *square, *along, *f, *term; /* |from|^2, axis . from, the polynomial, a
                                                   * summand */
} csg_reader;

/** Read the value of a primitive's key, after csg_add_primitive. */
typedef graze_status csg_primitive_reader(size_t *node, csg_reader *r, const json *value);

/** Begin a reader, in the frame of the solid, and an empty solid. csg_reader_clear keeps the solid.
 */
void csg_reader_init(csg_reader *r, graze_context *context, csg *out, int dimension);
void csg_reader_clear(csg_reader *r);

/* The solid grows: polynomials are factored to surfaces, nodes appended. The functions return
 * GRAZE_ELIMIT if nodes or operands exceed the limit `cells`, GRAZE_ECANCELED, GRAZE_ESYSTEM. */

/** Add a primitive; the nodes CSG_SIGN that are added next belong to this primitive. `name` may be
 * NULL. */
graze_status csg_add_primitive(csg_reader *r, const char *kind, const char *name);

/** Add a node for the set f <= 0 to the last primitive; f is not zero, of degree at most
 * CSG_DEGREE.
 */
graze_status csg_add_sign(size_t *node, csg_reader *r, const fmpq_mpoly_t f);

/** Add a node whose operands are nodes; a node is an operand of at most one other node. */
graze_status csg_add_node(size_t *node, csg_reader *r, csg_operation operation,
                          const size_t *operands, size_t count);

/** Finish the solid: equal surfaces become one. */
graze_status csg_build_finish(csg_reader *r);

/** Get the `count` members of a primitive's object by name; the first `needed` must be there. */
graze_status csg_read_members(const json **out, csg_reader *r, const json *value,
                              const char *const *names, size_t count, size_t needed);

/** Return GRAZE_EINPUT if the solid is plane, since the primitive exists in space alone. */
graze_status csg_in_space(csg_reader *r, const json *value);

/** Read a number as entry_number does; a plain number token is read without the expression parser.
 */
graze_status csg_read_number(fmpq_t out, csg_reader *r, const json *value);

/** `count` numbers. */
graze_status csg_read_vector(fmpq *out, csg_reader *r, const json *value, size_t count);

/** out = sum factor[i] x[i] - constant, where x has a polynomial for each coordinate. */
void csg_linear_form(fmpq_mpoly_t out, csg_reader *r, const fmpq *factor,
                     const fmpq_mpoly_struct *x, const fmpq_t constant);

/** Add a node for the set r->f <= 0, or r->f >= 0 if `other`. */
graze_status csg_add_side(size_t *node, csg_reader *r, int other);

/** Has a number that was computed more digits than the limit allows? */
int csg_is_long(const graze_context *context, const fmpq_t value);

/* Boxes that hold the nodes of a curved solid, within the half-spaces around them
 * (proofs/curved.md C102). */

/** Enlarge the reader's box until it holds the Minkowski sum of a disk and a ball.
 * @param point the centre of the disk, in the frame of the node at hand
 * @param axis  normal to the disk; unused if `disk` is 0
 * @param ball  radius of the ball, 0 or more
 * @param disk  the square of the disk's radius
 */
void csg_bound_round(csg_reader *r, const fmpq *point, const fmpq *axis, const fmpq_t ball,
                     const fmpq_t disk);

/** Enlarge the reader's box until it holds the box with these opposite corners, which are in the
 * frame of the node at hand. */
void csg_bound_corners(csg_reader *r, const fmpq *low, const fmpq *high);

/** Let `box`, which holds a set, hold the union, or the intersection, of this set with the set that
 * `other` holds. If the interiors of the boxes are disjoint, the intersection is empty and `box`
 * stays. */
void csg_bound_union(csg_box *box, const csg_box *other);
void csg_bound_intersection(csg_box *box, const csg_box *other);

/** Half-spaces of an intersection, and of those around it, that are noted. */
enum { CSG_CUTS_MOST = 64 };

/** The work on them in one solid, as squares of words; beyond it they cut nothing. */
enum { CSG_CUT_WORK = 1 << 20 };

/** Note a half-space normal . y <= offset, in the frame of the node at hand, if there is room. */
void csg_add_cut(csg_reader *r, const fmpq *normal, const fmpq_t offset);

/** Note the half-space that csg_read_halfspace reads of this value. */
graze_status csg_read_cut(csg_reader *r, const json *value);

/** A cylinder of radius `size`, or a cone whose radius is `size` times the distance from its point,
 * in the frame of the node at hand. Borrowed. */
typedef struct csg_shaft {
    const fmpq *point, *axis, *length2, *size; /* length2: |axis|^2 */
    int is_cone;
} csg_shaft;

/** Find how far along its axis, in lengths of it, the body reaches within the half-spaces noted:
 * at most `out` if `upward`, else at least. Returns 0 if no half-space ends it. */
int csg_cut_height(fmpq_t out, csg_reader *r, const csg_shaft *body, int upward);

/** Cut the reader's box by the half-spaces from number `first` on, or make one of them. */
void csg_cut_box(csg_reader *r, int first);

/** Note a ball, or with an axis a capsule, in the frame of the node at hand. GRAZE_ESYSTEM */
graze_status csg_note_round(csg_reader *r, const fmpq *point, const fmpq *axis,
                            const fmpq_t radius);

/* The readers of primitives, each a csg_primitive_reader: in polyhedron.c, polynomial.c,
 * primitives.c. */

graze_status csg_read_polyhedron(size_t *node, csg_reader *r, const json *value);

graze_status csg_read_polynomial(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_polygon(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_halfspace(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_box(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_ball(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_ellipsoid(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_cylinder(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_cone(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_torus(size_t *node, csg_reader *r, const json *value);
graze_status csg_read_capsule(size_t *node, csg_reader *r, const json *value);

#endif
