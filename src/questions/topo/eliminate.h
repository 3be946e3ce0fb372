/* Resultants of plane curves.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TOPO_ELIMINATE_H
#define GRAZE_TOPO_ELIMINATE_H

#include <flint/fmpz_poly.h>
#include "questions/topo/plane.h"

/** A polynomial in x and y as a polynomial in one variable with coefficients in the other. */
typedef struct sliced_curve {
    slong degree, total; /* in the variable; of the whole polynomial */
    fmpz_poly_struct *coefficient;
} sliced_curve;

/** @param variable RING_X or RING_Y; `g` is not 0 */
void sliced_init(sliced_curve *out, const fmpz_mpoly_t g, int variable,
                 const fmpz_mpoly_ctx_t ring);
/** Make the derivative of a curve by the variable, in which it has a positive degree. */
void sliced_init_derivative(sliced_curve *out, const sliced_curve *s);
void sliced_clear(sliced_curve *s);

/** Evaluate a curve at `at` of the other variable; returns 0 if the degree drops there. */
int sliced_at(fmpz_poly_t out, const sliced_curve *s, const fmpz_t at);

/** The resultant of two curves of positive degree, as a polynomial in the other variable. A bound
 * of its degree follows from weights: every term of the resultant has the degree deg b in the
 * coefficients of a and deg a in those of b, and its indices sum up to deg a deg b. */
graze_status eliminate(fmpz_poly_t out, graze_context *context, const sliced_curve *a,
                       const sliced_curve *b);

/** The resultant of two polynomials that are not 0. */
graze_status resultant_of(fmpz_t out, graze_context *context, const fmpz_poly_t f,
                          const fmpz_poly_t g);

#endif
