/* One row: finds the events of each piece of the motion and intervals around them, and cuts the
 * gaps between these until the checker's tests succeed.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/certify/prove.h"

#include "base/context/scope.h"
#include "decide/verdict/verdict.h"

enum { DEEPEST = 2000 };

/* A time at which the trajectory is on the boundary and its state or cell changes: the root of q, a
 * polynomial in u. */
typedef struct event {
    fmpz_poly_t q;
    dyadic_interval at, known; /* `at`: the interval of the certificate; `known`: the one that
                                  isolates the time from the start */
    int place;                 /* -1: u = 0; 1: u = 1; else 0 */
    int irreducible;           /* q is known to be irreducible */
} event;

typedef struct piece_row {
    row_lines *lines;
    graze_context *context;
    const certifier *with;
    trajectory *c;
    touches *t;
    enclosure *e;
    size_t count;
    event *event;
    char *gap; /* count + 1 state letters: before the first event, between two events, after the
                  last */
} piece_row;

static graze_status row_no_memory(graze_context *context) {
    return context_fail(context, GRAZE_ESYSTEM, "out of memory for a certificate");
}

/* ------------------------------------------------------------------------------------- events */

/* Replace q by its irreducible factor with the root, which divides each pullback that is 0 at the
 * time. Returns 1 if the degree fell. */
static int find_factor(event *v) {
    slong degree = fmpz_poly_degree(v->q);
    (void)algebraic_factor(v->q, v->q, &v->known);
    v->irreducible = 1;
    return fmpz_poly_degree(v->q) < degree;
}

static void set_linear(fmpz_poly_t q, const fmpq_t root) {
    LOCAL(fmpz, c);
    fmpz_neg(c, fmpq_numref(root));
    fmpz_poly_zero(q);
    fmpz_poly_set_coeff_fmpz(q, 0, c);
    fmpz_poly_set_coeff_fmpz(q, 1, fmpq_denref(root));
}

static void event_set(event *v, const algebraic *time) {
    fmpz_poly_init(v->q);
    dyadic_interval_init(&v->at);
    dyadic_interval_init(&v->known);
    dyadic_interval_set_si(&v->at, 0, 1);
    dyadic_interval_set_si(&v->known, 0, 1);
    v->place = 0;
    v->irreducible = algebraic_is_rational(time);
    if (!v->irreducible) {
        dyadic_interval_set(&v->known, &time->where);
        fmpz_poly_set(v->q, time->poly);
        return;
    }
    set_linear(v->q, time->value);
    v->place = fmpq_is_zero(time->value) ? -1 : fmpq_is_one(time->value) ? 1 : 0;
}

/* Find the letter, I or O, between two neighbouring times by locating one point. NULL for `from`
 * stands for u = 0, NULL for `to` for u = 1. */
static graze_status find_gap(char *out, piece_row *r, algebraic *from, algebraic *to) {
    LOCAL(fmpq, u);
    if (from && to)
        TRY(algebraic_between(u, r->context, from, to));
    else if (to)
        fmpq_zero(u);
    else
        fmpq_one(u);
    LOCAL_VEC(fmpz, x, r->c->dimension + 1);
    trajectory_at(x, r->c, u);
    graze_state state = solid_locate(r->with->solid, x);
    *out = state == GRAZE_STATE_I ? 'I' : 'O';
    return state == GRAZE_STATE_I || state == GRAZE_STATE_O
               ? GRAZE_OK
               : context_fail(r->context, GRAZE_EINTERNAL,
                              "the point between two contacts is neither inside nor outside");
}

static graze_status find_gaps(piece_row *r) {
    for (size_t k = 0; k < r->t->count; k++)
        for (size_t j = r->t->item[k].from; j < r->t->item[k].to; j++)
            r->gap[j + 1] = 'B';
    for (size_t k = 0; k <= r->count; k++) {
        algebraic *from = k > 0 ? &r->t->time.item[r->t->by_rank[k - 1]] : NULL;
        algebraic *to = k < r->count ? &r->t->time.item[r->t->by_rank[k]] : NULL;
        int is_gap = (k > 0 || r->count == 0 || r->event[0].place != -1) &&
                     (k < r->count || r->count == 0 || r->event[k - 1].place != 1);
        if (is_gap && r->gap[k] != 'B')
            TRY(find_gap(&r->gap[k], r, from, to));
    }
    return GRAZE_OK;
}

static graze_status find_events(piece_row *r) {
    ZEROED(candidates, list);
    TRY(candidates_find(&list, r->context, r->with->solid, r->c));
    TRY(touches_find(r->t, r->context, r->with->solid, r->c, NULL, &list));
    TRY(touches_order(r->t, r->context));
    for (size_t k = 0; k < r->t->count; k++)
        r->count = r->t->item[k].to + 1 > r->count ? r->t->item[k].to + 1 : r->count;
    r->event = calloc(r->count + 1, sizeof *r->event);
    r->gap = calloc(r->count + 1, 1);
    if (!r->event || !r->gap) {
        r->count = 0;
        return row_no_memory(r->context);
    }
    for (size_t k = 0; k < r->count; k++)
        event_set(&r->event[k], &r->t->time.item[r->t->by_rank[k]]);
    for (size_t k = 0; k < r->count && r->with->with_contacts; k++)
        if (!r->event[k].irreducible)
            (void)find_factor(
                &r->event[k]); /* contacts are written with the irreducible polynomial */
    return find_gaps(r);
}

/* ---------------------------------------------------------------------------------- intervals */

static void halve(dyadic_interval *at, int upper) {
    HELD(dyadic_interval, left);
    HELD(dyadic_interval, right);
    dyadic_interval_halves(&left, &right, at);
    dyadic_interval_swap(at, upper ? &right : &left);
}

/* Reduce an interval to its middle half. */
static void keep_middle(dyadic_interval *at) {
    LOCAL(fmpz, width);
    fmpz_sub(width, at->high, at->low);
    fmpz_mul_2exp(at->low, at->low, 2);
    fmpz_mul_2exp(at->high, at->high, 2);
    fmpz_add(at->low, at->low, width);
    fmpz_sub(at->high, at->high, width);
    at->exponent += 2;
}

/* The sign of a / 2^i - b / 2^j. */
static int compare_ends(const fmpz_t a, ulong i, const fmpz_t b, ulong j) {
    LOCAL_VEC(fmpz, x, 2);
    fmpz *y = x + 1;
    fmpz_mul_2exp(x, a, j);
    fmpz_mul_2exp(y, b, i);
    return fmpz_cmp(x, y);
}

/* Reduce `at` to one half that holds the time: the lower, the upper or, if the time is the
 * midpoint, the middle half. */
static void narrow(event *v) {
    if (v->place) {
        halve(&v->at, v->place > 0);
        return;
    }
    LOCAL(fmpz, middle);
    ulong exponent = v->at.exponent + 1;
    fmpz_add(middle, v->at.low, v->at.high);
    int sign = 0;
    if (compare_ends(middle, exponent, v->known.high, v->known.exponent) >= 0)
        halve(&v->at, 0);
    else if (compare_ends(middle, exponent, v->known.low, v->known.exponent) <= 0)
        halve(&v->at, 1);
    else if ((sign = dyadic_sign(v->q, middle, exponent)) == 0)
        keep_middle(&v->at);
    else
        halve(&v->at, sign == dyadic_sign(v->q, v->known.low, v->known.exponent));
}

static int precedes(const event *v, const event *w) {
    return compare_ends(v->at.high, v->at.exponent, w->at.low, w->at.exponent) < 0;
}

/* Is `at` strictly inside (0, 1), except at an end that is the time itself? */
static int is_inside(const event *v) {
    return (v->place == -1 || fmpz_sgn(v->at.low) > 0) &&
           (v->place == 1 || compare_ends(v->at.high, v->at.exponent, &(fmpz){1}, 0) < 0);
}

/* Fail because no interval could be proved: memory is short, or the intervals became too short. */
static graze_status too_deep(const piece_row *r) {
    if (r->e->out_of_memory)
        return row_no_memory(r->context);
    return context_fail(r->context, GRAZE_EINTERNAL,
                        "a part of a trajectory cannot be certified in %d halvings", DEEPEST);
}

/* Narrow the interval of each event until it is apart from the others and the claim about it can be
 * proved. */
static graze_status place_events(piece_row *r) {
    for (size_t k = 0; k < r->count; k++)
        for (int n = 0; !is_inside(&r->event[k]) ||
                        (!r->event[k].place && !prove_isolated(r->event[k].q, &r->event[k].at));
             n++) {
            if (n > DEEPEST)
                return too_deep(r);
            narrow(&r->event[k]);
        }
    for (size_t k = 1; k < r->count; k++)
        for (int n = 0; !precedes(&r->event[k - 1], &r->event[k]); n++) {
            if (n > DEEPEST)
                return too_deep(r);
            narrow(&r->event[k - 1]);
            narrow(&r->event[k]);
        }
    for (size_t k = 0; k < r->count; k++) {
        event *v = &r->event[k];
        root_claim claim = {r->gap[k], r->gap[k + 1], v->q};
        if (v->place && (claim.left == 'B' || claim.right == 'B'))
            continue; /* the interval of the slide contains this end, so it needs no claim of its
                         own */
        for (int n = 0; !prove_root(r->e, &v->at, claim); n++) {
            if (n > DEEPEST)
                return too_deep(r);
            if (v->irreducible || !find_factor(v))
                narrow(v);
        }
    }
    return GRAZE_OK;
}

/* --------------------------------------------------------------------------------------- text */

static void put_event(piece_row *r, const event *v, char left, char right) {
    char kind[4] = {left, 'B', right, 0};
    if (v->place) {
        kind[0] = v->place < 0 ? 'B' : left;
        kind[1] = v->place < 0 ? right : 'B';
        kind[2] = 0;
    }
    row_lines_put(r->lines, kind, v->at.high, v->at.exponent, v->place ? NULL : v->q);
}

/* Write claims of one letter on an interval, which is halved until each part can be proved. */
static graze_status put_gap(piece_row *r, char letter, const dyadic_interval *at, int depth) {
    if (letter == 'B' ? prove_slide(r->e, at) : prove_clear(r->e, at)) {
        const char kind[2] = {letter, 0};
        row_lines_put(r->lines, kind, at->high, at->exponent, NULL);
        return GRAZE_OK;
    }
    TRY(depth > DEEPEST || r->e->out_of_memory ? too_deep(r) : context_poll(r->context));
    HELD(dyadic_interval, left);
    HELD(dyadic_interval, right);
    dyadic_interval_halves(&left, &right, at);
    TRY(put_gap(r, letter, &left, depth + 1));
    return put_gap(r, letter, &right, depth + 1);
}

/* Set a dyadic interval to [from / 2^i, to / 2^j]. */
static void join(dyadic_interval *out, const fmpz_t from, ulong i, const fmpz_t to, ulong j) {
    ulong e = i > j ? i : j;
    fmpz_mul_2exp(out->low, from, e - i);
    fmpz_mul_2exp(out->high, to, e - j);
    out->exponent = e;
}

static graze_status put_piece(piece_row *r) {
    ulong exponent = 0;
    HELD(dyadic_interval, gap);
    LOCAL(fmpz, at);
    for (size_t k = 0; k <= r->count; k++) {
        event *v = k < r->count ? &r->event[k] : NULL;
        int held = v && v->place && (r->gap[k] == 'B' || r->gap[k + 1] == 'B');
        if (v && held && v->place < 0)
            continue;
        if (!v || held)
            join(&gap, at, exponent, &(fmpz){1}, 0);
        else
            join(&gap, at, exponent, v->at.low, v->at.exponent);
        if (fmpz_cmp(gap.low, gap.high) < 0)
            TRY(put_gap(r, r->gap[k], &gap, 0));
        if (held)
            break;
        if (!v)
            continue;
        put_event(r, v, r->gap[k], r->gap[k + 1]);
        fmpz_set(at, v->at.high);
        exponent = v->at.exponent;
    }
    return GRAZE_OK;
}

static void piece_row_clear(piece_row *r) {
    for (size_t k = 0; k < r->count; k++) {
        fmpz_poly_clear(r->event[k].q);
        dyadic_interval_clear(&r->event[k].at);
        dyadic_interval_clear(&r->event[k].known);
    }
    free(r->event);
    free(r->gap);
}

static graze_status certify_piece(row_lines *lines, graze_context *context, const certifier *with,
                                  size_t index, const fmpq *point) {
    const motion_piece *piece = &with->scene->motion->piece[index];
    filter_workspace *memory = filter_workspace_of(context);
    HELD(trajectory, c, with->scene->motion->dimension);
    HELD(touches, t);
    trajectory_set(&c, motion_tracing(piece, with->scene->options.operation), point);
    HELD(enclosure, e, with->solid, &c, with->with_contacts, memory ? &memory->forms : NULL);
    ZEROED(piece_row, r);
    r = (piece_row){.lines = lines, .context = context, .with = with, .c = &c, .t = &t, .e = &e};
    lines->piece = piece;
    TRY(find_events(&r));
    TRY(place_events(&r));
    return put_piece(&r);
}

static void write_row(text *out, const certifier *c, const fmpq *point, const graze_trace *trace) {
    const graze_verdict *v = &trace->verdict;
    text_put(out, "row");
    for (int k = 0; k < c->scene->motion->dimension; k++) {
        text_put(out, " ");
        text_rational(out, point + k);
    }
    text_format(out, " %s %s", trace->word, graze_pmc_name(v->pmc));
    if (c->scene->options.operation == GRAZE_SWEEP) {
        text_format(out, " %s ", graze_class_name(v->class_));
        if (v->definition)
            text_format(out, "%d", (int)v->definition);
        else
            text_put(out, "ext");
        text_format(out, " %d %lu %lu %lu", (int)v->case_, (unsigned long)v->i, (unsigned long)v->t,
                    verdict_k(trace->first, trace->last, v->i));
    }
    text_put(out, "\n");
}

graze_status certify_row(text *out, graze_context *context, const certifier *c, const fmpq *point,
                         const graze_trace *trace) {
    const graze_motion *motion = c->scene->motion;
    write_row(out, c, point, trace);
    HELD(row_lines, lines, out, c->with_contacts ? trace : NULL, motion);
    for (size_t k = 0; k < motion->piece_count; k++)
        TRY(certify_piece(&lines, context, c, k, point));
    if (!out->failed && lines.trace && lines.said != trace->contact_count)
        return context_fail(context, GRAZE_EINTERNAL, "%zu contacts are certified; expected %zu",
                            lines.said, trace->contact_count);
    return GRAZE_OK;
}
