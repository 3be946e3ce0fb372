/* What both searches share. SPDX-License-Identifier: GPL-3.0-or-later */
#include "distance/search.h"

#include <math.h>
#include <stdlib.h>
#include "filter/normal.h"

enum { MOST_VISITS = 1 << 22, VISIT_WORK = 64 };

void search_begin(search *s, graze_context *context, const ground *base, const double *low,
                  const double *high, double tolerance) {
    *s = (search){.context = context,
                  .base = base,
                  .point_low = low,
                  .point_high = high,
                  .tolerance = tolerance};
}

void search_end(search *s) {
    free(s->list);
    s->list = NULL;
}

int search_is_over(const search *s) {
    return s->visits > MOST_VISITS;
}

graze_status search_poll(search *s) {
    size_t more = s->visits - s->counted;
    s->counted = s->visits;
    return context_work(s->context, (unsigned long)(VISIT_WORK * more));
}

/* Bounds that come from squares are no closer than the root of FILTER_FLOOR. */
static const double LEAST_TOLERANCE = 0x1p-386;

double search_tolerance(const search *s, const window *w) {
    double error = w->stray / w->least;
    if (!w->of->rigid)
        error = larger(error, w->place_stray / w->place_least);
    double least = larger(8 * error, LEAST_TOLERANCE);
    return larger(s->tolerance * (1 - 0x1p-20) - error, least);
}
