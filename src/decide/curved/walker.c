/* From the roots of the surfaces along a trajectory to its states, piece after piece.
 * SPDX-License-Identifier: GPL-3.0-or-later
 * Between two roots the sign of each surface is constant along the trajectory. Where the trajectory
 * runs in surfaces, the state is constant between the roots of all polynomials whose signs were
 * asked for (C101). A time is decided once the gap after it is known, since the states of both gaps
 * say whether interior and exterior come arbitrarily near (C95).
 */
#include "base/context/scope.h"
#include "base/number/isolate.h"
#include "decide/curved/walker.h"

/* Does a primitive have one of the surfaces on which the expression depends? */
static int node_meets(const csg *solid, const csg_node *node, const dependence *d) {
    for (size_t k = 0; k < node->count && node->operation == CSG_SIGN; k++)
        for (int s = 0; s < d->count; s++)
            if (solid->operand[node->first + k] == d->surface[s])
                return 1;
    return 0;
}

/* Name the primitives on whose surfaces the expression depends. */
static graze_status name_primitives(walker *w, contact *to, const dependence *d) {
    for (size_t n = 0; n < w->solid->node_count && w->r->detail == TRACE_CONTACTS; n++)
        if (node_meets(w->solid, &w->solid->node[n], d))
            TRY(word_add_cell(w->word, to, w->solid->node[n].primitive));
    return GRAZE_OK;
}

static contact *last_contact(walker *w) {
    return &w->r->out->contact[w->r->out->contact_count - 1];
}

/* Note a time or gap whose state no rule decides: the states that it may have and, of the first
 * one, where it is. `before` and `after` are the states of the gaps beside a time, which is not I
 * beside O, nor O beside I (proofs/curved.md C125). For a gap they are ABSENT. */
static graze_status keep_undecided(walker *w, const dependence *d, const algebraic *time,
                                   graze_state before, graze_state after) {
    graze_trace *out = w->r->out;
    int first = !out->undecided;
    if (first)
        out->undecided = calloc(1, sizeof *out->undecided);
    if (!out->undecided)
        return context_fail(w->r->context, GRAZE_ESYSTEM, "out of memory for a trace");
    out->undecided->may_be_in |= before != GRAZE_STATE_O && after != GRAZE_STATE_O;
    out->undecided->may_be_out |= before != GRAZE_STATE_I && after != GRAZE_STATE_I;
    if (!first)
        return GRAZE_OK;
    contact *where = &out->undecided->where;
    TRY(time_make(&where->from, w->r->context, w->r->scene->motion, w->piece, time));
    where->to = where->from;
    out->undecided->reason =
        w->limited ? "the limit work was met before a rule told which signs of these surfaces "
                     "occur near there"
        : w->c->dimension == 2
            ? "the limit `work` allows fewer surfaces, or shorter ones, to meet there"
        : d->too_many ? "more than 12 surfaces meet there"
                      : "no rule tells which signs of these surfaces occur near there";
    return name_primitives(w, where, d);
}

/* Decide the state where the expression depends on surfaces: by rules, else, in E^2, by stacks. */
static graze_status ask_state(graze_state *out, walker *w, const dependence *d, moment_field *f,
                              graze_state before, graze_state after) {
    state_query at = {.solid = w->solid,
                      .c = w->c,
                      .surface = d->surface,
                      .count = d->count,
                      .truth = d->truth,
                      .near_in = before == GRAZE_STATE_I || after == GRAZE_STATE_I,
                      .near_out = before == GRAZE_STATE_O || after == GRAZE_STATE_O};
    graze_status status = f->status;
    *out = GRAZE_STATE_UNDECIDED;
    if (!status && !d->too_many)
        status = state_decide(out, &at, f);
    w->limited = status == GRAZE_ELIMIT && w->work > w->r->context->limits[GRAZE_LIMIT_WORK];
    if (w->limited) {
        *out = GRAZE_STATE_UNDECIDED;
        return GRAZE_OK;
    }
    if (status || *out != GRAZE_STATE_UNDECIDED || w->c->dimension != 2)
        return status;
    TRY(stack_decide(out, &w->expression, w->c, d->too_many ? d->asked : d->surface,
                     d->too_many ? d->asked_count : (size_t)d->count, f->time));
    return (at.near_in && *out == GRAZE_STATE_O) || (at.near_out && *out == GRAZE_STATE_I)
               ? context_fail(f->context, GRAZE_EINTERNAL,
                              "a gap and the stacks beside its end disagree")
               : GRAZE_OK;
}

/* Decide the state at the pending time, between the gaps with the states w->before and `after`,
 * which are ABSENT beyond an end of the motion. */
static graze_status decide_time(graze_state *out, walker *w, const dependence *d,
                                graze_state after) {
    graze_state before = w->before;
    *out = d->state;
    if (*out)
        return GRAZE_OK;
    *out = GRAZE_STATE_B;
    if (before == GRAZE_STATE_B || after == GRAZE_STATE_B ||
        (before == GRAZE_STATE_I && after == GRAZE_STATE_O) ||
        (before == GRAZE_STATE_O && after == GRAZE_STATE_I))
        return GRAZE_OK;
    HELD(moment_field, f, w->r->context, w->pending, 0, &w->work);
    return ask_state(out, w, d, &f, before, after);
}

graze_status walker_settle(walker *w, graze_state after) {
    dependence d;
    graze_state state;
    if (!w->pending)
        return GRAZE_OK;
    TRY(expression_ask(&d, &w->expression, w->vanishing, w->vanishing_count));
    TRY(decide_time(&state, w, &d, after));
    if (state == GRAZE_STATE_UNDECIDED)
        TRY(keep_undecided(w, &d, w->pending, w->before, after));
    TRY(word_put_time(w->word, state, w->piece, w->pending));
    w->pending = NULL;
    return state == GRAZE_STATE_B ? name_primitives(w, last_contact(w), &d) : GRAZE_OK;
}

/* Make a time pending until the gap after it is known. At it vanish the surfaces that contain the
 * piece, and those of `zeros`. */
static void wait_for(walker *w, algebraic *time, const zero *zeros, size_t count) {
    w->pending = time;
    w->vanishing_count = 0;
    for (size_t k = 0; k < w->at.slide_count; k++)
        w->vanishing[w->vanishing_count++] = w->at.slide[k];
    for (size_t k = 0; k < count; k++)
        w->vanishing[w->vanishing_count++] = zeros[k].surface;
}

/* Put the state of the pending time, then that of the gap after it, which has one state. */
static graze_status put_whole_gap(walker *w, graze_state state, const dependence *d,
                                  const algebraic *sample) {
    TRY(walker_settle(w, state));
    if (state == GRAZE_STATE_UNDECIDED)
        TRY(keep_undecided(w, d, sample, GRAZE_STATE_ABSENT, GRAZE_STATE_ABSENT));
    TRY(word_put_gap(w->word, state));
    w->before = state;
    return state == GRAZE_STATE_B ? name_primitives(w, last_contact(w), d) : GRAZE_OK;
}

/* Find the roots, strictly between two times, of the polynomials that were asked on their gap. */
static graze_status find_slide_cuts(algebraic_list *cuts, walker *w, const moment_field *f,
                                    algebraic *low, algebraic *high) {
    HELD(algebraic_list, roots);
    for (size_t k = 0; k < f->asked_count; k++)
        TRY(algebraic_roots(&roots, w->r->context, &f->asked[k], &unit_interval));
    for (size_t k = 0; k < roots.count; k++) {
        int after = 0, before = 0;
        TRY(algebraic_compare(&after, w->r->context, &roots.item[k], low));
        TRY(algebraic_compare(&before, w->r->context, &roots.item[k], high));
        if (after > 0 && before < 0)
            algebraic_set(algebraic_list_append(cuts), &roots.item[k]);
    }
    return GRAZE_OK;
}

static graze_status walk_slide(walker *w, algebraic *low, algebraic *high);

/* Walk the parts of a gap that is cut. */
static graze_status walk_parts(walker *w, algebraic_list *cuts, algebraic *low, algebraic *high) {
    size_t count = cuts->count;
    FREED(algebraic *, order, NULL);
    TRY(MAKE_ARRAY(w->r->context, order, count, "a list of %zu times", count));
    for (size_t k = 0; k < count; k++)
        order[k] = &cuts->item[k];
    TRY(algebraic_sort_once(order, &count, w->r->context, NULL, NULL));
    for (size_t k = 0; k <= count; k++) {
        TRY(walk_slide(w, k ? order[k - 1] : low, k < count ? order[k] : high));
        if (k < count)
            wait_for(w, order[k], NULL, 0);
    }
    /* The last gap put the state of the last cut, so no time of the list is pending any longer. */
    return GRAZE_OK;
}

/* Walk a gap, cutting it where the signs beside surfaces that contain the trajectory change. */
static graze_status walk_slide(walker *w, algebraic *low, algebraic *high) {
    dependence d;
    TRY(expression_ask(&d, &w->expression, w->at.slide, w->at.slide_count));
    HELD(algebraic, sample);
    HELD(algebraic_list, cuts);
    TRY(algebraic_between(sample.value, w->r->context, low, high));
    HELD(moment_field, f, w->r->context, &sample, 1, &w->work);
    graze_state state = d.state;
    if (!state)
        TRY(ask_state(&state, w, &d, &f, GRAZE_STATE_ABSENT, GRAZE_STATE_ABSENT));
    if (!w->limited)
        TRY(find_slide_cuts(&cuts, w, &f, low, high));
    return cuts.count ? walk_parts(w, &cuts, low, high) : put_whole_gap(w, state, &d, &sample);
}

/* Set the signs in the gap after a rank: those of the surfaces that vanish at it, or of all asked
 * surfaces after the first rank. */
static graze_status update_signs(walker *w, size_t rank, const zero *zeros, size_t count) {
    size_t n = rank ? count : w->at.asked_count;
    HELD(algebraic, sample);
    TRY(algebraic_between(sample.value, w->r->context, w->at.by_rank[rank],
                          w->at.by_rank[rank + 1]));
    for (size_t k = 0; k < n; k++) {
        size_t surface = rank ? zeros[k].surface : w->at.asked[k];
        int sign = 1;
        if (!fmpz_poly_is_zero(&w->at.form[surface]))
            TRY(algebraic_sign_at(&sign, w->r->context, &w->at.form[surface], &sample));
        w->expression.sign[surface] = (signed char)sign;
    }
    return GRAZE_OK;
}

graze_status walker_walk(walker *w, const exact_window *window, const candidate *asked) {
    size_t next = 0, n;
    w->piece = window->piece;
    w->c = tracer_exact(w->r, w->piece);
    if (!w->c)
        return GRAZE_ESYSTEM;
    TRY(pullbacks_set(&w->at, w->c, window, asked));
    size_t last = w->at.rank_count - 1;
    for (size_t rank = 0; rank <= last; rank++, next += n) {
        const zero *zeros = next < w->at.zero_count ? w->at.zero + next : NULL;
        for (n = 0; next + n < w->at.zero_count && zeros[n].time == rank;)
            n++;
        /* At an end of the window that is no end of the piece none of its surfaces vanishes. */
        if (rank == 0 ? window->from == 0 : rank < last || window->to == WINDOW_WHOLE)
            wait_for(w, w->at.by_rank[rank], zeros, n);
        if (rank == last)
            break;
        TRY(update_signs(w, rank, zeros, n));
        TRY(walk_slide(w, w->at.by_rank[rank], w->at.by_rank[rank + 1]));
    }
    return GRAZE_OK;
}

graze_status walker_init(walker *w, tracer *r, word_builder *word) {
    const csg *solid = r->scene->solid->curved;
    *w = (walker){.r = r, .solid = solid, .word = word, .before = GRAZE_STATE_ABSENT};
    TRY(expression_init(&w->expression, r->context, solid));
    TRY(pullbacks_init(&w->at, r->context, solid));
    w->vanishing = malloc((solid->surface_count + 1) * sizeof *w->vanishing);
    return w->vanishing ? GRAZE_OK : context_fail(r->context, GRAZE_ESYSTEM, "out of memory");
}

void walker_clear(walker *w) {
    expression_clear(&w->expression);
    pullbacks_clear(&w->at);
    free(w->vanishing);
}
