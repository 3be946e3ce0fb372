/* The trace of a point: what the filter finds certain, touches and contacts in the windows it asks
 * for, then the states between them. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Without the filter, or where it cannot be used, the one window is the whole piece, with the
 * candidates of the exact search.
 */
#include "trace/trace.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <math.h>
#include <stdlib.h>
#include "number/rational.h"
#include "trace/contact.h"
#include "trace/search.h"

typedef struct tracer {
    graze_trace *out;
    graze_context *context;
    const trace_scene *scene;
    query_point point;
    trace_detail detail;
    filter_workspace *workspace; /* NULL: no filter */
    filter_point near;
    trajectory *exact; /* one per piece, set for those of `exact_piece`; NULL until needed */
    unsigned char *is_exact;
    candidates list;
} tracer;

static int dimension_of(const tracer *r) {
    return r->scene->motion->dimension;
}

static void set_exactly(const tracer *r, trajectory *c, const point_map *map) {
    if (r->point.rational) {
        trajectory_set(c, map, r->point.rational);
        return;
    }
    fmpq *p = _fmpq_vec_init(dimension_of(r));
    for (int k = 0; k < dimension_of(r); k++)
        (void)rational_from_double(p + k, r->context, r->point.value[k]); /* finite, by contract */
    trajectory_set(c, map, p);
    _fmpq_vec_clear(p, dimension_of(r));
}

/* The exact trajectory of a piece; NULL without memory. */
static const trajectory *exact_piece(tracer *r, size_t piece) {
    size_t n = r->scene->motion->piece_count;
    if (!r->exact) {
        r->exact = malloc(n * sizeof *r->exact);
        r->is_exact = calloc(n, 1);
        for (size_t k = 0; r->exact && k < n; k++)
            trajectory_init(&r->exact[k], dimension_of(r));
    }
    if (!r->exact || !r->is_exact) {
        (void)context_fail(r->context, GRAZE_ESYSTEM, "out of memory for %zu pieces of a motion",
                           n);
        return NULL;
    }
    if (!r->is_exact[piece]) {
        const motion_piece *p = &r->scene->motion->piece[piece];
        const point_map *map = r->scene->operation == GRAZE_UNSWEEP ? &p->forward : &p->inverse;
        set_exactly(r, &r->exact[piece], map);
        r->is_exact[piece] = 1;
    }
    return &r->exact[piece];
}

/* Contacts in windows that hold all touches of the candidates, which come in any order. */
static graze_status trace_window(tracer *r, size_t piece, candidates *list, int opens) {
    touches t;
    const trajectory *c = exact_piece(r, piece);
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
    const trajectory *c = exact_piece(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    graze_status status = search_candidates(&r->list, r->context, r->scene->solid, c);
    return status == GRAZE_OK ? trace_window(r, piece, &r->list, 1) : status;
}

/* The state at a rational time at which the trajectory is off the boundary. */
static graze_status locate_at(graze_state *out, tracer *r, size_t piece, const fmpq_t u) {
    *out = GRAZE_STATE_ABSENT;
    if (r->workspace && fmpz_bits(fmpq_numref(u)) <= 53 && fmpz_bits(fmpq_denref(u)) <= 53) {
        /* u is dyadic, and so a double. */
        double at = fmpz_get_d(fmpq_numref(u)) / fmpz_get_d(fmpq_denref(u));
        *out = filter_locate(r->workspace, r->scene->filter, piece, &r->near, at);
    }
    if (*out != GRAZE_STATE_ABSENT)
        return GRAZE_OK;
    const trajectory *c = exact_piece(r, piece);
    if (!c)
        return GRAZE_ESYSTEM;
    fmpz *x = _fmpz_vec_init(dimension_of(r) + 1);
    trajectory_at(x, c, u);
    *out = solid_locate(r->scene->solid, x);
    _fmpz_vec_clear(x, dimension_of(r) + 1);
    if (*out != GRAZE_STATE_I && *out != GRAZE_STATE_O)
        return context_fail(
            r->context, GRAZE_EINTERNAL,
            "the point between two contacts of a trace is neither inside nor outside");
    return GRAZE_OK;
}

/* A window's end, off the boundary, against the crossing next to it: parity carried by the filter
 * and the states that the exact path sees must agree. */
static graze_status check_end(tracer *r, size_t piece, uint32_t end, const crossing *beside,
                              graze_state expected) {
    if (!beside)
        return GRAZE_OK;
    fmpq_t u;
    fmpq_init(u);
    fmpq_set_ui(u, end, UINT32_C(1) << WINDOW_LEVELS);
    graze_state state = GRAZE_STATE_ABSENT;
    graze_status status = locate_at(&state, r, piece, u);
    fmpq_clear(u);
    if (status == GRAZE_OK && state != expected)
        return context_fail(r->context, GRAZE_EINTERNAL,
                            "a certain crossing and an exact location disagree on a state");
    return status;
}

/* The contacts of a window of the filter, between the crossings beside it or NULL. */
static graze_status trace_exact_window(tracer *r, size_t piece, const findings *found,
                                       const exact_window *window, const crossing *before,
                                       const crossing *after) {
    candidates asked = {window->count, window->count, found->asked.item + window->first};
    graze_status status = trace_window(r, piece, &asked, window->from == 0);
    if (status == GRAZE_OK)
        status = check_end(r, piece, window->from, before,
                           before && before->enters ? GRAZE_STATE_I : GRAZE_STATE_O);
    if (status == GRAZE_OK)
        status = check_end(r, piece, window->to, after,
                           after && after->enters ? GRAZE_STATE_O : GRAZE_STATE_I);
    return status;
}

/* Crossings and windows in order of time. */
static graze_status trace_findings(tracer *r, size_t piece, const findings *found) {
    size_t c = 0, w = 0;
    touches none;
    touches_init(&none);
    int opens = w == found->window_count || found->window[0].from > 0;
    graze_status status =
        contacts_append(r->out, r->context, r->scene->motion, piece, &none, opens);
    const crossing *before = NULL; /* of what comes next, if that is a window */
    while (status == GRAZE_OK && (c < found->crossing_count || w < found->window_count)) {
        const exact_window *window = w < found->window_count ? &found->window[w] : NULL;
        const crossing *next = c < found->crossing_count ? &found->crossing[c] : NULL;
        if (next && (!window || ldexp(next->from, WINDOW_LEVELS) < window->from)) {
            status = contacts_append_crossing(r->out, r->context, next->enters);
            before = next;
            c++;
        } else {
            w++;
            int follows = next && (w == found->window_count ||
                                   ldexp(next->from, WINDOW_LEVELS) < found->window[w].from);
            status = trace_exact_window(r, piece, found, window, before, follows ? next : NULL);
            before = NULL;
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
    if (!r->workspace || !filter_search(r->workspace, r->scene->filter, piece, &r->near))
        return trace_exactly(r, piece);
    findings *found = &r->workspace->found;
    return r->detail == TRACE_WORD ? trace_findings(r, piece, found) : trace_all(r, piece, found);
}

static graze_status locate_between(graze_state *out, tracer *r, graze_time *before,
                                   graze_time *after) {
    algebraic zero, one;
    fmpq_t sample;
    algebraic_init(&zero);
    algebraic_init(&one);
    fmpq_one(one.value);
    fmpq_init(sample);
    size_t piece = before->piece;
    algebraic *low = &before->u;
    if (algebraic_compare(low, &one) == 0) {
        piece++;
        low = &zero;
    }
    algebraic *high = after->piece == piece ? &after->u : &one;
    graze_status status;
    /* Windows that were not apart would give one time twice, between which there is none. */
    if (after->piece >= piece && algebraic_compare(low, high) < 0) {
        algebraic_between(sample, low, high);
        status = locate_at(out, r, piece, sample);
    } else {
        status = context_fail(r->context, GRAZE_EINTERNAL,
                              "two contacts, one after the other, are not in order of time");
    }
    algebraic_clear(&zero);
    algebraic_clear(&one);
    fmpq_clear(sample);
    return status;
}

/* Locate the gap between two contacts with times, or an end of the motion for NULL: that end is
 * itself off the boundary. */
static graze_status locate_gap(graze_state *out, tracer *r, graze_time *before, graze_time *after) {
    if (before && after)
        return locate_between(out, r, before, after);
    fmpq_t end;
    fmpq_init(end);
    fmpq_set_si(end, before ? 1 : 0, 1);
    graze_status status = locate_at(out, r, before ? r->scene->motion->piece_count - 1 : 0, end);
    fmpq_clear(end);
    return status;
}

/* The state in the gap before contact `next` and after contact next - 1; either may not be there.
 * The crossings beside it know it; without them it is located. */
static graze_status gap_state(graze_state *out, tracer *r, size_t next) {
    const contact *before = next > 0 ? &r->out->contact[next - 1] : NULL;
    const contact *after = next < r->out->contact_count ? &r->out->contact[next] : NULL;
    graze_state left = before && !before->to ? before->right : GRAZE_STATE_ABSENT;
    graze_state right = after && !after->from ? after->left : GRAZE_STATE_ABSENT;
    if (left && right && left != right)
        return context_fail(
            r->context, GRAZE_EINTERNAL,
            "two crossings, one after the other, disagree on the state between them");
    *out = left ? left : right;
    if (left || right)
        return GRAZE_OK;
    return locate_gap(out, r, before ? before->to : NULL, after ? after->from : NULL);
}

/* States beside the contacts, at both ends, and the word. */
static graze_status read_word(tracer *r) {
    graze_trace *out = r->out;
    size_t n = out->contact_count, length = 0;
    int starts_on = n > 0 && time_is_start(out->contact[0].from);
    int ends_on = n > 0 && time_is_end(out->contact[n - 1].to);
    out->word = malloc(2 * n + 2);
    if (!out->word)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for the word of a trace");
    for (size_t k = 0; k <= n; k++) {
        if (!(k == 0 && starts_on) && !(k == n && ends_on)) {
            graze_state state = GRAZE_STATE_ABSENT;
            graze_status status = gap_state(&state, r, k);
            if (status != GRAZE_OK)
                return status;
            out->word[length++] = (char)state;
            if (k > 0)
                out->contact[k - 1].right = state;
            if (k < n)
                out->contact[k].left = state;
        }
        if (k < n)
            out->word[length++] = 'B';
    }
    out->word[length] = '\0';
    out->first = (graze_state)out->word[0];
    out->last = (graze_state)out->word[length - 1];
    return GRAZE_OK;
}

static graze_status trace_pieces(tracer *r) {
    graze_status status = context_poll(r->context);
    for (size_t k = 0; k < r->scene->motion->piece_count && status == GRAZE_OK; k++)
        status = trace_piece(r, k);
    return status == GRAZE_OK ? read_word(r) : status;
}

/* The nearest doubles, or nearly so: conversion and division each lose less than 2^-51. Past the
 * range of doubles they are infinite, which the filter refuses. */
static void approximate(filter_point *out, query_point point, int dimension) {
    for (int k = 0; k < dimension; k++) {
        if (point.value) {
            out->at[k] = point.value[k];
            continue;
        }
        slong top, bottom;
        double m = fmpz_get_d_2exp(&top, fmpq_numref(point.rational + k)) /
                   fmpz_get_d_2exp(&bottom, fmpq_denref(point.rational + k));
        slong e = top - bottom;
        out->at[k] = e > 1000 ? INFINITY : e < -1000 ? 0 : ldexp(m, (int)e);
    }
}

static void choose_filter(tracer *r) {
    if (r->context->exact_only || !r->scene->filter)
        return;
    r->workspace = filter_workspace_of(r->context);
    if (r->workspace) {
        filter_begin(r->workspace);
        approximate(&r->near, r->point, dimension_of(r));
    }
}

static void clear_tracer(tracer *r) {
    for (size_t k = 0; r->exact && k < r->scene->motion->piece_count; k++)
        trajectory_clear(&r->exact[k]);
    r->context->exact_count += r->exact != NULL;
    free(r->exact);
    free(r->is_exact);
    free(r->list.item);
}

graze_status trace_point(graze_trace *out, graze_context *context, const trace_scene *scene,
                         query_point point, trace_detail detail) {
    *out = (graze_trace){.word = NULL};
    tracer r = {.out = out, .context = context, .scene = scene, .point = point, .detail = detail};
    choose_filter(&r);
    graze_status status = trace_pieces(&r);
    clear_tracer(&r);
    if (status != GRAZE_OK)
        trace_clear(out);
    return status;
}

void trace_clear(graze_trace *trace) {
    for (size_t k = 0; k < trace->contact_count; k++)
        contact_clear(&trace->contact[k]);
    free(trace->contact);
    free(trace->word);
    *trace = (graze_trace){.word = NULL};
}
