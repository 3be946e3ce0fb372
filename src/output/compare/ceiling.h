/* Numbers rounded up to a few decimal digits, for reports.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_CEILING_H
#define GRAZE_COMPARE_CEILING_H

#include <flint/fmpq.h>

/** digits * 10^(exponent - 5) with 100000 <= digits <= 999999, the least such number that is not
 * below the one it was made of; digits 0: zero. */
typedef struct ceiling {
    unsigned long digits;
    long exponent;
} ceiling;

/** The ceiling of a number that is not negative. */
ceiling ceiling_of(const fmpq_t x);

/** Negative, 0 or positive as a is less than, equal to or greater than b. */
int ceiling_compare(ceiling a, ceiling b);

/** The bound rounded up to two digits. */
ceiling ceiling_short(ceiling c);

/** As 1.5e-05, without zeros at the end of the digits; zero is 0. */
enum { CEILING_ROOM = 48 };
void ceiling_text(char out[CEILING_ROOM], ceiling c);

/** The k with 10^k <= x < 10^(k + 1), of a positive number. */
long decade_of(const fmpq_t x);

#endif
