/* The trace of a point: trajectory, candidates, touches, contacts, then the states between them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "trace/trace.h"

#include <flint/fmpz_vec.h>
#include <stdlib.h>
#include "trace/contact.h"

typedef struct tracer {
    graze_trace *out;
    graze_context *context;
    const graze_solid *solid;
    const graze_motion *motion;
    trajectory *piece; /* one trajectory per piece of the motion */
} tracer;

static graze_status trace_piece(tracer *r, size_t piece, candidates *list) {
    touches t;
    touches_init(&t);
    graze_status status = search_candidates(list, r->context, r->solid, &r->piece[piece]);
    if (status == GRAZE_OK)
        status = touches_find(&t, r->context, r->solid, &r->piece[piece], list);
    if (status == GRAZE_OK)
        status = touches_order(&t, r->context);
    if (status == GRAZE_OK)
        status = contacts_append(r->out, r->context, r->motion, piece, &t);
    touches_clear(&t);
    return status;
}

/* The state at a rational time at which the trajectory is off the boundary. */
static graze_status locate_at(graze_state *out, tracer *r, size_t piece, const fmpq_t u) {
    fmpz *x = _fmpz_vec_init(r->solid->input.dimension + 1);
    trajectory_at(x, &r->piece[piece], u);
    *out = solid_locate(r->solid, x);
    _fmpz_vec_clear(x, r->solid->input.dimension + 1);
    if (*out != GRAZE_STATE_I && *out != GRAZE_STATE_O)
        return context_fail(
            r->context, GRAZE_EINTERNAL,
            "the point between two contacts of a trace is neither inside nor outside");
    return GRAZE_OK;
}

/* The state in the gap before contact `next` and after contact next - 1; either may not be there.
 */
static graze_status gap_state(graze_state *out, tracer *r, size_t next) {
    algebraic zero, one;
    fmpq_t sample;
    algebraic_init(&zero);
    algebraic_init(&one);
    fmpq_one(one.value);
    fmpq_init(sample);
    graze_time *before = next > 0 ? r->out->contact[next - 1].to : NULL;
    graze_time *after = next < r->out->contact_count ? r->out->contact[next].from : NULL;
    size_t piece = before ? before->piece : 0;
    algebraic *low = before ? &before->u : &zero;
    if (algebraic_compare(low, &one) == 0) {
        piece++;
        low = &zero;
    }
    algebraic_between(sample, low, after && after->piece == piece ? &after->u : &one);
    graze_status status = locate_at(out, r, piece, sample);
    algebraic_clear(&zero);
    algebraic_clear(&one);
    fmpq_clear(sample);
    return status;
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
            graze_state state;
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

static graze_status trace_pieces(tracer *r, graze_operation operation, const fmpq *point) {
    candidates list = {.count = 0};
    graze_status status = context_poll(r->context);
    for (size_t k = 0; k < r->motion->piece_count && status == GRAZE_OK; k++) {
        const motion_piece *piece = &r->motion->piece[k];
        trajectory_set(&r->piece[k], operation == GRAZE_UNSWEEP ? &piece->forward : &piece->inverse,
                       point);
        status = trace_piece(r, k, &list);
    }
    free(list.item);
    return status == GRAZE_OK ? read_word(r) : status;
}

graze_status trace_point(graze_trace *out, graze_context *context, const graze_solid *solid,
                         const graze_motion *motion, graze_operation operation, const fmpq *point) {
    *out = (graze_trace){.word = NULL};
    size_t n = motion->piece_count;
    tracer r = {out, context, solid, motion, malloc(n * sizeof *r.piece)};
    if (!r.piece)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu pieces of a motion", n);
    for (size_t k = 0; k < n; k++)
        trajectory_init(&r.piece[k], motion->dimension);
    graze_status status = trace_pieces(&r, operation, point);
    for (size_t k = 0; k < n; k++)
        trajectory_clear(&r.piece[k]);
    free(r.piece);
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
