/* Times in sentences and pictures: as numbers, or from t0 where that is large (time_origin).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_TIME_TEXT_H
#define GRAZE_REPORT_TIME_TEXT_H

#include "base/number/text.h"

/** `1/3`, or `t0 + 0.02`, with a ratio where no short decimal is the number itself. */
void tell_rational_time(text *out, const graze_motion *motion, const fmpq_t time);

/** `1/2 = 0.5`, `1/3, about 0.333333333333`, `t0 + 1/3, about t0 + 0.333333333333`, or the root
 * with its polynomial and interval. */
void tell_time(text *out, const graze_time *time);

/** Append an irrational time as a decimal with `digits` digits. */
void tell_near_time(text *out, const graze_time *time, int digits);

/** Append a sentence with the value of t0, if times are given relative to it. */
void tell_time_origin(text *out, const graze_motion *motion);

#endif
