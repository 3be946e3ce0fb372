/* Traces, cleared and made canonical.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "trace/trace.h"

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
    free(trace->contact);
    free(trace->word);
    *trace = (graze_trace){.word = NULL};
}

graze_status trace_canonicalise(const graze_trace *trace, graze_context *context) {
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < trace->contact_count && status == GRAZE_OK; k++) {
        const contact *c = &trace->contact[k];
        if (c->from)
            status = time_canonicalise(c->from, context);
        if (c->to && status == GRAZE_OK)
            status = time_canonicalise(c->to, context);
    }
    return status;
}
