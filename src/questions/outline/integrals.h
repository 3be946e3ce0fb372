/* Integrals over parts of curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_OUTLINE_INTEGRALS_H
#define GRAZE_QUESTIONS_OUTLINE_INTEGRALS_H

#include <flint/fmpz_poly.h>
#include "base/context/context.h"
#include "base/number/algebraic.h"
#include "questions/outline/outline.h"
#include "questions/outline/bracket.h"

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
