/* The states at contact times, and at rational times between them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The interiors meet in an open set of times, the closed solids in a closed set. So a time at which
 * the boundaries meet has the state B if a gap beside it has O or B, and the state I or B if each
 * gap beside it has I.
 */
#include "base/context/scope.h"
#include "questions/collide/near_pairs.h"

/* The gap after a first contact begins is examined at 2^-SOON of the way to the interval's end,
 * where few other pairs are near. */
enum { SOON = 8 };

/* The pair at one time: the simplices that may meet, and exact places. */
typedef struct scene_then {
    int within; /* some pair is nearer than the clearance, and `near` is not complete */
    near_list near;
    placing p;
    int placed;
} scene_then;

void pair_walk_clear(pair_walk *walk) {
    for (size_t k = 0; k < walk->contact_count; k++)
        free(walk->contact[k].cells.item);
    for (size_t k = 0; k < walk->time_count; k++)
        time_destroy(walk->time[k]);
    free(walk->contact);
    free(walk->word);
    free(walk->time);
    fmpq_clear(walk->looked);
    *walk = (pair_walk){0};
}

static void scene_then_clear(scene_then *s) {
    near_list_clear(&s->near);
    if (s->placed)
        placing_clear(&s->p);
}

/* Place both solids at a rational time, and find the pairs. */
static graze_status place_both_at(scene_then *out, pair_walk *walk, size_t piece, const fmpq_t u,
                                  const node_list *of) {
    placing_init(&out->p, walk->context, walk->pair, piece, u);
    out->placed = 1;
    return near_pairs_find(&out->near, &out->within, &out->p, &unit_interval, of);
}

/* Find the pairs at a time: if it is irrational, from the motion during its isolating interval,
 * which is narrowed first. */
static graze_status place_both_then(scene_then *out, pair_walk *walk, const placing *whole,
                                    graze_time *time, const node_list *of) {
    ulong gain = FIRST_GAIN;
    for (int step = 0; step < 2 * CHEAP_HALVINGS && !algebraic_is_rational(&time->u); step++)
        TRY(algebraic_narrow(walk->context, &time->u, step, &gain));
    return algebraic_is_rational(&time->u)
               ? place_both_at(out, walk, time->piece, time->u.value, of)
               : near_pairs_find(&out->near, &out->within, whole, &time->u.where, of);
}

static graze_status add_letter(pair_walk *walk, graze_state state) {
    return word_append(&walk->word, &walk->length, &walk->word_capacity, walk->context, state,
                       "the word of a pair");
}

/* Keep a time as the last one. */
static graze_status keep_time(pair_walk *walk, size_t piece, const algebraic *u) {
    TRY(ARRAY_GROW(walk->context, walk->time, walk->time_capacity, walk->time_count + 1,
                   "the times of a pair"));
    TRY(time_make(&walk->last, walk->context, walk->pair->motion, piece, u));
    walk->time[walk->time_count++] = walk->last;
    return GRAZE_OK;
}

static graze_status keep_rational(pair_walk *walk, size_t piece, const fmpq_t u) {
    HELD(algebraic, x);
    fmpq_set(x.value, u);
    return keep_time(walk, piece, &x);
}

/* Begin a contact at the last time, with the cells that meet at a placing. */
static graze_status open_contact(pair_walk *walk, graze_state left, placing *p,
                                 const near_list *near) {
    TRY(ARRAY_GROW(walk->context, walk->contact, walk->contact_capacity, walk->contact_count + 1,
                   "the contacts of a pair"));
    pair_contact *c = &walk->contact[walk->contact_count++];
    *c = (pair_contact){.left = left, .from = walk->last};
    walk->open = 1;
    cell_pairs_find(&c->cells, p, near);
    return p->status;
}

/* Enter a gap with its state: an open contact goes on in B, and has ended in any other state. */
static graze_status enter_gap(pair_walk *walk, graze_state state) {
    walk->gap = state;
    if (walk->open && state != GRAZE_STATE_B) {
        walk->contact[walk->contact_count - 1].right = state;
        walk->open = 0;
    }
    walk->done = walk->until ? state == walk->until : walk->first && walk->contact_count;
    return add_letter(walk, state);
}

/* Enter the gap after t0, at which there is no incidence; if the gap has the state B, a contact
 * begins at t0. */
static graze_status enter_start(pair_walk *walk, graze_state state, scene_then *then) {
    if (state == GRAZE_STATE_B) {
        LOCAL(fmpq, zero);
        TRY(keep_rational(walk, 0, zero));
        TRY(open_contact(walk, GRAZE_STATE_ABSENT, &then->p, &then->near));
    }
    return enter_gap(walk, state);
}

/* Find the state at a rational time, and enter the gap around it. */
static graze_status look_into_gap(pair_walk *walk, size_t piece, const fmpq_t u) {
    ZEROED(scene_then, then);
    TRY(place_both_at(&then, walk, piece, u, NULL));
    graze_state state = then.within ? GRAZE_STATE_I : interiors_look(&then.p, &then.near, NULL);
    TRY(then.p.status);
    walk->looked_piece = piece;
    fmpq_set(walk->looked, u);
    return walk->last ? enter_gap(walk, state) : enter_start(walk, state, &then);
}

graze_status pair_walk_begin(pair_walk *walk) {
    if (!walk->first)
        return GRAZE_OK;
    LOCAL(fmpq, zero);
    graze_status status = look_into_gap(walk, 0, zero);
    walk->done = walk->gap == (walk->until ? walk->until : GRAZE_STATE_I);
    if (walk->gap == GRAZE_STATE_B) { /* the contact may last only an instant */
        walk->gap = GRAZE_STATE_ABSENT;
        walk->contact[0].to = walk->last;
    }
    return status;
}

graze_status pair_walk_on(pair_walk *walk, size_t piece, const fmpq_t u) {
    if (!walk->open || walk->gap)
        return GRAZE_OK;
    LOCAL_VEC(fmpq, after, 2);
    fmpq *step = after + 1;
    if (walk->last->piece == piece)
        algebraic_bounds(step, after, &walk->last->u);
    fmpq_sub(step, u, after);
    fmpq_div_2exp(step, step, SOON);
    fmpq_add(after, after, step);
    if (fmpq_sgn(step) > 0)
        TRY(look_into_gap(walk, piece, after));
    return GRAZE_OK;
}

/* Find the state, I or B, at a time at which the boundaries meet: t0, or a time whose gap before it
 * has the state I. `u`, on the piece `before`, is a rational time in that gap. */
static graze_status look_at_contact(graze_state *out, pair_walk *walk, scene_then *then, placing *p,
                                    size_t before, const fmpq_t u) {
    HELD(placing, rational, walk->context, walk->pair, before, u);
    *out = then->within ? GRAZE_STATE_I : interiors_look(p, &then->near, &rational);
    if (!p->status && *out == GRAZE_STATE_O)
        return context_fail(walk->context, GRAZE_EINTERNAL,
                            "two boundaries that meet have no point in common");
    return p->status;
}

/* Enter the state at the last time, which was just reached. */
static graze_status enter_time(pair_walk *walk, graze_state left, graze_state state, placing *p,
                               const near_list *near) {
    TRY(add_letter(walk, state));
    walk->gap = state == GRAZE_STATE_I ? GRAZE_STATE_I : GRAZE_STATE_ABSENT;
    if (state != GRAZE_STATE_B)
        return GRAZE_OK;
    if (!walk->open)
        TRY(open_contact(walk, left, p, near));
    walk->contact[walk->contact_count - 1].to = walk->last;
    return GRAZE_OK;
}

/* Find and enter the state at the last time; `left` is the state of the gap before. */
static graze_status walk_into(pair_walk *walk, placing *whole, graze_state left, size_t before,
                              const fmpq_t u, const node_list *near) {
    ZEROED(scene_then, then);
    graze_time *time = walk->last;
    graze_state state = GRAZE_STATE_B;
    TRY(place_both_then(&then, walk, whole, time, near));
    placing *p = then.placed ? &then.p : whole;
    placing_set_time(whole, &time->u);
    if (left != GRAZE_STATE_O && left != GRAZE_STATE_B)
        TRY(look_at_contact(&state, walk, &then, p, before, u));
    return enter_time(walk, left, state, p, &then.near);
}

/* Is a time equal to the last one? The end of a piece is the beginning of the next one. */
static graze_status is_last(int *out, pair_walk *walk, size_t piece, algebraic *time) {
    int order = 1;
    if (walk->last && walk->last->piece == piece)
        TRY(algebraic_compare(&order, walk->context, &walk->last->u, time));
    else if (walk->last && walk->last->piece + 1 == piece)
        order = !time_is_piece_end(walk->last) || !algebraic_is_rational(time) ||
                !fmpq_is_zero(time->value);
    *out = order == 0;
    return GRAZE_OK;
}

static graze_status walk_to_next(pair_walk *walk, placing *whole, graze_time *next,
                                 const node_list *near) {
    size_t before = 0;
    LOCAL(fmpq, u); /* a time of the gap before `next`: t0 if there is no last time */
    if (walk->last && !time_is_start(next))
        TRY(time_between(&before, u, walk->context, walk->last, next));
    if (!walk->gap && !time_is_start(next))
        TRY(look_into_gap(walk, before, u));
    graze_state left = walk->gap;
    if (walk->done)
        return GRAZE_OK;
    TRY(keep_time(walk, next->piece, &next->u));
    return walk_into(walk, whole, left, before, u, near);
}

graze_status pair_walk_to(pair_walk *walk, placing *whole, size_t piece, const algebraic *time,
                          const node_list *near) {
    int same = 0;
    HELD(algebraic, own);
    algebraic_set(&own, time);
    TRY(is_last(&same, walk, piece, &own));
    if (same)
        return GRAZE_OK;
    graze_time *next;
    TRY(time_make(&next, walk->context, walk->pair->motion, piece, &own));
    graze_status status = walk_to_next(walk, whole, next, near);
    time_destroy(next);
    return status;
}

graze_status pair_walk_pass(pair_walk *walk, size_t piece, const fmpq_t u) {
    TRY(walk->gap ? GRAZE_OK : enter_gap(walk, GRAZE_STATE_I));
    return walk->done ? GRAZE_OK : keep_rational(walk, piece, u);
}

graze_status pair_walk_end(pair_walk *walk) {
    size_t piece = walk->pair->motion->piece_count - 1;
    if (walk->done || (walk->last && time_is_end(walk->last)))
        return GRAZE_OK;
    LOCAL(fmpq, end);
    if (!walk->last && !walk->gap)
        TRY(look_into_gap(walk, 0, end)); /* a contact that lasts begins at t0 */
    fmpq_one(end);
    if (!walk->gap)
        TRY(look_into_gap(walk, piece, end));
    if (walk->open) {
        TRY(keep_rational(walk, piece, end));
        walk->contact[walk->contact_count - 1].to = walk->last;
    }
    return GRAZE_OK;
}
