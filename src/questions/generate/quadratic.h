/* Rational zeros of polynomials of degree at most 2.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_GENERATE_QUADRATIC_H
#define GRAZE_GENERATE_QUADRATIC_H

#include <flint/fmpq_mpoly.h>

/** The polynomial v' form v + slope . v + value at the place start + v; one array. */
typedef struct quadratic {
    int count; /* of variables */
    fmpq *start, *slope, *value, *form;
} quadratic;

void quadratic_init(quadratic *q);
void quadratic_set(quadratic *to, const quadratic *from);
void quadratic_clear(quadratic *q);

/** Read the polynomial in the first `count` variables of a ring, from the start 0. */
void quadratic_read(quadratic *q, const fmpq_mpoly_t p, int count, const fmpq_mpoly_ctx_t ring);

/** Start from the place where the gradient is zero; 0 if there is none, and q stays. */
int quadratic_center(quadratic *q);

/** Start from a zero with a gradient; 0 if the search finds none: along directions of small
 * integers through the centre, and along axes beside it. */
int quadratic_find_zero(quadratic *q);

/** The direction of a line of zeros through a zero x: of a cylinder or a cone in space; else 0. */
int quadratic_ruling(fmpq *out, const quadratic *q, const fmpq *x);

/** The place of the other zero on the line along `direction` through the start, a zero; 0 if there
 * is none. */
int quadratic_other_zero(fmpq *out, const quadratic *q, const fmpq *direction);

#endif
