/* The public functions of envelopes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/api.h"

#include "output/report/report.h"
#include "questions/envelope/envelope.h"

graze_status graze_envelope_create(graze_envelope **out, graze_context *context,
                                   const graze_scene *scene) {
    PUBLIC_OUT(out, context, scene);
    REFUSED(scene->options.operation != GRAZE_SWEEP, "the scene is an unsweep; expected a sweep");
    TRY(api_takes(context, "graze_envelope_create", scene->solid));
    CREATE(out, made, free, envelope_make(made, context, scene));
}

DESTROYER(graze_envelope, envelope_clear(of))

graze_envelope_facts graze_envelope_get(const graze_envelope *envelope) {
    graze_envelope_facts out = {0};
    if (!envelope)
        return out;
    out.facets = envelope->cells.facet_count;
    out.edges = envelope->cells.dimension == 3 ? envelope->cells.edge_count : 0;
    out.vertices = envelope->cells.vertex_count;
    out.reason = envelope->found.reason;
    out.decomposable = out.reason == GRAZE_REASON_POSITIVE ? GRAZE_DECOMPOSABLE_YES
                       : out.reason >= GRAZE_REASON_PIECES ? GRAZE_DECOMPOSABLE_UNDECIDED
                                                           : GRAZE_DECOMPOSABLE_NO;
    out.facet = envelope->found.facet;
    out.cell = envelope->found.cell;
    out.time = envelope->found.time;
    return out;
}

FACT(size_t, graze_envelope_event_count, graze_envelope, of->events.count, 0)

graze_event graze_envelope_event(const graze_envelope *envelope, size_t index) {
    graze_event out = {0};
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
    PUBLIC_OUT(out, context, envelope);
    return report_table_head(out, context, envelope->scene, TABLE_EVENTS, notes, NULL);
}

graze_status graze_envelope_row(char **out, graze_context *context, const graze_envelope *envelope,
                                size_t index) {
    PUBLIC_OUT(out, context, envelope);
    REFUSED(index >= envelope->events.count, "there is no such event");
    const found_event *event = &envelope->events.item[index];
    HELD(text, t);
    TRY(time_canonicalise(envelope->events.time[event->time], context));
    report_event(&t, envelope, event);
    return text_finish(out, context, &t);
}
