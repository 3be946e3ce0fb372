/* The signs of a few polynomials along a piece of the motion, and the events they make.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_SIGN_EVENTS_H
#define GRAZE_ENVELOPE_SIGN_EVENTS_H

#include "questions/envelope/axis.h"

/** The first `rooted` polynomials have their roots among the points. The signs of polynomial p are
 * at[k * count + p] at point k of the axis, and before[k * count + p] between points k - 1 and k.
 */
typedef struct signs {
    size_t count, rooted;
    axis x;
    fmpz_poly_struct *p;
    signed char *at, *before;
} signs;

/** Zero polynomials, to be set before signs_find. */
void signs_init(signs *s, size_t count, size_t rooted);
void signs_clear(signs *s);
graze_status signs_find(signs *s, graze_context *context);

/** The signs of all polynomials at point k and before it. */
const signed char *signs_at(const signs *s, size_t k);
const signed char *signs_before(const signs *s, size_t k);

#endif
