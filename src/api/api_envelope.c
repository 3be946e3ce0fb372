/* The public functions of envelopes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include <stdlib.h>
#include <string.h>
#include "base/context/scope.h"
#include "decide/scene/scene.h"
#include "decide/trace/trace.h"
#include "output/report/report.h"
#include "questions/envelope/envelope.h"

graze_status graze_envelope_create(graze_envelope **out, graze_context *context,
                                   const graze_scene *scene) {
    if (out)
        *out = NULL;
    if (!out || !context || !scene)
        return api_misuse(context, "graze_envelope_create",
                          "out, context and scene must not be NULL");
    if (scene->options.operation != GRAZE_SWEEP)
        return api_misuse(context, "graze_envelope_create",
                          "the scene is an unsweep; expected a sweep");
    if (scene->solid->curved)
        return api_curved(context, "graze_envelope_create");
    IN_ENVIRONMENT();
    graze_envelope *made = malloc(sizeof *made);
    if (!made)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    graze_status status = envelope_make(made, context, scene);
    if (status)
        free(made);
    else
        *out = made;
    return status;
}

void graze_envelope_destroy(graze_envelope *envelope) {
    if (!envelope)
        return;
    envelope_clear(envelope);
    free(envelope);
}

static graze_decomposable answer_of(graze_decomposable_reason reason) {
    return reason == GRAZE_REASON_POSITIVE ? GRAZE_DECOMPOSABLE_YES
           : reason >= GRAZE_REASON_PIECES ? GRAZE_DECOMPOSABLE_UNDECIDED
                                           : GRAZE_DECOMPOSABLE_NO;
}

graze_envelope_facts graze_envelope_get(const graze_envelope *envelope) {
    graze_envelope_facts out;
    memset(&out, 0, sizeof out);
    if (!envelope)
        return out;
    out.facets = envelope->cells.facet_count;
    out.edges = envelope->cells.dimension == 3 ? envelope->cells.edge_count : 0;
    out.vertices = envelope->cells.vertex_count;
    out.reason = envelope->found.reason;
    out.decomposable = answer_of(out.reason);
    out.facet = envelope->found.facet;
    out.cell = envelope->found.cell;
    out.time = envelope->found.time;
    return out;
}

size_t graze_envelope_event_count(const graze_envelope *envelope) {
    return envelope ? envelope->events.count : 0;
}

graze_event graze_envelope_event(const graze_envelope *envelope, size_t index) {
    graze_event out;
    memset(&out, 0, sizeof out);
    if (index >= graze_envelope_event_count(envelope))
        return out;
    const found_event *event = &envelope->events.item[index];
    out.kind = event->kind;
    out.time = envelope->events.time[event->time];
    out.facet = event->facet;
    out.other = event->other;
    out.cell = event->cell;
    out.before = event->before;
    out.after = event->after;
    return out;
}

graze_status graze_envelope_header(char **out, graze_context *context,
                                   const graze_envelope *envelope, const char *notes) {
    if (out)
        *out = NULL;
    if (!out || !context || !envelope)
        return api_misuse(context, "graze_envelope_header",
                          "out, context and envelope must not be NULL");
    IN_ENVIRONMENT();
    return report_events_header(out, context, envelope->scene, notes);
}

graze_status graze_envelope_row(char **out, graze_context *context, const graze_envelope *envelope,
                                size_t index) {
    if (out)
        *out = NULL;
    if (!out || !context || !envelope)
        return api_misuse(context, "graze_envelope_row",
                          "out, context and envelope must not be NULL");
    if (index >= envelope->events.count)
        return api_misuse(context, "graze_envelope_row", "there is no such event");
    IN_ENVIRONMENT();
    const found_event *event = &envelope->events.item[index];
    text t;
    text_init(&t);
    graze_status status = time_canonicalise(envelope->events.time[event->time], context);
    if (status) {
        text_clear(&t);
        return status;
    }
    report_event(&t, envelope, event);
    return text_finish(out, context, &t);
}
