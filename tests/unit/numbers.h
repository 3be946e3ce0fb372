/* The functions of algebraic.h without a context, where nothing can end them early.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TESTS_UNIT_NUMBERS_H
#define GRAZE_TESTS_UNIT_NUMBERS_H

#include "base/number/isolate.h"

static inline void append_roots(algebraic_list *list, const fmpz_poly_t p,
                                const dyadic_interval *interval) {
    assert_int_equal(algebraic_roots(list, NULL, p, interval), GRAZE_OK);
}

static inline int order_of(algebraic *x, algebraic *y) {
    int order;
    assert_int_equal(algebraic_compare(&order, NULL, x, y), GRAZE_OK);
    return order;
}

static inline int sign_of(const fmpz_poly_t q, algebraic *x) {
    int sign;
    assert_int_equal(algebraic_sign_at(&sign, NULL, q, x), GRAZE_OK);
    return sign;
}

#endif
