/* Times in sentences, relative to t0 if t0 is large.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/report/row_parts.h"

#include "base/context/scope.h"

enum { DECIMAL_DIGITS = 12 };

/* Append `t0 + number`, where `number` is the text of the difference of a time from t0. */
static void put_later(text *out, const char *number) {
    int negative = number[0] == '-';
    text_put(out, "t0");
    if (number[0] != '0' || number[1])
        text_format(out, negative ? " - %s" : " + %s", number + negative);
}

static void put_later_ratio(text *out, const fmpq_t later) {
    HELD(text, ratio);
    formula_rational(&ratio, later);
    put_later(out, ratio.failed ? "" : ratio.data);
    out->failed |= ratio.failed;
}

/* Append a time as a ratio, or from a large t0 on as an exact short decimal if there is one. If
 * `with_near`, a decimal follows the ratio. */
static void put_told(text *out, const graze_motion *motion, const fmpq_t time, int with_near) {
    LOCAL_VEC(fmpq, origin, 2);
    fmpq *later = origin + 1;
    int exact;
    int is_large = time_origin(origin, motion);
    fmpq_sub(later, time, origin);
    FREED(char, decimal, decimal_of_rational(&exact, later, DECIMAL_DIGITS));
    out->failed |= !decimal;
    if (!is_large) {
        formula_rational(out, time);
        if (with_near && (!fmpz_is_one(fmpq_denref(time)) || !exact))
            text_format(out, exact ? " = %s" : ", about %s", decimal ? decimal : "");
    } else if (exact && decimal) {
        put_later(out, decimal);
    } else {
        put_later_ratio(out, later);
        if (with_near)
            text_put(out, ", about ");
        if (with_near && decimal)
            put_later(out, decimal);
    }
}

void tell_rational_time(text *out, const graze_motion *motion, const fmpq_t time) {
    put_told(out, motion, time, 0);
}

void tell_near_time(text *out, const graze_time *time, int digits) {
    LOCAL(fmpq, origin);
    int is_large = time_origin(origin, time->motion);
    FREED(char, decimal, decimal_of_time_since(NULL, time, origin, digits));
    out->failed |= !decimal;
    if (is_large && decimal)
        put_later(out, decimal);
    else
        text_put(out, decimal ? decimal : "");
}

void tell_time(text *out, const graze_time *time) {
    if (time_is_rational(time)) {
        put_told(out, time->motion, time->low, 1);
        return;
    }
    text_put(out, "about ");
    tell_near_time(out, time, DECIMAL_DIGITS);
    text_put(out, ", the one root of ");
    formula_polynomial(out, time->poly);
    text_put(out, " between ");
    tell_rational_time(out, time->motion, time->low);
    text_put(out, " and ");
    tell_rational_time(out, time->motion, time->high);
}

void tell_time_origin(text *out, const graze_motion *motion) {
    int exact;
    LOCAL(fmpq, origin);
    if (time_origin(origin, motion)) {
        FREED(char, decimal, decimal_of_rational(&exact, origin, DECIMAL_DIGITS));
        out->failed |= !decimal;
        text_put(out, " Times are told from the motion's start, t0 = ");
        formula_rational(out, origin);
        if (!exact || !fmpz_is_one(fmpq_denref(origin)))
            text_format(out, exact ? " = %s" : ", about %s", decimal ? decimal : "");
        text_put(out, ".");
    }
}
