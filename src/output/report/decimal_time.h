/* Times as text: exact, and as correctly rounded decimals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_REPORT_DECIMAL_TIME_H
#define GRAZE_REPORT_DECIMAL_TIME_H

#include "base/number/decimal.h"
#include "base/number/text.h"
#include "decide/trace/trace.h"

/** decimal_of_rational for a time, in the motion's parameter. Makes the time canonical. */
char *decimal_of_time(int *exact, const graze_time *time, int digits);
/** The same of what a time is later than another one. */
char *decimal_of_time_since(int *exact, const graze_time *time, const fmpq_t since, int digits);

/** The time from which texts tell times: the motion's start where it is large beside the motion's
 * length, such as seconds since 1970, and 1 is returned; else 0 and 0. `origin` may be NULL. */
int time_origin(fmpq *origin, const graze_motion *motion);

/** 1 if the time is rational; makes it canonical, and then its value is time->low. */
int time_is_rational(const graze_time *time);

/** A canonical time: a ratio, or root(c0 c1 ...;a;b); nothing for NULL. */
void report_put_time(text *t, const graze_time *time);
/** A rational or a canonical time, a comma, and its decimal of 17 digits; a comma alone for NULL.
 */
void report_put_rational_near(text *t, const fmpq_t value);
void report_put_time_near(text *t, const graze_time *time);

#endif
