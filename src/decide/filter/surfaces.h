/* The surfaces of a curved solid in doubles: what its filter evaluates, and a tree of boxes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SURFACES_H
#define GRAZE_FILTER_SURFACES_H

#include "decide/filter/course.h"
#include "decide/filter/expression_tree.h"
#include "decide/filter/span_pullback.h"
#include "input/solid/corners.h"
#include "input/solid/tree.h"

/** Products of at most CSG_DEGREE of four coordinates: C(8, 4) - 1. */
enum { PRODUCT_MOST = 69 };

/** A product of homogeneous coordinates; of degree 1 the coordinate alone. The parent has one
 * degree less, and stands before it. */
typedef struct product {
    unsigned char degree, parent, coordinate;
} product;

/** The homogeneous polynomial of a surface, scaled by a positive number so that the largest
 * coefficient is in [1/2, 1); each is within 2^-52 of itself, or below 2^-1000. */
typedef struct surface_form {
    int degree, count;
    unsigned char *product; /* of each term */
    double *coefficient;
} surface_form;

/** The filter of a curved solid under a motion; immutable, shared by threads. */
typedef struct surface_filter {
    course course;
    corners reach; /* of the boxes; no corners */
    int product_count, degree;
    product product[PRODUCT_MOST];
    size_t surface_count;
    surface_form *surface;
    /* Surfaces whose polynomials are positive outside a box: box k is that of boxed[k]; and all
     * others. */
    tree boxes;
    uint32_t *boxed, *open;
    size_t boxed_count, open_count;
    expression_tree expression;
    double binomial[PULLBACK_DEGREE + 1][PULLBACK_DEGREE + 1];
    double inverse[PULLBACK_DEGREE + 1][PULLBACK_DEGREE + 1]; /* of the binomials */
} surface_filter;

/**
 * @param[out] out NULL if degrees or sizes are beyond the filter
 * @return GRAZE_ESYSTEM
 */
graze_status surface_filter_make(surface_filter **out, graze_context *context, const csg *solid,
                                 const graze_motion *motion, graze_operation operation);
/** NULL is harmless. */
void surface_filter_free(surface_filter *f);

#endif
