/* Errors of values: their number, sides, quantiles and the largest.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Memory does not grow with the rows: errors are counted by their two leading digits, rounded up.
 */
#ifndef GRAZE_COMPARE_ERRORS_H
#define GRAZE_COMPARE_ERRORS_H

#include "output/compare/ceiling.h"

/** Errors below the first decade count as its least number; those past the last one are counted
 * alone. */
enum { FIRST_DECADE = -99, LAST_DECADE = 99, DECADES = LAST_DECADE - FIRST_DECADE + 1 };

typedef struct errors {
    unsigned long rows;          /* values judged */
    unsigned long over, under;   /* above and below the enclosure; the others are within */
    unsigned long beyond;        /* by more than the tolerance */
    unsigned long past;          /* errors past the last decade */
    unsigned long *bin[DECADES]; /* by two digits, 10 to 99; NULL: none */
    ceiling largest, largest_over;
} errors;

/** An error: its size, side (1 above, -1 below, 0 within the enclosure), and whether it is more
 * than the tolerance. */
typedef struct value_error {
    ceiling size;
    int side, beyond;
} value_error;

/** Count an error. 0 when out of memory. */
int errors_add(errors *e, value_error one);

/** The least number of two digits (of the largest error if that is past the last decade) that at
 * least `per_mille` thousandths of the errors do not exceed; 0 of none. */
ceiling errors_quantile(const errors *e, unsigned long per_mille);

void errors_clear(errors *e);

#endif
