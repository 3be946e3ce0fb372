/* The order of real algebraic numbers, and dyadic numbers between them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_ORDER_H
#define GRAZE_NUMBER_ORDER_H

#include "base/number/algebraic.h"

/** Set *out to the sign of x - y: -1, 0, 1 (proofs/claims.md C26). Equal numbers share interval and
 * polynomial afterwards. */
graze_status algebraic_compare(int *out, graze_context *context, algebraic *x, algebraic *y);

/** Set `out` to a dyadic number strictly between x and y, x < y. */
graze_status algebraic_between(fmpq_t out, graze_context *context, algebraic *x, algebraic *y);

/** Set *out to the least m for which a multiple of 2^-m lies strictly between x and y, x < y, both
 * irrational and in intervals that have at most an end in common. */
graze_status algebraic_places_between(ulong *out, graze_context *context, algebraic *x,
                                      algebraic *y);

/** Sort pointers to numbers ascending; equal numbers keep their order. */
graze_status algebraic_sort(algebraic **order, size_t count, graze_context *context);

/**
 * Sort, and keep one pointer for equal numbers; *count becomes the number of different ones.
 * @param[out] rank_of its entry k becomes the rank of the number first[k]; NULL, with `first` NULL,
 * for no ranks
 */
graze_status algebraic_sort_once(algebraic **order, size_t *count, graze_context *context,
                                 const algebraic *first, size_t *rank_of);

#endif
