/* The states between the contacts of a trace, and its word.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <stdlib.h>
#include "base/context/scope.h"

static graze_status locate_between(graze_state *out, tracer *r, graze_time *before,
                                   graze_time *after) {
    size_t piece;
    LOCAL(fmpq, sample);
    TRY(time_between(&piece, sample, r->context, before, after));
    return tracer_locate(out, r, piece, sample);
}

/* Locate the gap between two contacts with times, or an end of the motion for NULL: that end is
 * itself off the boundary. */
static graze_status locate_gap(graze_state *out, tracer *r, graze_time *before, graze_time *after) {
    if (before && after)
        return locate_between(out, r, before, after);
    LOCAL(fmpq, end);
    fmpq_set_si(end, before ? 1 : 0, 1);
    graze_status status =
        tracer_locate(out, r, before ? r->scene->motion->piece_count - 1 : 0, end);
    return status;
}

/* The state in the gap before contact `next` and after contact next - 1; either may not be there.
 * The crossings beside it know it; without them it is located. */
static graze_status gap_state(graze_state *out, tracer *r, size_t next) {
    const contact *before = next > 0 ? &r->out->contact[next - 1] : NULL;
    const contact *after = next < r->out->contact_count ? &r->out->contact[next] : NULL;
    graze_state left = before && !before->to ? before->right : GRAZE_STATE_ABSENT;
    graze_state right = after && !after->from ? after->left : GRAZE_STATE_ABSENT;
    if (left && right && left != right)
        return context_fail(
            r->context, GRAZE_EINTERNAL,
            "two crossings, one after the other, disagree on the state between them");
    *out = left ? left : right;
    if (left || right)
        return GRAZE_OK;
    return locate_gap(out, r, before ? before->to : NULL, after ? after->from : NULL);
}

graze_status word_read(tracer *r) {
    graze_trace *out = r->out;
    size_t n = out->contact_count, length = 0;
    int starts_on = n > 0 && time_is_start(out->contact[0].from);
    int ends_on = n > 0 && time_is_end(out->contact[n - 1].to);
    out->word = malloc(2 * n + 2);
    if (!out->word)
        return context_fail(r->context, GRAZE_ESYSTEM, "out of memory for the word of a trace");
    for (size_t k = 0; k <= n; k++) {
        if (!(k == 0 && starts_on) && !(k == n && ends_on)) {
            graze_state state = GRAZE_STATE_ABSENT;
            TRY(gap_state(&state, r, k));
            out->word[length++] = (char)state;
            if (k > 0)
                out->contact[k - 1].right = state;
            if (k < n)
                out->contact[k].left = state;
        }
        if (k < n)
            out->word[length++] = 'B';
    }
    out->word[length] = '\0';
    out->first = (graze_state)out->word[0];
    out->last = (graze_state)out->word[length - 1];
    return GRAZE_OK;
}
