/* Exact rationals as text: number tokens in, lowest terms out (src/program/cli/formats.md,
 * Numbers). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_NUMBER_RATIONAL_H
#define GRAZE_NUMBER_RATIONAL_H

#include <gmp.h>
#include <flint/fmpq.h>
#include "base/context/context.h"

/**
 * Read one number token exactly, then round it as context->rounding says. Forms: integer, decimal,
 * decimal with exponent, ratio of an integer and an unsigned integer; sign + or -; `.5` and `5.`.
 * No blanks inside. The digits limit counts digits with the exponent written out.
 * @return GRAZE_EINPUT (message quotes the token, shortened), GRAZE_ELIMIT
 */
graze_status rational_parse(fmpq_t out, graze_context *context, const char *text, size_t length);

/** 1 if the text is one number token of a form rational_parse reads, else 0. */
int rational_is_token(const char *text, size_t length);

/** 1 if numerator and denominator have no common factor and the denominator is positive; without a
 * gcd where the denominator has no prime but 2 and 5. */
int rational_is_canonical(const mpq_t value);

/** Integer or ratio in lowest terms, malloc'ed; NULL when out of memory. */
char *rational_text(const fmpq_t value);

/** Bytes that rational_write may need for a value. */
size_t rational_room(const fmpq_t value);
/** Write the text of rational_text and a NUL into rational_room bytes. Returns the text's length.
 */
size_t rational_write(char *text, const fmpq_t value);

#endif
