/* The trace of a point: certain findings of the filter, touches and contacts in the windows it asks
 * for, then the states between them. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Without the filter, or where it cannot be used, the one window is the whole piece, with the
 * candidates of the exact search.
 */
#include "trace/point.h"

#include <math.h>
#include "trace/candidates.h"
#include "trace/contact.h"
#include "trace/crosscheck.h"
#include "trace/word.h"

/* Contacts in windows that hold all touches of the candidates, which come in any order. */
static graze_status trace_window(tracer *r, size_t piece, candidates *list, int opens) {
    touches t;
    const trajectory *c = tracer_exact(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    touches_init(&t);
    graze_status status = touches_find(&t, r->context, r->scene->solid, c, list);
    if (status == GRAZE_OK)
        status = touches_order(&t, r->context);
    if (status == GRAZE_OK)
        status = contacts_append(r->out, r->context, r->scene->motion, piece, &t, opens);
    touches_clear(&t);
    return status;
}

static graze_status trace_exactly(tracer *r, size_t piece) {
    const trajectory *c = tracer_exact(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    graze_status status = candidates_find(&r->list, r->context, r->scene->solid, c);
    if (status == GRAZE_OK)
        status = crosscheck_window(r, piece, 0, UINT32_C(1) << WINDOW_LEVELS);
    return status == GRAZE_OK ? trace_window(r, piece, &r->list, 1) : status;
}

/* The contacts of a window of the filter. */
static graze_status trace_exact_window(tracer *r, size_t piece, const findings *found,
                                       const exact_window *window) {
    candidates asked = {window->count, window->count, found->asked.item + window->first};
    graze_status status = crosscheck_window(r, piece, window->from, window->to);
    return status == GRAZE_OK ? trace_window(r, piece, &asked, window->from == 0) : status;
}

static graze_status trace_crossing(tracer *r, size_t piece, int enters) {
    graze_status status = crosscheck_crossing(r, piece, enters);
    return status == GRAZE_OK ? contacts_append_crossing(r->out, r->context, enters) : status;
}

/* Crossings and windows in order of time. */
static graze_status trace_findings(tracer *r, size_t piece, const findings *found) {
    size_t c = 0, w = 0;
    touches none;
    touches_init(&none);
    int opens = w == found->window_count || found->window[0].from > 0;
    graze_status status =
        contacts_append(r->out, r->context, r->scene->motion, piece, &none, opens);
    while (status == GRAZE_OK && (c < found->crossing_count || w < found->window_count)) {
        const exact_window *window = w < found->window_count ? &found->window[w] : NULL;
        const crossing *next = c < found->crossing_count ? &found->crossing[c] : NULL;
        if (next && (!window || ldexp(next->from, WINDOW_LEVELS) < window->from)) {
            status = trace_crossing(r, piece, next->enters);
            c++;
        } else {
            status = trace_exact_window(r, piece, found, window);
            w++;
        }
    }
    return status;
}

/* All that the filter found, with exact times. */
static graze_status trace_all(tracer *r, size_t piece, findings *found) {
    for (size_t k = 0; k < found->crossing_count; k++) {
        const crossing *c = &found->crossing[k];
        double from = floor(ldexp(fmax(c->from, 0), WINDOW_LEVELS));
        double to = ceil(ldexp(fmin(c->to, 1), WINDOW_LEVELS));
        if (!candidates_append(&found->asked,
                               (candidate){c->simplex, (uint32_t)from, (uint32_t)to}))
            return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for a trace");
    }
    return trace_window(r, piece, &found->asked, 1);
}

static graze_status trace_piece(tracer *r, size_t piece) {
    if (!r->workspace || !filter_search(r->workspace, &r->scene->filter, piece, &r->near))
        return trace_exactly(r, piece);
    findings *found = &r->workspace->found;
    return r->detail == TRACE_WORD ? trace_findings(r, piece, found) : trace_all(r, piece, found);
}

static graze_status trace_pieces(tracer *r) {
    graze_status status = context_poll(r->context);
    for (size_t k = 0; k < r->scene->motion->piece_count && status == GRAZE_OK; k++)
        status = trace_piece(r, k);
    if (status == GRAZE_OK)
        status = contacts_name(r->out, r->context, &r->scene->solid->cut.names);
    return status == GRAZE_OK ? word_read(r) : status;
}

graze_status trace_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                         query_point point, trace_detail detail) {
    *out = (graze_trace){.word = NULL};
    tracer r = {.out = out, .context = context, .scene = scene, .point = point, .detail = detail};
    tracer_begin(&r);
    graze_status status = trace_pieces(&r);
    tracer_clear(&r);
    if (status != GRAZE_OK)
        trace_clear(out);
    return status;
}
