/* A point is asked of its cube, else of the classification; then for its distance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/judge/cube.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "decide/trace/trace.h"
#include "decide/verdict/verdict.h"
#include "questions/distance/distance.h"
#include "questions/judge/open_search.h"

/* The tolerance of a point's distance, as a share of the width wanted. */
static const double POINT_SHARE = 0.0625;

/* The least tolerance, as a share of the coordinates: doubles resolve no finer one. */
static const double FINEST_SHARE = 0x1p-42;

/* Cubes with a radius of at most this share of the width are not probed further. */
static const double STUCK_SHARE = 0x1p-9;

/* Visiting SEEN_CUBES cubes costs as much as asking about one. */
enum { SEEN_CUBES = 2048 };

/* cube_is_covered is not asked any more after this number of failures. */
enum { UNCOVERED_MOST = 64 };

/* The points around a cube are the corners of the cube that is AROUND times as large. */
static const double AROUND = 1.5;

size_t suprema_spent(const suprema *s) {
    return s->space.decided + s->asked + s->space.seen / SEEN_CUBES;
}

int suprema_is_over(const suprema *s) {
    return suprema_spent(s) >= s->budget;
}

/* The signed distance of a point whose trace is known. */
static graze_status enclose_point(struct distance *out, suprema *s, const double *point,
                                  const graze_trace *trace) {
    LOCAL_VEC(fmpq, exact, 3);
    double tolerance = POINT_SHARE * s->within;
    for (int k = 0; k < 3; k++) {
        (void)rational_from_double(exact + k, NULL, point[k]);
        tolerance = larger(tolerance, FINEST_SHARE * fabs(point[k]));
    }
    return distance_find(out, s->context, s->scene, exact, trace, tolerance);
}

graze_status suprema_ask(known_point *out, suprema *s, const double *point, ask_distance distance) {
    graze_trace trace;
    struct distance found;
    *out = (known_point){.pmc = band_membership(&s->space, point)};
    graze_pmc wanted = distance == ASK_OUT  ? GRAZE_OUT
                       : distance == ASK_IN ? GRAZE_IN
                                            : GRAZE_PMC_NONE;
    if (out->pmc != GRAZE_PMC_NONE && out->pmc != wanted)
        return GRAZE_OK;
    s->asked++;
    TRY(classify_point(&trace, s->context, s->scene, (query_point){.value = point},
                       distance == ASK_IN ? TRACE_CONTACTS : TRACE_PMC));
    graze_status status = GRAZE_OK;
    out->pmc = trace.verdict.pmc;
    if (out->pmc == wanted) {
        status = enclose_point(&found, s, point, &trace);
        out->low = found.low;
        out->high = found.high;
    }
    trace_clear(&trace);
    return status;
}

graze_status suprema_time(double *out, suprema *s, const double *point) {
    graze_trace trace;
    struct distance found;
    TRY(classify_point(&trace, s->context, s->scene, (query_point){.value = point},
                       TRACE_CONTACTS));
    graze_status status = enclose_point(&found, s, point, &trace);
    if (!status)
        status = distance_time_near(out, s->context, &found, s->scene->motion);
    trace_clear(&trace);
    return status;
}

graze_status suprema_settle(int *done, suprema *s, uint32_t cube_index) {
    const cube *c = &s->space.item[cube_index];
    known_point known;
    TRY(suprema_ask(&known, s, c->centre, ASK_IN));
    *done = known.pmc == GRAZE_IN && -known.high > cube_radius(c);
    if (!*done && known.pmc != GRAZE_OUT && s->uncovered < UNCOVERED_MOST) {
        TRY(cube_is_covered(done, &s->space.ask, c));
        s->uncovered += !*done;
    }
    if (*done)
        band_settle(&s->space, cube_index, CUBE_IN);
    return GRAZE_OK;
}

graze_status suprema_sample(cube_sample *out, suprema *s, uint32_t index) {
    const cube c = s->space.item[index];
    *out = (cube_sample){.has_in = 0};
    for (int k = 0; k < 9 && !(out->has_in && out->has_out); k++) {
        double point[3];
        known_point known;
        for (int i = 0; i < 3; i++)
            point[i] = c.centre[i] + (k ? (k - 1) >> i & 1 ? AROUND : -AROUND : 0) * c.half;
        TRY(suprema_ask(&known, s, point, ASK_NO_DISTANCE));
        int outside = known.pmc == GRAZE_OUT;
        memcpy(outside ? out->out : out->in, point, sizeof point);
        *(outside ? &out->has_out : &out->has_in) = 1;
    }
    return GRAZE_OK;
}

/* The cube of the band nearest to a place among the eight from `child` on; UINT32_MAX if none is of
 * the band. */
static uint32_t next_probe(const suprema *s, uint32_t child, const double *toward) {
    uint32_t nearest = UINT32_MAX;
    double least = INFINITY;
    for (uint32_t k = child; k < child + 8; k++) {
        const cube *c = &s->space.item[k];
        double way = distance_above(c->centre, toward);
        if (c->kind == CUBE_BAND && way < least) {
            nearest = k;
            least = way;
        }
    }
    return nearest;
}

graze_status suprema_probe(int *stuck, suprema *s, uint32_t index, const double *toward) {
    *stuck = 0;
    for (int done = 0; !done;) {
        cube_sample around;
        if (cube_radius(&s->space.item[index]) > STUCK_SHARE * s->within)
            TRY(band_cut(&done, &s->space, index));
        *stuck = !done;
        if (*stuck)
            return GRAZE_OK;
        index = next_probe(s, s->space.item[index].child, toward);
        if (index == UINT32_MAX)
            return GRAZE_OK;
        TRY(suprema_sample(&around, s, index));
        if (around.has_out)
            return GRAZE_OK;
        TRY(suprema_settle(&done, s, index));
    }
    return GRAZE_OK;
}

void supremum_finish(supremum *found, const suprema *s, const priority *wait, const double *open) {
    double high = wait->count ? wait->item[0].bound : 0;
    for (int k = 0; k < 3 && wait->count; k++)
        found->open[k] = open[k];
    found->high = high > found->low ? high : found->low;
    found->reached = found->high - found->low <= s->within;
}
