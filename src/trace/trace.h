/* The trace of one point: its contacts with the boundary in order of time, and the word.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_TRACE_H
#define GRAZE_TRACE_TRACE_H

#include "number/algebraic.h"
#include "scene/scene.h"

/**
 * A time of the motion: piece `piece`, local parameter u in [0, 1]. In the motion's parameter it is
 * lo + (hi - lo) u. `poly`, `low`, `high` are its canonical form there, made once when the time is
 * asked for: minimal polynomial, and the widest isolating dyadic interval (both ends the value
 * itself when it is rational).
 */
struct graze_time {
    size_t piece;
    algebraic u;
    const graze_motion *motion;
    int canonical; /* 0 until poly, low, high are made */
    fmpz_poly_t poly;
    fmpq_t low, high;
};

/** One contact (proofs/semantics.md 2): states on both sides, exact ends, cells. */
typedef struct contact {
    graze_state left, right; /* I, O, or ABSENT at an end of the motion */
    graze_time *from, *to;   /* the same pointer for an instant; owned by the trace; both NULL for a
                                crossing whose time was not asked for */
    graze_cell *cell;
    size_t cell_count;
} contact;

struct graze_trace {
    graze_state first, last; /* states at t0 and t1: I, B or O */
    size_t contact_count;
    contact *contact;
    char *word;
    graze_verdict verdict; /* filled by the verdict stage */
};

/** A query point: d rationals, or d finite doubles that are meant exactly; the other is NULL. */
typedef struct query_point {
    const fmpq *rational;
    const double *value;
} query_point;

/** How much of a trace is wanted: contacts with times and cells, or states and the word alone. */
typedef enum trace_detail { TRACE_CONTACTS, TRACE_WORD } trace_detail;

/**
 * Trace the curve t -> map(t) P through the solid, where map is the motion's inverse (sweep) or the
 * motion itself (unsweep). The verdict stays empty (verdict/classify.h fills it).
 * @param[out] out uninitialised; cleared by trace_clear. With TRACE_WORD its contacts may lack
 * times and cells.
 */
graze_status trace_point(graze_trace *out, graze_context *context, const graze_scene *scene,
                         query_point point, trace_detail detail);
void trace_clear(graze_trace *trace);

/** Make the canonical form of a time; idempotent. The context may be NULL: then there is no limit.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED */
graze_status time_canonicalise(graze_time *time, graze_context *context);

/** Make those of all times of a trace; the trace means the same afterwards. */
graze_status trace_canonicalise(const graze_trace *trace, graze_context *context);

#endif
