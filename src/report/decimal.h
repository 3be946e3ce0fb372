/* Correctly rounded decimals of exact numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_REPORT_DECIMAL_H
#define GRAZE_REPORT_DECIMAL_H

#include "trace/trace.h"

/**
 * A number rounded to nearest (ties to even) at `digits` significant decimal digits, malloc'ed;
 * NULL when out of memory. Positional from 10^-5 up to as many places as there are digits, else
 * with an exponent (`1.5e-9`). Trailing zeros are left out where the decimal is the number itself.
 * @param[out] exact 1 if the decimal is the number itself, else 0; may be NULL
 */
char *decimal_of_rational(int *exact, const fmpq_t value, int digits);

/** The same for a time, in the motion's parameter. Makes the time canonical. */
char *decimal_of_time(int *exact, const graze_time *time, int digits);

/** 1 if the time is rational; makes it canonical, and then its value is time->low. */
int time_is_rational(const graze_time *time);

#endif
