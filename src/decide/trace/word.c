/* The states between the contacts of a trace, and its word.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include "base/context/array.h"
#include "base/context/scope.h"

static graze_status locate_between(graze_state *out, tracer *r, graze_time *before,
                                   graze_time *after) {
    size_t piece;
    LOCAL(fmpq, sample);
    TRY(time_between(&piece, sample, r->context, before, after));
    return tracer_locate(out, r, piece, sample);
}

/* Locate the gap between two contacts with times. For NULL the gap reaches to an end of the motion,
 * which is off the boundary and is located. */
static graze_status locate_gap(graze_state *out, tracer *r, graze_time *before, graze_time *after) {
    if (before && after)
        return locate_between(out, r, before, after);
    LOCAL(fmpq, end);
    fmpq_set_si(end, before ? 1 : 0, 1);
    return tracer_locate(out, r, before ? r->scene->motion->piece_count - 1 : 0, end);
}

/* The state in the gap before contact `next` and after contact next - 1; either contact may be
 * missing. A certain crossing beside the gap knows the state; without one the gap is located. */
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

graze_status word_append(char **word, size_t *length, size_t *capacity, graze_context *context,
                         graze_state state, const char *what) {
    graze_state last = *length ? (graze_state)(*word)[*length - 1] : GRAZE_STATE_ABSENT;
    if (last == state)
        return GRAZE_OK;
    if ((last == GRAZE_STATE_I && state == GRAZE_STATE_O) ||
        (last == GRAZE_STATE_O && state == GRAZE_STATE_I))
        return context_fail(context, GRAZE_EINTERNAL,
                            "a trace passes between inside and outside without a contact");
    TRY(array_grow(context, word, capacity, *length + 2, 1, what));
    (*word)[(*length)++] = (char)state;
    (*word)[*length] = '\0';
    return GRAZE_OK;
}

graze_status word_tell_contacts(graze_trace *trace, graze_context *context, size_t length) {
    size_t next = 0;
    const char *word = trace->word;
    trace->first = (graze_state)word[0];
    trace->last = (graze_state)word[length - 1];
    for (size_t k = 0; k < length; k++) {
        if (word[k] != 'B')
            continue;
        contact *c = &trace->contact[next++];
        c->left = k > 0 ? (graze_state)word[k - 1] : GRAZE_STATE_ABSENT;
        c->right = k + 1 < length ? (graze_state)word[k + 1] : GRAZE_STATE_ABSENT;
    }
    return next == trace->contact_count
               ? GRAZE_OK
               : context_fail(context, GRAZE_EINTERNAL, "a trace has lost a contact");
}

static graze_status put_state(tracer *r, size_t *length, size_t *capacity, graze_state state) {
    return word_append(&r->out->word, length, capacity, r->context, state, "the word of a trace");
}

graze_status word_read(tracer *r) {
    const graze_trace *out = r->out;
    size_t n = out->contact_count, length = 0, capacity = 0;
    int starts_on = n > 0 && time_is_start(out->contact[0].from);
    int ends_on = n > 0 && time_is_end(out->contact[n - 1].to);
    for (size_t k = 0; k <= n; k++) {
        graze_state state = GRAZE_STATE_ABSENT;
        if (!(k == 0 && starts_on) && !(k == n && ends_on)) {
            TRY(gap_state(&state, r, k));
            TRY(put_state(r, &length, &capacity, state));
        }
        if (k < n)
            TRY(put_state(r, &length, &capacity, GRAZE_STATE_B));
    }
    return word_tell_contacts(r->out, r->context, length);
}
