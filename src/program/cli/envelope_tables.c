/* Finds the events of an envelope, writes and sums them up.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

/* Numbers of events by kind. */
static void put_event_counts(text *t, const graze_envelope *envelope) {
    size_t total = graze_envelope_event_count(envelope), count[GRAZE_EVENT_SINGULAR + 1] = {0};
    for (size_t k = 0; k < total; k++)
        count[graze_envelope_event(envelope, k).kind]++;
    text_format(t, "events: %zu", total);
    for (int kind = GRAZE_EVENT_SADDLE; kind <= GRAZE_EVENT_SINGULAR; kind++)
        text_format(t, "%s %s %zu", kind == GRAZE_EVENT_SADDLE ? " =" : " +",
                    graze_event_kind_name((graze_event_kind)kind), count[kind]);
    text_put(t, "\n");
}

/* The reason, and where and when it is found. */
static graze_status put_decomposable_reason(text *t, graze_context *context,
                                            const graze_envelope_facts *f) {
    char *when = NULL;
    graze_status status = f->time ? graze_time_decimal(&when, context, f->time, 17) : GRAZE_OK;
    text_format(t, "why: %s", graze_decomposable_reason_name(f->reason));
    if (f->facet.kind) {
        text_put(t, ", ");
        text_cell(t, &f->facet);
    }
    if (f->cell.kind) {
        text_put(t, f->facet.kind ? " at " : ", ");
        text_cell(t, &f->cell);
    }
    if (when)
        text_format(t, ", time %s", when);
    text_put(t, "\n");
    graze_free(when);
    return status;
}

static int print_summary(graze_context *context, const graze_envelope *envelope) {
    graze_envelope_facts f = graze_envelope_get(envelope);
    HELD(text, t);
    text_format(&t, "cells: %zu facets, %zu edges, %zu vertices\n", f.facets, f.edges, f.vertices);
    put_event_counts(&t, envelope);
    text_format(&t, "decomposable: %s\n", graze_decomposable_name(f.decomposable));
    int status = complain_of(put_decomposable_reason(&t, context, &f), context);
    if (!status)
        status = t.failed ? complain(EXIT_IO, "out of memory") : output_text(NULL, t.data);
    return status;
}

/* Options that go together. */
static int check_options(const envelope_options *o) {
    if (o->scene.scene.operation != GRAZE_SWEEP)
        return complain(EXIT_USAGE, "envelope has no --operation unsweep; expected a sweep");
    if (!o->at != !o->curve)
        return complain(EXIT_USAGE, "--at and --curve go together; expected both or neither");
    if (!o->count != !o->points)
        return complain(EXIT_USAGE, "-n and --points go together; expected both or neither");
    return EXIT_DONE;
}

static int write_tables(const envelope_options *o, const loaded *l,
                        const graze_envelope *envelope) {
    int status = EXIT_DONE;
    if (o->events)
        status = envelope_write_events(o->events, l->context, envelope);
    if (!status && o->curve)
        status = envelope_write_curves(o->curve, o->at, l->context, envelope);
    if (!status && (o->patches || o->joints))
        status = envelope_write_patches(o->patches, o->joints, l->context, envelope);
    if (!status && o->points)
        status = envelope_write_contacts(o->points, o->count, (unsigned long)o->seed,
                                         load_note(&o->scene), l, envelope);
    return status;
}

int envelope_run(const envelope_options *o) {
    loaded l;
    graze_envelope *envelope = NULL;
    int status = check_options(o);
    if (status)
        return status;
    status = loaded_read(&l, &o->scene, EXIT_INPUT, NULL);
    if (!status)
        status = load_takes(l.solid, o->scene.solid, "envelope", TAKES_STRAIGHT);
    if (!status)
        status = complain_of(graze_envelope_create(&envelope, l.context, l.scene), l.context);
    if (!status)
        status = write_tables(o, &l, envelope);
    if (!status)
        status = print_summary(l.context, envelope);
    graze_envelope_destroy(envelope);
    loaded_clear(&l);
    return status;
}
