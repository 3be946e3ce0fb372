/* Points by their cube, the trace and the distance. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/open_search.h"

#include "base/number/rounding.h"
#include "decide/verdict/classify.h"
#include "questions/distance/distance.h"

/* Distances of points are asked to this share of the width that is wanted. */
static const double POINT_SHARE = 0.0625;

int suprema_is_over(const suprema *s) {
    return s->space.decided + s->asked >= s->budget;
}

graze_status suprema_ask(known_point *out, suprema *s, const double *point, ask_distance distance) {
    graze_trace trace;
    struct distance found;
    fmpq exact[3];
    *out = (known_point){.pmc = band_membership(&s->space, point)};
    graze_pmc wanted = distance == ASK_OUT  ? GRAZE_OUT
                       : distance == ASK_IN ? GRAZE_IN
                                            : GRAZE_PMC_NONE;
    if (out->pmc != GRAZE_PMC_NONE && out->pmc != wanted)
        return GRAZE_OK;
    s->asked++;
    graze_status status =
        classify_point(&trace, s->context, s->scene, (query_point){.value = point},
                       distance == ASK_IN ? TRACE_CONTACTS : TRACE_PMC);
    if (status)
        return status;
    out->pmc = trace.verdict.pmc;
    for (int k = 0; k < 3; k++) {
        fmpq_init(exact + k);
        (void)rational_from_double(exact + k, NULL, point[k]);
    }
    if (out->pmc == wanted) {
        status =
            distance_find(&found, s->context, s->scene, exact, &trace, POINT_SHARE * s->within);
        out->low = found.low;
        out->high = found.high;
    }
    for (int k = 0; k < 3; k++)
        fmpq_clear(exact + k);
    trace_clear(&trace);
    return status;
}

graze_status suprema_settle(int *done, suprema *s, uint32_t cube_index) {
    const cube *c = &s->space.item[cube_index];
    known_point known;
    graze_status status = suprema_ask(&known, s, c->centre, ASK_IN);
    *done = !status && known.pmc == GRAZE_IN && -known.high > cube_radius(c);
    if (*done)
        band_settle(&s->space, cube_index);
    return status;
}

void supremum_finish(supremum *found, const suprema *s, const priority *wait, const double *open) {
    double high = wait->count ? wait->item[0].bound : 0;
    for (int k = 0; k < 3 && wait->count; k++)
        found->open[k] = open[k];
    found->high = high > found->low ? high : found->low;
    found->reached = found->high - found->low <= s->within;
}
