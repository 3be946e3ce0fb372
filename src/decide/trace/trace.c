/* Traces, cleared and made canonical.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <stdlib.h>

static void contact_clear(contact *c) {
    if (c->to != c->from)
        time_destroy(c->to);
    time_destroy(c->from);
    free(c->cell);
}

void trace_clear(graze_trace *trace) {
    for (size_t k = 0; k < trace->contact_count; k++)
        contact_clear(&trace->contact[k]);
    if (trace->undecided)
        contact_clear(&trace->undecided->where);
    free(trace->undecided);
    free(trace->contact);
    free(trace->word);
    *trace = (graze_trace){.word = NULL};
}

graze_status trace_canonicalise(const graze_trace *trace, graze_context *context) {
    size_t count = 0;
    graze_time **time = flint_malloc((2 * trace->contact_count + 1) * sizeof(graze_time *));
    if (trace->undecided)
        time[count++] = trace->undecided->where.from;
    for (size_t k = 0; k < trace->contact_count; k++) {
        const contact *c = &trace->contact[k];
        if (c->from)
            time[count++] = c->from;
        if (c->to && c->to != c->from)
            time[count++] = c->to;
    }
    graze_status status = times_canonicalise(time, count, context);
    flint_free(time);
    return status;
}
