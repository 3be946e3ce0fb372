/* Bernstein coefficients on a short interval inside [0, 1], to a given number of binary places, by
 * the few Taylor coefficients that matter there (proofs/separation.md C41).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_LOCAL_H
#define GRAZE_NUMBER_LOCAL_H

#include <flint/fmpz_poly.h>
#include "base/context/context.h"

/** An interval [low, low + width] / 2^places inside [0, 1], 2 (n + 1) width <= 2^places for the
 * degree n of the polynomial in question. */
typedef struct local_interval {
    fmpz_t low, width;
    ulong places;
} local_interval;

void local_interval_init(local_interval *x);
void local_interval_clear(local_interval *x);
void local_interval_set(local_interval *x, const local_interval *other);
/** The upper end is `out` / 2^places. */
void local_interval_high(fmpz_t out, const local_interval *x);

/** b[0] ... b[degree], each within `error` of one positive number times a Bernstein coefficient. */
typedef struct local_form {
    slong degree;
    fmpz *b;
    fmpz_t error;
} local_form;

/** Zeros. */
void local_form_init(local_form *form, slong degree);
void local_form_clear(local_form *form);

/**
 * Set a form to the coefficients on an interval of q, which has the form's degree.
 * @param precision the positive number by which coefficients are multiplied is at least
 * 2^precision; `error` depends on the degree alone
 * @return GRAZE_ECANCELED; `context` may be NULL
 */
graze_status local_form_set(local_form *form, graze_context *context, const fmpz_poly_t q,
                            const local_interval *x, ulong precision);

/** 1 if bit lengths show that some coefficient is more than 2^bits times as large as the error. */
int local_form_is_sharp(const local_form *form, ulong bits);

/**
 * The most sign changes that the exact coefficients can have, zeros left out. `first` and `last`
 * are the exact signs of the first and the last coefficient.
 */
slong local_form_variations(const local_form *form, int first, int last);

/** Guess the middle of a cluster: of the points 0 ... 2^gain that divide the interval into equal
 * parts, the one nearest to the root of the linear function with the end values of the derivative
 * of order `order` < degree. */
void local_form_center(fmpz_t out, const local_form *form, slong order, ulong gain);

#endif
