/* The exact answer chooses the search: the least distance over all times, or the greatest distance
 * over the visits to the solid's interior (for an unsweep, to its exterior).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "decide/verdict/verdict.h"
#include "questions/distance/time_search.h"

/* Contacts' times are narrowed to this many binary places, beyond those of the shortest arc. */
enum { PLACES = 60 };

/* Enclose a contact's time, as a parameter of its piece. */
static graze_status narrow_time(fmpq_t low, fmpq_t high, graze_context *context,
                                const graze_time *time, ulong places) {
    HELD(algebraic, x);
    algebraic_set(&x, &time->u);
    ulong gain = FIRST_GAIN;
    for (int step = 0; !algebraic_is_rational(&x) && x.where.exponent < places; step++)
        TRY(algebraic_narrow(context, &x, step, &gain));
    algebraic_bounds(low, high, &x);
    return GRAZE_OK;
}

/* A contact's time is between v = low of one arc and v = high of the same or a later one. */
typedef struct moment {
    size_t low_arc, high_arc;
    double low, high;
} moment;

/* Find the last arc of a piece that begins at u or before, and doubles below and above its v at u.
 */
static size_t find_arc(double *low, double *high, graze_context *context, const arc_maps *base,
                       size_t piece, const fmpq_t u) {
    LOCAL_VEC(fmpq, from, 3);
    fmpq *length = from + 1, *v = from + 2;
    size_t k = base->first[piece + 1];
    do
        (void)rational_from_double(from, context, base->arc[--k].from);
    while (k > base->first[piece] && fmpq_cmp(from, u) > 0);
    (void)rational_from_double(length, context, base->arc[k].length);
    fmpq_sub(v, u, from);
    fmpq_div(v, v, length);
    rational_bounds(low, high, v);
    *low = fmax(*low, 0);
    *high = fmin(*high, 1);
    return k;
}

static graze_status enclose_moment(moment *out, graze_context *context, const arc_maps *base,
                                   const graze_time *time) {
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    double unused;
    TRY(narrow_time(low, high, context, time, PLACES + base->deepest));
    out->low_arc = find_arc(&out->low, &unused, context, base, time->piece, low);
    out->high_arc = find_arc(&unused, &out->high, context, base, time->piece, high);
    return GRAZE_OK;
}

/* Append the stretches of a visit between two moments, one for each arc. */
static graze_status add_visit(stretch_of_time **list, size_t *count, graze_context *context,
                              const moment *from, const moment *to) {
    size_t arcs = to->high_arc - from->low_arc + 1;
    stretch_of_time *grown = realloc(*list, (*count + arcs) * sizeof *grown);
    if (!grown)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for a distance");
    *list = grown;
    for (size_t k = from->low_arc; k <= to->high_arc; k++) {
        double sure_from = k < from->high_arc ? INFINITY : k == from->high_arc ? from->high : 0;
        double sure_to = k > to->low_arc ? -INFINITY : k == to->low_arc ? to->low : 1;
        grown[(*count)++] = (stretch_of_time){.arc = k,
                                              .from = k == from->low_arc ? from->low : 0,
                                              .to = k == to->high_arc ? to->high : 1,
                                              .sure_from = sure_from,
                                              .sure_to = sure_to};
    }
    return GRAZE_OK;
}

/* List all visits, one stretch for each arc. A visit is a gap before, between or after the contacts
 * in which the trace has the wanted state. */
static graze_status find_visits(stretch_of_time **list, size_t *count, graze_context *context,
                                const arc_maps *base, const graze_trace *trace,
                                graze_state wanted) {
    size_t last = base->arc_count - 1;
    moment from = {0, 0, 0, 0}, to;
    for (size_t k = 0; k <= trace->contact_count; k++) {
        const contact *next = k < trace->contact_count ? &trace->contact[k] : NULL;
        graze_state state = next ? next->left : trace->last;
        to = (moment){last, last, 1, 1};
        if (next)
            TRY(enclose_moment(&to, context, base, next->from));
        if (state == wanted)
            TRY(add_visit(list, count, context, &from, &to));
        if (next)
            TRY(enclose_moment(&from, context, base, next->to));
    }
    return GRAZE_OK;
}

static graze_status find_greatest(search *s, const graze_trace *trace, graze_state wanted) {
    FREED(stretch_of_time, list, NULL);
    size_t count = 0;
    TRY(find_visits(&list, &count, s->context, s->base, trace, wanted));
    return search_greatest(s, list, count);
}

/* The time of the contact that ends the first visit, if no double is certain to lie in any visit.
 */
static const graze_time *end_of_visit(const graze_trace *trace, graze_state wanted) {
    for (size_t k = 0; k < trace->contact_count; k++)
        if (trace->contact[k].left == wanted)
            return trace->contact[k].from;
    return NULL;
}

/* Search the distance of a point that is not `on`, and give the bounds the sign of its answer. */
static graze_status find_off(distance *out, search *s, const graze_scene *scene,
                             const graze_trace *trace) {
    int unsweep = scene->options.operation == GRAZE_UNSWEEP;
    int negative = trace->verdict.pmc == GRAZE_IN, greatest = negative != unsweep;
    graze_state wanted = unsweep ? GRAZE_STATE_O : GRAZE_STATE_I;
    TRY(greatest ? find_greatest(s, trace, wanted) : search_least(s));
    out->low = negative ? -s->high : s->low;
    out->high = negative ? -s->low : s->high;
    out->wide = !search_is_done(s, out->low, out->high);
    const arc *of = &s->base->arc[s->arc];
    out->piece = of->piece;
    out->from = of->from;
    out->length = of->length;
    out->v = s->time;
    out->at = greatest && !s->met ? end_of_visit(trace, wanted) : NULL;
    return GRAZE_OK;
}

graze_status distance_find(distance *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point, const graze_trace *trace, double tolerance) {
    const arc_maps *base;
    double low[3], high[3];
    *out = (distance){.low = 0};
    if (trace->verdict.pmc == GRAZE_ON) {
        out->at = trace->contact_count ? trace->contact[0].from : NULL;
        return GRAZE_OK;
    }
    TRY(arc_maps_of(&base, context, scene));
    for (int k = 0; k < scene->motion->dimension; k++)
        rational_bounds(&low[k], &high[k], point + k);
    search s;
    search_begin(&s, context, base, low, high, tolerance);
    graze_status status = find_off(out, &s, scene, trace);
    search_end(&s);
    return status;
}

graze_status distance_at(distance *out, graze_pmc *pmc, graze_context *context,
                         const graze_scene *scene, const fmpq *point, double tolerance) {
    graze_trace trace;
    TRY(classify_point(&trace, context, scene, (query_point){.rational = point}, TRACE_CONTACTS));
    graze_status status = distance_find(out, context, scene, point, &trace, tolerance);
    *pmc = trace.verdict.pmc;
    out->at = NULL;
    trace_clear(&trace);
    return status;
}

int distance_is_certain(const distance *found, double motion_error) {
    return found->low > motion_error || found->high < -motion_error;
}

graze_status distance_contact_time(fmpq_t out, graze_context *context, const graze_time *time) {
    LOCAL(fmpq, high);
    TRY(narrow_time(out, high, context, time, PLACES));
    motion_time_at(out, &time->motion->piece[time->piece], out);
    return GRAZE_OK;
}

void distance_time(fmpq_t out, const distance *found, const graze_motion *motion) {
    LOCAL_VEC(fmpq, length, 2);
    fmpq *v = length + 1;
    /* All three are finite. */
    (void)rational_from_double(out, NULL, found->from);
    (void)rational_from_double(length, NULL, found->length);
    (void)rational_from_double(v, NULL, found->v);
    fmpq_addmul(out, length, v);
    motion_time_at(out, &motion->piece[found->piece], out);
}

graze_status distance_time_near(double *out, graze_context *context, const distance *found,
                                const graze_motion *motion) {
    LOCAL(fmpq, time);
    if (found->at)
        TRY(distance_contact_time(time, context, found->at));
    else
        distance_time(time, found, motion);
    return rational_nearest(out, context, time);
}
