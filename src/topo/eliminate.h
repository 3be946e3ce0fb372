/* Resultants and discriminants of plane curves.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_ELIMINATE_H
#define GRAZE_TOPO_ELIMINATE_H

#include <flint/fmpz_poly.h>
#include "topo/curves.h"

/** A polynomial in x and y as one in x (or y), whose coefficients are polynomials in the other. */
typedef struct sliced_curve {
    slong degree, total; /* in the variable, and of the curve */
    fmpz_poly_struct *coefficient;
} sliced_curve;

/** @param variable RING_X or RING_Y; `g` is not 0 and free of t */
void sliced_init(sliced_curve *out, const fmpz_mpoly_t g, int variable, const curve_list *list);
void sliced_clear(sliced_curve *s);

/**
 * The resultant of two curves, or with `b` NULL the discriminant of one of degree at least 1, as a
 * polynomial in the other variable, by its values at integers where no degree drops. Its degree is
 * bounded by the weights of the terms: every term of the resultant is homogeneous of degree deg b
 * in the coefficients of a and deg a in those of b, and its indices sum up to deg a deg b.
 */
graze_status eliminate(fmpz_poly_t out, graze_context *context, const sliced_curve *a,
                       const sliced_curve *b);

#endif
