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
                                crossing whose time is not wanted */
    graze_cell *cell;
    size_t cell_count, cell_capacity;
} contact;

/** States that are not decided: the first time at which one is not, the primitives it depends on
 * and the reason; and whether any of them may be I, or O (proofs/curved.md C125). */
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

/** A query point: d rationals, or d finite doubles that are meant exactly; the other is NULL. */
typedef struct query_point {
    const fmpq *rational;
    const double *value;
} query_point;

/** Wanted part of a trace. */
typedef enum trace_detail {
    TRACE_CONTACTS, /* contacts with times and cells */
    TRACE_WORD,     /* states and the word */
    TRACE_PMC, /* where a certain crossing or a brick is met, that there is one, else the word */
    TRACE_PMC_BESIDE /* the same for points next to the sweep's boundary, which asks no bricks */
} trace_detail;

void trace_clear(graze_trace *trace);

/** Make those of all times of a trace; the trace means the same afterwards. */
graze_status trace_canonicalise(const graze_trace *trace, graze_context *context);

#endif
