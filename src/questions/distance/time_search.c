/* Common parts of both searches. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/distance/time_search.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_VISITS = 1 << 22, VISIT_WORK = 64 };

void search_begin(search *s, graze_context *context, const arc_maps *base, const double *low,
                  const double *high, double tolerance) {
    *s = (search){.context = context,
                  .base = base,
                  .point_low = low,
                  .point_high = high,
                  .tolerance = tolerance};
}

void search_end(search *s) {
    free(s->list);
    free(s->aside);
    free(s->window);
}

int search_is_over(const search *s) {
    return s->visits > MOST_VISITS;
}

graze_status search_poll(search *s) {
    size_t more = s->visits - s->counted;
    s->counted = s->visits;
    return context_work(s->context, (unsigned long)(VISIT_WORK * more));
}

graze_status search_no_room(search *s) {
    return context_fail(s->context, GRAZE_ESYSTEM, "out of memory for a distance");
}

/* Bounds that come from squares are no nearer to each other than the root of FILTER_FLOOR. */
static const double LEAST_TOLERANCE = 0x1p-386;

double search_floor(const window *w) {
    double error = w->stray / w->least;
    if (!w->of->rigid)
        error = larger(error, w->place_stray / w->place_least);
    return larger(8 * error, LEAST_TOLERANCE);
}

int search_is_done(const search *s, double low, double high) {
    /* Decimals in a table, rounded outward, exceed the doubles by less than this. */
    double more = 0x1p-50 * larger(fabs(low), fabs(high));
    return high - low + more <= s->tolerance;
}
