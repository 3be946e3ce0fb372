/* Isolation of roots that lie close together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_CLUSTER_H
#define GRAZE_NUMBER_CLUSTER_H

#include "base/number/algebraic.h"

/** Halvings of the first interval that are made with exact coefficients. The degree is less than
 * 2^(EXACT_HALVINGS - 4), so that what is left is short for it (proofs/separation.md C41). */
enum { EXACT_HALVINGS = 32 };

/** The roots of `poly` found so far in the interval `whole`. `poly` has only simple roots in the
 * open interval whenever a branch goes on with two sign changes or more. */
typedef struct root_search {
    algebraic_list *list;
    graze_context *context;
    const fmpz_poly_struct *poly;
    const dyadic_interval *whole;
} root_search;

/** Append the one root in the open interval, a simple one; no end is a root. */
void root_search_append(const root_search *s, const dyadic_interval *interval, int low_sign);

/**
 * Append the roots in an open interval that EXACT_HALVINGS halvings have left of the whole one,
 * ascending (C42, C43). `poly` has no repeated factor.
 * @param low_sign, high_sign the signs of the polynomial at its ends
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status root_search_cluster(const root_search *s, const dyadic_interval *interval,
                                 int low_sign, int high_sign);

#endif
