/* surfaces: the surfaces of a curved solid in doubles, and its expression, updated sign by sign.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_SURFACES_H
#define GRAZE_DECIDE_SURFACES_H

#include "decide/bounds/bounds.h"
#include "input/csg/csg.h"
#include "input/motion/motion.h"
#include "input/solid/solid.h"

/* The expression of a curved solid as a tree, updated by one change of sign at a time. */

/** The tree, with the parent of each node and the nodes of each surface; `count` and `is_true` have
 * their values for all surfaces positive. */
typedef struct expression_tree {
    const csg *solid;       /* borrowed */
    uint32_t *first, *node; /* nodes of surface k: node[first[k]] ... node[first[k + 1] - 1] */
    uint32_t *parent;       /* UINT32_MAX of the root */
    uint32_t *count;        /* by node: the number of its true operands */
    unsigned char *is_true; /* by node */
} expression_tree;

/** The truths of the nodes in one thread, and the surfaces' signs. */
typedef struct truths {
    size_t node_room, sign_room;
    uint32_t *count;
    unsigned char *is_true;
    signed char *sign; /* by surface: 1, -1 */
} truths;

/** Make the tree; 0 if memory runs out. The caller calls expression_tree_clear in either case. */
int expression_tree_make(expression_tree *out, const csg *solid);
void expression_tree_clear(expression_tree *t);

/** Begin with all surfaces positive; 0 if memory runs out. */
int truths_begin(truths *m, const expression_tree *t);
void truths_clear(truths *m);

/** Change the sign of a surface. */
void truths_flip(truths *m, const expression_tree *t, size_t surface);

/** Is the expression true? */
int truths_all(const truths *m, const expression_tree *t);

/* The surfaces of a curved solid in doubles: what its filter evaluates, and a tree of boxes. */

/** The number of products of 1 to CSG_DEGREE factors, each one of four coordinates: C(8, 4) - 1. */
enum { PRODUCT_MOST = 69 };

/** A product of homogeneous coordinates: its parent, a product of one degree less that stands
 * before it in the list, times a coordinate; for degree 1 the coordinate alone. */
typedef struct product {
    unsigned char degree, parent, coordinate;
} product;

/** The homogeneous polynomial of a surface, scaled by a positive number so that the largest
 * coefficient is in [1/2, 1); each coefficient has a relative error of at most 2^-52, or is below
 * 2^-1000 and set to 0. */
typedef struct surface_form {
    int degree, count;
    unsigned char *product; /* of each term */
    double *coefficient;
} surface_form;

/** The filter of a curved solid under a motion; immutable, shared by threads. */
typedef struct surface_filter {
    course course;
    corners reach; /* only the bounds of coordinates are set: those of the boxes */
    int product_count, degree;
    product product[PRODUCT_MOST];
    size_t surface_count;
    surface_form *surface;
    /* Surfaces whose polynomials are positive outside a box: box k belongs to surface boxed[k]. All
     * other surfaces are in `open`. */
    tree boxes;
    uint32_t *boxed, *open;
    size_t boxed_count, open_count;
    expression_tree expression;
    double binomial[PULLBACK_DEGREE + 1][PULLBACK_DEGREE + 1];
    double inverse[PULLBACK_DEGREE + 1][PULLBACK_DEGREE + 1]; /* the reciprocals of the binomials */
} surface_filter;

/**
 * @param[out] out NULL if degrees or sizes are beyond the filter
 * @return GRAZE_ESYSTEM
 */
graze_status surface_filter_make(surface_filter **out, graze_context *context, const csg *solid,
                                 const graze_motion *motion, graze_operation operation);
/** NULL is harmless. */
void surface_filter_free(surface_filter *f);

/* A surface along a span of a curve: its pullback in Bernstein form, with a bound for its errors.
 */

/** The products of a span's coordinates: which of them are made, and for each bounds of its
 * Bernstein coefficients and of their errors. The coefficients are kept, times their binomials, in
 * surface_curve (proofs/surfaces.md C105). */
typedef struct span_products {
    unsigned char made[PRODUCT_MOST];
    double size[PRODUCT_MOST], error[PRODUCT_MOST];
} span_products;

/** The products of a curve's spans, in one thread; its memory is used again for the next curve. */
typedef struct surface_curve {
    const surface_filter *filter;
    const curve *curve;
    size_t stride; /* number of coefficients kept for a product */
    size_t known, known_room, count, count_room, room;
    uint32_t *of_span; /* by span: 1 + its index in `products`; 0: it has none yet */
    span_products *products;
    double *at;
} surface_curve;

/** Begin with a curve. */
void surface_curve_begin(surface_curve *m, const surface_filter *filter, const curve *curve);
void surface_curve_clear(surface_curve *m);

/** The sign of a surface's polynomial on the thick chord of a bounded span, perhaps of several
 * pieces; 0 if it is not certain (proofs/surfaces.md C106). */
int surface_sign_on(const surface_filter *filter, size_t surface, const span *piece);

/**
 * The pullback of a surface on a span that is a piece, or a part of one.
 * @param at room for PULLBACK_DEGREE + 1 coefficients
 * @return 0 if the numbers are beyond the filter, or if memory runs out
 */
int surface_curve_pull_back(pullback *out, double *at, surface_curve *m, uint32_t span_index,
                            size_t surface);

/* The box of a bounded quadric. */

/** A box such that the polynomial is positive outside; 0 if none is known: only a quadric with a
 * positive definite form has one (proofs/surfaces.md C104). */
int surface_box(box *out, const csg_surface *surface, int dimension);

#endif
