/* The first and the last time at which a point is in the closed solid
 * (src/program/cli/formats.md, Tables). SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_REPORT_INSIDE_H
#define GRAZE_REPORT_INSIDE_H

#include "base/number/json.h"
#include "decide/trace/trace.h"

/** The first or last such time: an end of the motion or of a contact, and its piece. */
typedef struct inside_end {
    const fmpq *end;        /* t0 or t1; borrowed from the motion */
    const graze_time *time; /* NULL if `end` is set, or if the point is never inside; borrowed */
    size_t piece;           /* the first, or the last, piece that has the time, counting its ends */
} inside_end;

/** Both times, or neither. */
typedef struct inside_times {
    inside_end first, last;
    int undecided; /* a state of the trajectory is undecided, so neither time is given */
} inside_times;

/** Find both times from a trace with contacts (proofs/claims.md C8); the times become canonical.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED
 */
graze_status inside_find(inside_times *out, graze_context *context, const graze_motion *motion,
                         const graze_trace *trace);

/** Append the names of their columns, a comma before each; with columns for rows if the motion's
 * pieces have rows.
 */
void inside_columns(text *out, const graze_motion *motion);
/** Append their fields, a comma before each. */
void inside_csv(text *out, const inside_times *m, const graze_motion *motion);
/** Add them to a JSON object. */
void inside_json(json_writer *w, const inside_times *m, const graze_motion *motion);

#endif
