/* Isolation of roots that lie close together.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_CLUSTER_H
#define GRAZE_NUMBER_CLUSTER_H

#include "base/number/algebraic.h"

/** Halvings of the first interval that are made with exact coefficients. The degree is less than
 * 2^(EXACT_HALVINGS - 4), so that the intervals left are short enough for this degree
 * (proofs/separation.md C41). */
enum { EXACT_HALVINGS = 32 };

/** A search for the roots of `poly` in the interval `whole`, with the roots found so far in `list`.
 * If the search goes on at two sign changes or more, all roots of `poly` in the open interval are
 * simple.
 */
typedef struct root_search {
    algebraic_list *list;
    graze_context *context;
    const fmpz_poly_struct *poly;
    const dyadic_interval *whole;
} root_search;

/** Append the one root in the open interval, a simple one; no end is a root. `low_sign` is the sign
 * of `poly` at the lower end. */
void root_search_append(const root_search *s, const dyadic_interval *interval, int low_sign);

/**
 * Append the roots in an open interval that EXACT_HALVINGS halvings have left of the whole one,
 * ascending (C42, C43). `poly` has no repeated factor.
 * @param low_sign, high_sign the signs of `poly` at the interval's ends
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status root_search_cluster(const root_search *s, const dyadic_interval *interval,
                                 int low_sign, int high_sign);

#endif
