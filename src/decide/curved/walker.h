/* The walk along a trajectory: states, letters, pullbacks and fields of a moment.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_DECIDE_CURVED_WALKER_H
#define GRAZE_DECIDE_CURVED_WALKER_H

#include <flint/fmpq_poly.h>
#include "decide/curved/curved.h"

/* The field of numbers that decide a moment of a trajectory: polynomials in the local time u,
 * modulo the minimal polynomial of an exact time, or as functions on a gap between two times. */

/** A moment: a time, or a gap with a sample time. On a gap an element is zero iff it is the zero
 * polynomial, and its sign is that at the sample. Each non-constant polynomial whose sign was asked
 *  on a gap is kept: between the roots of these no answer changes (proofs/curved.md C101). */
typedef struct moment_field {
    graze_context *context;
    algebraic *time;
    fmpq_poly_t modulus; /* irreducible, with the root `time`; zero on a gap */
    fmpz_poly_struct *asked;
    size_t asked_count, asked_capacity;
    unsigned long *work; /* words of products so far, in all fields of a point */
    graze_status
        status; /* the first failure: after it nothing is computed, and answers are invalid */
} moment_field;

/** Make the field of a time; the time's polynomial may be replaced by a factor of it. */
void moment_field_init(moment_field *f, graze_context *context, algebraic *time, int on_gap,
                       unsigned long *work);
void moment_field_clear(moment_field *f);

/** Set an element to an integer polynomial in u. */
void field_set(value *out, const moment_field *f, const fmpz_poly_t p);
void field_mul(value *out, moment_field *f, const value *a, const value *b);
/** Count products of words, so that the caller can cancel every few milliseconds, and words of
 * results; if the words exceed the limit `work`, the status is GRAZE_ELIMIT, without a message. */
void field_charge(moment_field *f, unsigned long products, unsigned long words);
/** out += a b, out -= a b */
void field_addmul(value *out, moment_field *f, const value *a, const value *b);
void field_submul(value *out, moment_field *f, const value *a, const value *b);
/** The sign of an element: -1, 0 or 1; 0 after a failure. */
int field_sign(moment_field *f, const value *a);

/** Allocate `count` zeros as one block; NULL if memory runs out, which becomes the status. */
value *field_vector(moment_field *f, size_t count);
/** Free a vector, which may be NULL. */
void field_vector_clear(value *vector, size_t count);

/* The surfaces of a curved solid along one piece of a trajectory: polynomials in the local time
 * and their sorted roots. */

/** A surface that vanishes at a time. */
typedef struct zero {
    size_t time, surface; /* time: its index in the list of times, after pullbacks_set its rank */
} zero;

/** The times are both ends of a window and all roots in it. Times of equal rank r are equal;
 * by_rank[r] is one of them. */
typedef struct pullbacks {
    graze_context *context;
    const csg *solid;
    fmpz_poly_struct *form; /* by surface: its pullback, set for the asked surfaces */
    size_t *asked;
    size_t asked_count, asked_capacity;
    algebraic_list time;
    algebraic **by_rank;
    size_t rank_count;
    zero *zero; /* sorted by rank */
    size_t zero_count, zero_capacity;
    size_t *slide; /* surfaces that contain the whole piece */
    size_t slide_count;
} pullbacks;

/** @return GRAZE_ESYSTEM; the caller calls pullbacks_clear, also on failure */
graze_status pullbacks_init(pullbacks *p, graze_context *context, const csg *solid);
void pullbacks_clear(pullbacks *p);

/** Set the polynomials and roots for a trajectory and a window.
 * @param asked the window's candidates: surfaces, perhaps with duplicates */
graze_status pullbacks_set(pullbacks *p, const trajectory *c, const exact_window *window,
                           const candidate *asked);

/* The state of the trajectory at a moment, by the surfaces through its point. */

/** A point c(u) of a trajectory, and the expression over the surfaces there. */
typedef struct state_query {
    const csg *solid;
    const trajectory *c;
    const size_t *surface; /* surfaces through the point on which the expression depends */
    int count;             /* at most CSG_FREE_MOST */
    pattern_set truth;     /* patterns of their signs for which the expression is true */
    int near_in, near_out; /* the solid's interior, its exterior, come arbitrarily near */
} state_query;

/** Decide the state at a time, or on the part of a gap around the sample in which the polynomials
 * that the field keeps have no root (proofs/curved.md C100).
 * @param[out] out I, B, O, or GRAZE_STATE_UNDECIDED if no rule decides */
graze_status state_decide(graze_state *out, const state_query *at, moment_field *f);

/* Stacks: the signs of surfaces on two vertical lines beside a point of the plane, so near the
 * point that all patterns that occur near the point occur on these lines. */

/** Decide the state in the plane at a time, or along a gap by its sample (proofs/curved.md C126,
 * C127).
 * @param[out] out I, B or O; UNDECIDED if the surfaces exceed the limit `work`
 * @param signs    signs of the surfaces that do not vanish there
 * @param surface  the surfaces through the point on which the expression depends: two or more, or
 * one that is singular there
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status stack_decide(graze_state *out, const expression *signs, const trajectory *c,
                          const size_t *surface, size_t count, algebraic *time);

/* Builds the word and the contacts of a trace from states in order of time. */

/** States are put alternately for a time and for the gap after it, from the first time to the last.
 * A time may be left out if it and both gaps beside it have one state. */
typedef struct word_builder {
    graze_trace *out;
    graze_context *context;
    const graze_motion *motion;
    size_t length, capacity; /* of the word */
} word_builder;

/** Put the state at a time. */
graze_status word_put_time(word_builder *l, graze_state state, size_t piece, const algebraic *u);

/** Put the state of the gap between the last time and the next one. */
graze_status word_put_gap(word_builder *l, graze_state state);

/** Put a certain crossing whose time is not needed; the gap after it is put next. */
graze_status word_put_crossing(word_builder *l);

/** Add a primitive to the cells of a contact, unless it is one of them. */
graze_status word_add_cell(word_builder *l, contact *c, size_t primitive);

/* The states of a trajectory in the windows of time that are decided exactly. */

/** State of the walk. Between windows the caller sets `before` and the expression's signs. */
typedef struct walker {
    tracer *r;
    const csg *solid;
    word_builder *word;
    expression expression;
    pullbacks at;
    size_t piece;
    const trajectory *c;
    algebraic *pending; /* a time whose state is not yet put, until the gap after it is known */
    size_t *vanishing;  /* surfaces that vanish at the pending time */
    size_t vanishing_count;
    unsigned long work; /* work of the rules, for the limit */
    int limited;        /* the limit was met */
    graze_state before; /* the state of the gap before the pending time; ABSENT at the start of the
                           motion */
} walker;

/** @return GRAZE_ESYSTEM; the caller calls walker_clear, also on failure */
graze_status walker_init(walker *w, tracer *r, word_builder *word);
void walker_clear(walker *w);

/** Put the states of a window into the word. If it ends with its piece, its last time becomes
 * pending.
 * @param asked the surfaces that may vanish in the window */
graze_status walker_walk(walker *w, const exact_window *window, const candidate *asked);

/** Put the state of the pending time, if there is one; the gap after it has the state `after`. */
graze_status walker_settle(walker *w, graze_state after);

#endif
