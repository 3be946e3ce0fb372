/* Times as text: exact, and as correctly rounded decimals.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_REPORT_DECIMAL_TIME_H
#define GRAZE_REPORT_DECIMAL_TIME_H

#include "base/number/decimal.h"
#include "base/number/text.h"
#include "decide/trace/trace.h"

/** The decimal of a time in the motion's parameter, as decimal_of_rational makes it. The time
 * becomes canonical. */
char *decimal_of_time(int *exact, const graze_time *time, int digits);
/** The decimal of a time minus `since`, likewise. */
char *decimal_of_time_since(int *exact, const graze_time *time, const fmpq_t since, int digits);

/** Find the origin of times in texts: the motion's start, if it is large compared with the motion's
 * length, as seconds since 1970 are; then 1 is returned. Else the origin is 0, and 0 is returned.
 * `origin` may be NULL. */
int time_origin(fmpq *origin, const graze_motion *motion);

/** Is a time rational? Makes it canonical; the value of a rational time is time->low. */
int time_is_rational(const graze_time *time);

/** Append a canonical time: a ratio, or root(c0 c1 ...;a;b); nothing for NULL. */
void report_put_time(text *t, const graze_time *time);
/** Append a rational or a canonical time, a comma, and its decimal of 17 digits; only a comma for
 * NULL.
 */
void report_put_rational_near(text *t, const fmpq_t value);
void report_put_time_near(text *t, const graze_time *time);

#endif
