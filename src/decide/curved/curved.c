/* The trace of a point: certain crossings of the filter, and states in the windows it asks for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Without the filter, or where it cannot be used, each piece is one window for all surfaces.
 */
#include "base/context/scope.h"
#include "decide/curved/walker.h"

typedef struct finding_walk {
    tracer *r;
    const surface_filter *filter;
    truths *truths;
    findings *found;
    word_builder *word;
    walker walker; /* begun with the first window */
    int walks;
    graze_state state; /* state of the current gap */
} finding_walk;

static graze_state state_now(const finding_walk *f) {
    return truths_all(f->truths, &f->filter->expression) ? GRAZE_STATE_I : GRAZE_STATE_O;
}

static graze_status disagree(const finding_walk *f) {
    return context_fail(f->r->context, GRAZE_EINTERNAL,
                        "the filter's crossing and the exact path disagree on a sign");
}

/* Walk through one surface, at a time at which no other surface vanishes (proofs/surfaces.md C107).
 */
static graze_status walk_crossing(finding_walk *f, const crossing *c) {
    if (f->truths->sign[c->simplex] != (c->enters ? 1 : -1))
        return disagree(f);
    if (f->walks)
        TRY(walker_settle(&f->walker, f->state));
    truths_flip(f->truths, &f->filter->expression, c->simplex);
    graze_state after = state_now(f);
    if (after != f->state)
        TRY(word_put_crossing(f->word));
    f->state = after;
    return word_put_gap(f->word, after);
}

/* Take over the signs that the surfaces of a window have after it, as the exact path found them. */
static void take_signs(finding_walk *f, const exact_window *window, const candidate *asked) {
    for (size_t k = 0; k < window->count; k++)
        if (f->walker.expression.sign[asked[k].simplex] != f->truths->sign[asked[k].simplex])
            truths_flip(f->truths, &f->filter->expression, asked[k].simplex);
    f->state = state_now(f);
}

static graze_status walk_asked(finding_walk *f, const exact_window *window) {
    const candidate *asked = f->found->asked.item + window->first;
    int starts = window->piece == 0 && window->from == 0;
    if (!f->walks) {
        f->walks = 1;
        TRY(walker_init(&f->walker, f->r, f->word));
    }
    /* A time between two pieces is decided once, with the later one. */
    if (f->walker.pending && (window->from > 0 || window->piece != f->walker.piece + 1))
        TRY(walker_settle(&f->walker, f->state));
    if (!f->walker.pending)
        f->walker.before = starts ? GRAZE_STATE_ABSENT : f->state;
    memcpy(f->walker.expression.sign, f->truths->sign, f->filter->surface_count);
    TRY(walker_walk(&f->walker, window, asked));
    take_signs(f, window, asked);
    return GRAZE_OK;
}

static int is_before(const crossing *c, const exact_window *w) {
    return c->piece != w->piece ? c->piece < w->piece : c->from * WINDOW_WHOLE < w->from;
}

/* Walk the crossings and the windows in order of time. */
static graze_status walk_findings(finding_walk *f) {
    const findings *found = f->found;
    const exact_window *first = found->window;
    size_t c = 0, w = 0;
    f->state = state_now(f);
    if (!found->window_count || first->piece > 0 || first->from > 0)
        TRY(word_put_gap(f->word, f->state));
    while ((c < found->crossing_count || w < found->window_count))
        if (w == found->window_count ||
            (c < found->crossing_count && is_before(&found->crossing[c], &found->window[w])))
            TRY(walk_crossing(f, &found->crossing[c++]));
        else
            TRY(walk_asked(f, &found->window[w++]));
    if (f->walks) {
        int ends = f->walker.piece + 1 == f->r->scene->motion->piece_count;
        TRY(walker_settle(&f->walker, ends ? GRAZE_STATE_ABSENT : f->state));
    }
    return GRAZE_OK;
}

/* Walk without the filter: each piece is one window for all surfaces. */
static graze_status walk_pieces(tracer *r, word_builder *word) {
    ZEROED(walker, w);
    size_t n = r->scene->solid->curved->surface_count;
    TRY(walker_init(&w, r, word));
    FREED(candidate, all, NULL);
    TRY(MAKE_ARRAY(r->context, all, n + 1, "%zu surfaces", n));
    for (size_t k = 0; k < n; k++)
        all[k] = (candidate){.simplex = (uint32_t)k};
    for (size_t k = 0; k < r->scene->motion->piece_count; k++)
        TRY(walker_walk(&w, &(exact_window){(uint32_t)k, 0, WINDOW_WHOLE, 0, n}, all));
    return walker_settle(&w, GRAZE_STATE_ABSENT);
}

static graze_status walk_point(tracer *r, word_builder *word) {
    const surface_filter *filter = r->scene->surfaces;
    graze_status status = context_poll(r->context);
    if (status || !r->workspace || !filter ||
        !surfaces_search(r->workspace, filter, &r->near, r->detail == TRACE_CONTACTS))
        return status ? status : walk_pieces(r, word);
    finding_walk f = {.r = r,
                      .filter = filter,
                      .truths = &r->workspace->truths,
                      .found = &r->workspace->found,
                      .word = word};
    status = walk_findings(&f);
    if (f.walks)
        walker_clear(&f.walker);
    return status;
}

graze_status curved_trace(graze_trace *out, graze_context *context, const graze_scene *scene,
                          query_point point, trace_detail detail) {
    *out = (graze_trace){.word = NULL};
    tracer r = {.out = out, .context = context, .scene = scene, .point = point, .detail = detail};
    word_builder word = {.out = out, .context = context, .motion = scene->motion};
    tracer_begin(&r);
    graze_status status = walk_point(&r, &word);
    if (!status)
        status = word_tell_contacts(out, context, word.length);
    tracer_clear(&r);
    if (status)
        trace_clear(out);
    return status;
}
