/* Decimals that are bounds. SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/report/row_parts.h"

#include <math.h>
#include "base/context/scope.h"

/* Digits of the decimal of an irrational time. */
enum { DECIMAL_DIGITS = 17 };

void report_bound(char out[BOUND_ROOM], double bound, int up) {
    LOCAL_MPFR(x, 53);
    mpfr_set_d(x, bound + 0.0, MPFR_RNDN);
    mpfr_snprintf(out, BOUND_ROOM, up ? "%.17RUg" : "%.17RDg", x);
}

void report_width(char out[BOUND_ROOM], double value, int up) {
    double next = nextafter(value, up ? (double)INFINITY : 0);
    LOCAL_MPFR(x, 53);
    LOCAL_MPFR(read, 256);
    mpfr_set_d(x, value, MPFR_RNDN);
    for (int digits = 1, done = 0; digits <= 17 && !done; digits++) {
        mpfr_snprintf(out, BOUND_ROOM, up ? "%.*RUg" : "%.*RDg", digits, x);
        mpfr_set_str(read, out, 10, up ? MPFR_RNDD : MPFR_RNDU);
        done = up ? mpfr_cmp_d(read, next) < 0 : mpfr_cmp_d(read, next) > 0;
    }
}

void report_put_width(text *t, const char *name, double width, int up) {
    char number[BOUND_ROOM];
    if (!(width > 0))
        return;
    report_width(number, width, up);
    text_format(t, "# %s %s\n", name, number);
}

/* Set the time of an enclosure and return 1, if it is rational; else return 0. */
static int rational_time(fmpq_t out, const graze_scene *scene, const distance *found) {
    if (found->at && !time_is_rational(found->at))
        return 0;
    if (found->at)
        fmpq_set(out, found->at->low);
    else
        distance_time(out, found, scene->motion);
    return 1;
}

void report_distance(text *out, const row *r) {
    char low[BOUND_ROOM], high[BOUND_ROOM];
    report_bound(low, r->space.low, 0);
    report_bound(high, r->space.high, 1);
    text_format(out, ",%s,%s", low, high);
    if (r->shown->at_rest)
        return;
    text_put(out, ",");
    LOCAL(fmpq, time);
    if (rational_time(time, r->scene, &r->space))
        text_rational(out, time);
    else
        text_owned(out, decimal_of_time(NULL, r->space.at, DECIMAL_DIGITS));
}

void explain_distance(text *out, const graze_scene *scene, const distance *found) {
    char low[BOUND_ROOM], high[BOUND_ROOM];
    report_bound(low, found->low, 0);
    report_bound(high, found->high, 1);
    sentence_put(out, "distance", scene->options.operation == GRAZE_SWEEP ? "sweep" : "unsweep",
                 low, high, found->wide ? ", which is wider than was asked for" : "",
                 found->at ? "distance-met" : "distance-shown");
    LOCAL(fmpq, time);
    if (rational_time(time, scene, found))
        tell_rational_time(out, scene->motion, time);
    else
        tell_near_time(out, found->at, DECIMAL_DIGITS);
    text_put(out, ".\n");
}
