/* csg: a curved solid of a `.csg.json` file: a Boolean expression over signs of irreducible
 * polynomials.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_CSG_H
#define GRAZE_INPUT_CSG_H

#include <flint/fmpq.h>
#include <stdint.h>
#include "base/context/context.h"

/* A curved solid: a Boolean expression over the signs of polynomials.
 *
 * The solid is the closure of the open cells, of the arrangement of its surfaces, at which the
 * expression is true (proofs/curved.md C94). Surfaces are irreducible over Q and pairwise
 * distinct. */

/** Greatest degree of a polynomial that bounds a primitive. */
enum { CSG_DEGREE = 4 };

/** An irreducible polynomial with integer coefficients that have no common factor: its terms in a
 * fixed order of monomials, the first coefficient positive. */
typedef struct csg_surface {
    int degree;
    size_t count;
    fmpz *coefficient;
    unsigned char (*power)[3]; /* of x, y, z; that of z is 0 in the plane */
} csg_surface;

/** The condition under which a node is true. CSG_SIGN: the operands are surfaces, and an odd number
 * of them is negative. CSG_ALL, CSG_ANY, CSG_ODD: the operands are nodes, and all, any, or an odd
 * number of them are true.
 */
typedef enum csg_operation { CSG_SIGN, CSG_ALL, CSG_ANY, CSG_ODD } csg_operation;

typedef struct csg_node {
    csg_operation operation;
    int complement;      /* the node is true where its operation is false */
    size_t first, count; /* of the operands, in csg.operand */
    size_t primitive;    /* of a CSG_SIGN */
} csg_node;

/** A box that holds a set; low < high in each coordinate. */
typedef struct csg_box {
    int dimension; /* 0: no box is known */
    fmpq low[3], high[3];
} csg_box;

void csg_box_init(csg_box *box);
void csg_box_clear(csg_box *box);

/** A primitive; csg.primitive has the order of the file. */
typedef struct csg_primitive {
    char *title;  /* such as `ball 2 "tip"` */
    fmpq *middle; /* 3: the centre of a box that holds it; 0 if no box is known */
} csg_primitive;

/** The points at most `radius` from a point or a segment, its ends one after the other. */
typedef struct csg_round {
    int ends;  /* 1 or 2 */
    fmpq *end; /* 6 */
    fmpq_t radius;
} csg_round;

/** How a solid is taken: by its expression, or, if all its surfaces are planes (in the plane
 * lines), by its facets, if it has some, is bounded and within 2^890 of the origin. */
typedef enum csg_form { CSG_CURVED, CSG_FACETS, CSG_EMPTY, CSG_UNBOUNDED, CSG_WIDE } csg_form;

/** The operands of a node, if not surfaces, are nodes before it; the last node is the solid. */
typedef struct csg {
    int dimension;
    csg_form form;
    size_t surface_count, surface_capacity, node_count, node_capacity;
    size_t operand_count, operand_capacity, primitive_count, primitive_capacity;
    csg_surface *surface;
    csg_node *node;
    size_t *operand;
    csg_primitive *primitive;
    csg_box box;
    size_t round_count, round_capacity;
    csg_round *round; /* the balls and capsules, in the order of the file */
    int not_round;    /* 1: the solid is not the union of these alone, with rational radii */
} csg;

void csg_clear(csg *solid);

/** The sign of a surface's polynomial at a point.
 * @param x coordinates, then their common denominator, positive */
int csg_surface_sign(const csg_surface *surface, const fmpz *x, int dimension);

/** The most surfaces whose signs are free in a truth table, and the most 64-bit words of such a
 * table. */
enum { CSG_FREE_MOST = 12, CSG_TABLE_WORDS = 1 << (CSG_FREE_MOST - 6) };

/** The number of 64-bit words of the truth table of `free` surfaces; its bits past 2^free are 0. */
size_t csg_table_words(int free);

/**
 * The truth table of the solid's expression over all signs of the free surfaces: bit s of `out` is
 * its truth where, for each k, free surface k is negative iff bit k of s is set.
 * @param sign by surface: -1, 1, or 2 + k for free surface k
 * @param work room for node_count * csg_table_words(free) words
 */
void csg_table(uint64_t *out, uint64_t *work, const csg *solid, const signed char *sign, int free);

/** Set `out` to an upper bound of the square root of a number >= 0, or to the root if it is
 * rational. */
void csg_upper_root(fmpq_t out, const fmpq_t value);

/** Whether the rows of a matrix are those of a rotation or reflection times a number.
 * @param[out] square the mean of the squared lengths of the rows
 * @param matrix d rows of d numbers and `width` - d others that do not count */
int csg_similar(fmpq_t square, const fmpq *matrix, int d, int width);

/** Set `out` to that number, or near it; returns 0 if there is none or it is irrational. */
int csg_scale(fmpq_t out, const fmpq *matrix, int d, int width);

/* Curved solids of `.csg.json` files (src/program/cli/formats.md, Curved solids). */

/**
 * Read a file.
 * @param[out] out    on success cleared by csg_clear
 * @param[out] sha256 of the file's bytes
 * @return GRAZE_ESYSTEM, GRAZE_EINPUT, GRAZE_EILLEGAL, GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status csg_read(csg *out, unsigned char sha256[32], graze_context *context, const char *path);

/** As csg_read, from a text that messages call `name`. */
graze_status csg_read_text(csg *out, graze_context *context, const char *name, const char *text,
                           size_t length);

#endif
