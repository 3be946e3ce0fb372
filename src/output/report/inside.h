/* The first and the last time at which a point is in the closed solid
 * (src/program/cli/formats.md, Tables). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_INSIDE_H
#define GRAZE_REPORT_INSIDE_H

#include "base/number/json.h"
#include "decide/trace/trace.h"

/** One of them: an end of the motion, or else an end of a contact, and the piece. */
typedef struct inside_end {
    const fmpq *end;        /* t0 or t1; borrowed from the motion */
    const graze_time *time; /* NULL beside an end, and where the point is never inside; borrowed */
    size_t piece;           /* the first, or the last, one that has the time, its ends too */
} inside_end;

/** Both, or neither. */
typedef struct inside_times {
    inside_end first, last;
    int undecided; /* a state of the trajectory is not decided, so neither is said */
} inside_times;

/**
 * Find them by a trace with contacts (proofs/claims.md C8), whose times of them become canonical.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status inside_find(inside_times *out, graze_context *context, const graze_motion *motion,
                         const graze_trace *trace);

/** Add the names of their columns, each with a comma before it: with rows where pieces have such.
 */
void inside_columns(text *out, const graze_motion *motion);
/** Add their fields, each with a comma before it. */
void inside_csv(text *out, const inside_times *m, const graze_motion *motion);
/** Add them to an object. */
void inside_json(json_writer *w, const inside_times *m, const graze_motion *motion);

#endif
