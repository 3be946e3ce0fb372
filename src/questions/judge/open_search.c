/* Points by their cube, the trace and the distance. SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/open_search.h"

#include "base/number/rounding.h"
#include "decide/verdict/classify.h"
#include "questions/distance/distance.h"

/* Distances of points are asked to this share of the width that is wanted. */
static const double POINT_SHARE = 0.0625;

/* Cubes of at most this share of it are probed no further. */
static const double STUCK_SHARE = 0x1p-9;

/* Points around a cube are this much further out than its corners. */
static const double AROUND = 1.5;

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

/* The cube of the band nearest to a place of the eight of one that was cut; UINT32_MAX if there is
 * none. */
static uint32_t next_probe(const suprema *s, uint32_t child, const double *toward) {
    uint32_t nearest = UINT32_MAX;
    double least = 0;
    for (uint32_t k = child; k < child + 8; k++) {
        const cube *c = &s->space.item[k];
        double x = c->centre[0] - toward[0], y = c->centre[1] - toward[1];
        double z = c->centre[2] - toward[2], square = x * x + y * y + z * z;
        if (c->kind != CUBE_BAND || (nearest != UINT32_MAX && square >= least))
            continue;
        nearest = k;
        least = square;
    }
    return nearest;
}

/* Whether a point around a cube is outside. */
static graze_status ask_around(int *outside, suprema *s, uint32_t index) {
    const cube c = s->space.item[index];
    graze_status status = GRAZE_OK;
    *outside = 0;
    for (int k = 0; k < 8 && !status && !*outside; k++) {
        double point[3];
        known_point known;
        for (int i = 0; i < 3; i++)
            point[i] = c.centre[i] + (k >> i & 1 ? AROUND : -AROUND) * c.half;
        status = suprema_ask(&known, s, point, ASK_NO_DISTANCE);
        *outside = !status && known.pmc == GRAZE_OUT;
    }
    return status;
}

graze_status suprema_probe(int *stuck, suprema *s, uint32_t index, const double *toward) {
    graze_status status = GRAZE_OK;
    *stuck = 0;
    while (!status && index != UINT32_MAX && !*stuck) {
        int done = 0;
        status = ask_around(&done, s, index);
        if (!status && !done)
            status = suprema_settle(&done, s, index);
        if (status || done)
            return status;
        if (cube_radius(&s->space.item[index]) > STUCK_SHARE * s->within)
            status = band_cut(&done, &s->space, index);
        *stuck = !status && !done;
        if (!status && done)
            index = next_probe(s, s->space.item[index].child, toward);
    }
    return status;
}

void supremum_finish(supremum *found, const suprema *s, const priority *wait, const double *open) {
    double high = wait->count ? wait->item[0].bound : 0;
    for (int k = 0; k < 3 && wait->count; k++)
        found->open[k] = open[k];
    found->high = high > found->low ? high : found->low;
    found->reached = found->high - found->low <= s->within;
}
