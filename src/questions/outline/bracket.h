/* Intervals with fixed binary places, places of curves in them, and integrals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_BRACKET_H
#define GRAZE_QUESTIONS_OUTLINE_BRACKET_H

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>
#include "questions/outline/outline.h"

/* A bracket holds a real number: low <= 2^places x <= high, where the caller keeps `places`.
 * Results are rounded outward; an output may be an input. */

void bracket_init(bracket *x);
void bracket_clear(bracket *x);
void point_place_init(point_place *p);
void point_place_clear(point_place *p);
void bracket_set(bracket *x, const bracket *y);
void bracket_set_rational(bracket *x, const fmpq_t value, ulong places);
void bracket_low(fmpq_t out, const bracket *x, ulong places);
void bracket_high(fmpq_t out, const bracket *x, ulong places);

void bracket_add(bracket *out, const bracket *a, const bracket *b);
void bracket_sub(bracket *out, const bracket *a, const bracket *b);
void bracket_mul(bracket *out, const bracket *a, const bracket *b, ulong places);
/** Divide; returns 0, and `out` has no meaning, where b may be 0. */
int bracket_div(bracket *out, const bracket *a, const bracket *b, ulong places);
/** The square root of what is not below 0 in a, whose upper end is not; returns 0 where a may be 0
 * or less. */
int bracket_sqrt(bracket *out, const bracket *a, ulong places);
/** The sign of a number; 0 where it is not known, or zero. */
int bracket_sign(const bracket *x);
/** Have two brackets a number in common? */
int bracket_meets(const bracket *a, const bracket *b);
/** Widen `out` to hold x too. */
void bracket_join(bracket *out, const bracket *x);

/** A polynomial at a number. */
void bracket_evaluate(bracket *out, const fmpz_poly_t p, const bracket *at, ulong places);

/** The bracket of an algebraic number, at most two units wide; the number is narrowed.
 * GRAZE_ELIMIT, GRAZE_ECANCELED. */
graze_status bracket_of_number(bracket *out, graze_context *context, algebraic *x, ulong places);

/** Both coordinates of a curve at a parameter, each at most 2^-places wide; the parameter is
 * narrowed.
 * @param[out] xy two brackets */
graze_status outline_curve_place(bracket *xy, graze_context *context, outline_curve *c,
                                 algebraic *s, ulong places);

/* Integrals over parts of curves (integrals.c). */

/** The function num/den or, if `root`, sqrt(num)/den; den > 0. */
typedef struct integrand {
    fmpz_poly_t num, den;
    int root;
} integrand;

/**
 * Enclose the integral of a function between two numbers.
 * @param places kept in all numbers
 * @param bits   the bits that the width of each part may have, in units of 2^-places
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status integral_between(bracket *out, graze_context *context, const integrand *f,
                              algebraic *from, algebraic *to, ulong places, ulong bits);

#endif
