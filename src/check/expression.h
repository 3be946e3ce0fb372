/* Expressions of a motion file: text to a quotient of polynomials in t.
 * SPDX-License-Identifier: MIT
 */
#ifndef CHECK_EXPRESSION_H
#define CHECK_EXPRESSION_H

#include "poly.h"

/**
 * Numbers, + - * / ^ with a whole exponent, brackets, t and s. ^ binds tighter than the sign before
 * it; a^b^c is none. Gives up at anything else.
 * @param s what s stands for, a polynomial in t; NULL: neither t nor s may occur
 */
void expression_read(fraction *out, word text, const fraction *s, const char *path, size_t line);

#endif
