/* A surface along a span of a curve: its pullback in Bernstein form, with a bound for its errors.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_FILTER_SURFACE_CURVE_H
#define GRAZE_FILTER_SURFACE_CURVE_H

#include "decide/filter/curve.h"
#include "decide/filter/surfaces.h"

/** Products of a span's coordinates that were made, coefficient k times the binomial, and bounds of
 * the coefficients without it and of their errors (proofs/surfaces.md C105). */
typedef struct span_products {
    unsigned char made[PRODUCT_MOST];
    double size[PRODUCT_MOST], error[PRODUCT_MOST];
} span_products;

/** Products by span, of one thread; used again from curve to curve. */
typedef struct surface_curve {
    const surface_filter *filter;
    const curve *curve;
    size_t stride; /* of a product's coefficients */
    size_t known, known_room, count, count_room, room;
    uint32_t *of_span; /* 1 + the products of a span; 0: none yet */
    span_products *products;
    double *at;
} surface_curve;

/** Begin with a curve. */
void surface_curve_begin(surface_curve *m, const surface_filter *filter, const curve *curve);
void surface_curve_clear(surface_curve *m);

/** The sign of a surface on the set that holds a bounded span, perhaps of several pieces; 0 if it
 * is not certain (proofs/surfaces.md C106). */
int surface_sign_on(const surface_filter *filter, size_t surface, const span *piece);

/**
 * The pullback of a surface on a span that is a piece, or a part of one.
 * @param at room for PULLBACK_DEGREE + 1 coefficients
 * @return 0 if the numbers are beyond the filter, or without memory
 */
int surface_curve_pull_back(pullback *out, double *at, surface_curve *m, uint32_t span_index,
                            size_t surface);

#endif
