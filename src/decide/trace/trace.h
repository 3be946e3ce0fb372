/* The trace of one point: its contacts with the boundary in order of time, and the word
 * (proofs/claims.md C8).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_TRACE_H
#define GRAZE_TRACE_TRACE_H

#include "decide/scene/scene.h"
#include "decide/trace/time.h"

/** One contact (proofs/semantics.md 2): states on both sides, exact ends, cells. */
typedef struct contact {
    graze_state left, right; /* I, O, or ABSENT at an end of the motion */
    graze_time *from, *to;   /* the same pointer for an instant; owned by the trace; both NULL for a
                                crossing whose time is not needed */
    graze_cell *cell;
    size_t cell_count, cell_capacity;
} contact;

/** Undecided states: the time of the first one, the primitives it depends on, and the reason; and
 * whether any undecided state may be I, or O (proofs/curved.md C125). */
typedef struct undecided_place {
    contact where;
    const char *reason; /* static */
    int may_be_in, may_be_out;
} undecided_place;

struct graze_trace {
    graze_state first, last; /* states at t0 and t1: I, B or O */
    size_t contact_count, contact_capacity;
    contact *contact;
    char *word;
    undecided_place *undecided; /* the first one, of a curved solid; or NULL */
    int settled; /* TRACE_PMC, TRACE_PMC_BESIDE: somewhere in the state that decides the membership;
                    nothing above is set */
    graze_verdict verdict; /* filled by the verdict stage */
};

/** A query point: d rationals, or d finite doubles, which are exact; the other member is NULL. */
typedef struct query_point {
    const fmpq *rational;
    const double *value;
} query_point;

/** The part of a trace that is wanted. */
typedef enum trace_detail {
    TRACE_CONTACTS,  /* contacts with times and cells */
    TRACE_WORD,      /* states and the word */
    TRACE_PMC,       /* that a certain crossing or a brick is met, if so; else the word */
    TRACE_PMC_BESIDE /* as TRACE_PMC, without bricks: for points near the sweep's boundary */
} trace_detail;

void trace_clear(graze_trace *trace);

/** Make all times of a trace canonical, which does not change its meaning. */
graze_status trace_canonicalise(const graze_trace *trace, graze_context *context);

#endif
