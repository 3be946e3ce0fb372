/* The trace of a point: certain findings of the filter, touches and contacts in the windows it asks
 * for, then the states between them. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Without the filter, or where it cannot be used, the one window is the whole piece, with the
 * candidates of the exact search.
 */
#include "decide/trace/trace.h"

#include <math.h>
#include "base/context/scope.h"

/* Append the contacts that the candidates of a piece make. The candidates come in any order, and
 * their windows hold all their touches. */
static graze_status trace_window(tracer *r, size_t piece, candidates *list, int opens) {
    const trajectory *c = tracer_exact(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    HELD(touches, t);
    touch_filter quick = {.piece = tracer_quick(r, piece)};
    if (quick.piece) {
        quick.curve = &r->workspace->curve;
        quick.forms = &r->workspace->forms;
    }
    TRY(touches_find(&t, r->context, r->scene->solid, c, quick.piece ? &quick : NULL, list));
    TRY(touches_order(&t, r->context));
    return contacts_append(r->out, r->context, r->scene->motion, piece, &t, opens);
}

static graze_status trace_exactly(tracer *r, size_t piece) {
    const trajectory *c = tracer_exact(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    TRY(candidates_find(&r->list, r->context, r->scene->solid, c));
    TRY(crosscheck_window(r, piece, 0, UINT32_C(1) << WINDOW_LEVELS));
    return trace_window(r, piece, &r->list, 1);
}

/* The contacts of a window of the filter. */
static graze_status trace_exact_window(tracer *r, const findings *found,
                                       const exact_window *window) {
    candidates asked = {window->count, window->count, found->asked.item + window->first};
    TRY(crosscheck_window(r, window->piece, window->from, window->to));
    return trace_window(r, window->piece, &asked, window->from == 0);
}

static graze_status trace_crossing(tracer *r, size_t piece, int enters) {
    TRY(crosscheck_crossing(r, piece, enters));
    return contacts_append_crossing(r->out, r->context, enters);
}

/* Nothing is met at the beginning of a piece, so the contact before must not end there. */
static graze_status trace_nothing(tracer *r, size_t piece) {
    touches none;
    touches_init(&none);
    return contacts_append(r->out, r->context, r->scene->motion, piece, &none, 1);
}

/* The next crossing, window and lost piece of the findings. */
typedef struct place_in {
    size_t crossing, window, lost;
} place_in;

static const crossing *next_crossing(const findings *found, const place_in *at) {
    return at->crossing < found->crossing_count ? &found->crossing[at->crossing] : NULL;
}

static const exact_window *next_window(const findings *found, const place_in *at) {
    return at->window < found->window_count ? &found->window[at->window] : NULL;
}

/* The first piece with a finding; SIZE_MAX if there is none. */
static size_t next_piece(const findings *found, const place_in *at) {
    const crossing *c = next_crossing(found, at);
    const exact_window *w = next_window(found, at);
    size_t piece = at->lost < found->lost_count ? found->lost[at->lost] : SIZE_MAX;
    piece = c && c->piece < piece ? c->piece : piece;
    return w && w->piece < piece ? w->piece : piece;
}

/* Trace the crossings and windows of a piece in order of time. */
static graze_status trace_findings(tracer *r, size_t piece, const findings *found, place_in *at) {
    const exact_window *window = next_window(found, at);
    int opens = !window || window->piece != piece || window->from > 0;
    if (opens)
        TRY(trace_nothing(r, piece));
    while (next_piece(found, at) == piece) {
        const crossing *next = next_crossing(found, at);
        window = next_window(found, at);
        window = window && window->piece == piece ? window : NULL;
        if (next && next->piece == piece &&
            (!window || ldexp(next->from, WINDOW_LEVELS) < window->from)) {
            TRY(trace_crossing(r, piece, next->enters));
            at->crossing++;
        } else {
            TRY(trace_exact_window(r, found, window));
            at->window++;
        }
    }
    return GRAZE_OK;
}

/* Trace all that the filter found in a piece, with exact times. */
static graze_status trace_all(tracer *r, size_t piece, const findings *found, place_in *at) {
    int kept = 1;
    r->list.count = 0;
    for (; at->crossing < found->crossing_count && found->crossing[at->crossing].piece == piece;
         at->crossing++) {
        const crossing *c = &found->crossing[at->crossing];
        double from = floor(ldexp(fmax(c->from, 0), WINDOW_LEVELS));
        double to = ceil(ldexp(fmin(c->to, 1), WINDOW_LEVELS));
        kept = kept && candidates_append(&r->list, (candidate){(uint32_t)piece, c->simplex,
                                                               (uint32_t)from, (uint32_t)to});
    }
    for (; at->window < found->window_count && found->window[at->window].piece == piece;
         at->window++) {
        const exact_window *w = &found->window[at->window];
        for (size_t k = 0; k < w->count; k++)
            kept = kept && candidates_append(&r->list, found->asked.item[w->first + k]);
    }
    if (!kept)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for a trace");
    return trace_window(r, piece, &r->list, 1);
}

/* Trace the pieces with findings; contacts must not end where a piece without findings begins. */
static graze_status trace_found(tracer *r, const findings *found) {
    place_in at = {0, 0, 0};
    for (size_t piece, after = 0;; after = piece + 1) {
        piece = next_piece(found, &at);
        if (after > 0 && after < r->scene->motion->piece_count && piece != after)
            TRY(trace_nothing(r, after));
        if (piece == SIZE_MAX)
            return GRAZE_OK;
        if (at.lost < found->lost_count && found->lost[at.lost] == piece) {
            TRY(trace_exactly(r, piece));
            at.lost++;
        } else {
            TRY(r->detail == TRACE_CONTACTS ? trace_all(r, piece, found, &at)
                                            : trace_findings(r, piece, found, &at));
        }
    }
}

static graze_status trace_pieces(tracer *r) {
    TRY(context_poll(r->context));
    const filter *f = &r->scene->filter;
    int *settled = r->detail >= TRACE_PMC ? &r->out->settled : NULL;
    if (r->workspace &&
        filter_search(r->workspace, settled, r->detail == TRACE_PMC ? filter_bricks(f) : NULL, f,
                      &r->near)) {
        if (r->out->settled)
            return GRAZE_OK;
        TRY(trace_found(r, &r->workspace->found));
    } else {
        for (size_t k = 0; k < r->scene->motion->piece_count; k++)
            TRY(trace_exactly(r, k));
    }
    TRY(contacts_name(r->out, r->context, &r->scene->solid->cut.names));
    return word_read(r);
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
