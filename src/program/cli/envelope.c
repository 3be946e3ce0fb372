/* graze envelope: events of the envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(envelope);

typedef struct envelope_given {
    scene_options scene;
    const char *events; /* files; NULL: none */
    const char *patches, *joints;
    const char *at, *curve; /* times with commas, and the file for their curves */
    unsigned long count;    /* number of contact points */
    seed_value seed;
    const char *points; /* file for the contact points */
} envelope_given;

/* Add the numbers of events by kind. */
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

static void text_cell(text *t, const graze_cell *cell) {
    if (cell->kind == GRAZE_CELL_EDGE)
        text_format(t, "edge %zu-%zu", cell->a, cell->b);
    else
        text_format(t, "%s %zu", cell->kind == GRAZE_CELL_FACE ? "face" : "vertex", cell->a);
}

/* Add the reason why the envelope is decomposable or not, with its cell and time. */
static graze_status put_decomposable_reason(text *t, graze_context *context,
                                            const graze_envelope_facts *f) {
    FREED(char, when, NULL);
    if (f->time)
        TRY(graze_time_decimal(&when, context, f->time, 17));
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
    return GRAZE_OK;
}

static int print_summary(graze_context *context, const graze_envelope *envelope) {
    graze_envelope_facts f = graze_envelope_get(envelope);
    HELD(text, t);
    text_format(&t, "cells: %zu facets, %zu edges, %zu vertices\n", f.facets, f.edges, f.vertices);
    put_event_counts(&t, envelope);
    text_format(&t, "decomposable: %s\n", graze_decomposable_name(f.decomposable));
    TRY(complain_of(put_decomposable_reason(&t, context, &f), context));
    return output_made(NULL, &t);
}

static output out;

/* Put what the library has made, the head of a table or a row, and free it. */
static int put_made(graze_status status, char **made, graze_context *context) {
    if (*made)
        output_put(&out, *made);
    graze_free(*made);
    *made = NULL;
    return complain_of(status, context);
}

static int put_last(size_t rows) {
    output_format(&out, "# complete %zu\n", rows);
    return EXIT_DONE;
}

static int put_events(graze_context *context, const graze_envelope *envelope) {
    char *text = NULL;
    size_t count = graze_envelope_event_count(envelope);
    TRY(put_made(graze_envelope_header(&text, context, envelope, NULL), &text, context));
    for (size_t k = 0; k < count && !out.error; k++)
        TRY(put_made(graze_envelope_row(&text, context, envelope, k), &text, context));
    return put_last(count);
}

/* Put the rows of one curve; *rows grows by their number. */
static int put_curve(size_t *rows, graze_context *context, const graze_envelope *envelope,
                     const mpq_t time) {
    char *text = NULL;
    OWNED(graze_curve, curve);
    graze_status status = graze_curve_create(&curve, context, envelope, time);
    if (status == GRAZE_EINPUT)
        return complain(EXIT_INPUT, "--at: %s", graze_context_message(context));
    TRY(complain_of(status, context));
    for (size_t k = 0; k < graze_curve_count(curve); k++, ++*rows)
        TRY(put_made(graze_curve_row(&text, context, curve, k), &text, context));
    return EXIT_DONE;
}

/* Put the curves at all times of a comma-separated list. */
static int put_curves(const char *times, graze_context *context, const graze_envelope *envelope) {
    char *text = NULL;
    size_t rows = 0;
    LOCAL(mpq, time);
    TRY(put_made(graze_curve_header(&text, context, envelope, NULL), &text, context));
    while (times && !out.error) {
        size_t length = strcspn(times, ",");
        TRY(numbers_read(&time, context, "--at", times, length, 1));
        TRY(put_curve(&rows, context, envelope, time));
        times = times[length] ? times + length + 1 : NULL;
    }
    return put_last(rows);
}

/* Put the table of patches or, if `joints`, the table of joints. */
static int put_patches(const graze_patches *patches, int joints, graze_context *context,
                       const graze_envelope *envelope) {
    char *text = NULL;
    size_t count = joints ? graze_patches_joint_count(patches) : graze_patches_count(patches);
    TRY(put_made(joints ? graze_patches_joint_header(&text, context, envelope, NULL)
                        : graze_patches_header(&text, context, envelope, NULL),
                 &text, context));
    for (size_t k = 0; k < count && !out.error; k++)
        TRY(put_made(joints ? graze_patches_joint_row(&text, context, patches, k)
                            : graze_patches_row(&text, context, patches, k),
                     &text, context));
    return put_last(count);
}

/* A time without contact gives no row; after this number of such times in succession the table
 * ends.
 */
enum { TRIES = 1000 };

static int put_contact_points(const envelope_given *o, const loaded *l,
                              const graze_envelope *envelope) {
    char *text = NULL;
    unsigned long seed = o->seed.given ? (unsigned long)o->seed.seed : 1, rows = 0, empty = 0;
    TRY(put_made(graze_site_header(&text, l->context, l->scene, load_note(&o->scene), NULL), &text,
                 l->context));
    for (unsigned long k = 0; rows < o->count && empty < TRIES && !out.error; k++) {
        OWNED(graze_site, site);
        TRY(complain_of(graze_envelope_site(&site, l->context, envelope, seed, k), l->context));
        empty = site ? 0 : empty + 1;
        rows += site != NULL;
        if (site)
            TRY(put_made(graze_site_row(&text, l->context, site, GRAZE_FORMAT_CSV, NULL), &text,
                         l->context));
    }
    return put_last(rows);
}

static int write_tables(const envelope_given *o, const loaded *l, const graze_envelope *envelope) {
    OWNED(graze_patches, patches);
    if (o->events) {
        TRY(output_open(&out, o->events));
        TRY(output_end(&out, put_events(l->context, envelope)));
    }
    if (o->curve) {
        TRY(output_open(&out, o->curve));
        TRY(output_end(&out, put_curves(o->at, l->context, envelope)));
    }
    if (o->patches || o->joints)
        TRY(complain_of(graze_patches_create(&patches, l->context, envelope), l->context));
    for (int joints = 0; joints < 2; joints++) {
        const char *path = joints ? o->joints : o->patches;
        if (!path)
            continue;
        TRY(output_open(&out, path));
        TRY(output_end(&out, put_patches(patches, joints, l->context, envelope)));
    }
    if (!o->points)
        return EXIT_DONE;
    TRY(output_open(&out, o->points));
    return output_end(&out, put_contact_points(o, l, envelope));
}

static const option_entry envelope_table[] = {
    FILE_WRITTEN("events", envelope_given, events),
    OPTION("at", envelope_given, at, value_text),
    FILE_WRITTEN("curve", envelope_given, curve),
    FILE_WRITTEN("patches", envelope_given, patches),
    FILE_WRITTEN("joints", envelope_given, joints),
    OPTION("n", envelope_given, count, value_count),
    OPTION("seed", envelope_given, seed, value_seed),
    FILE_WRITTEN("points", envelope_given, points),
    OPTION("operation", envelope_given, scene.scene.operation, value_operation),
    SCENE_OPTIONS(envelope_given, scene),
    OPTIONS_END};

static int run_envelope(void *options, const operands *given) {
    envelope_given *o = options;
    if (o->scene.scene.operation != GRAZE_SWEEP)
        return complain(EXIT_USAGE, "envelope has no --operation unsweep; expected a sweep");
    if (!o->at != !o->curve)
        return complain(EXIT_USAGE, "--at and --curve go together; expected both or neither");
    if (!o->count != !o->points)
        return complain(EXIT_USAGE, "-n and --points go together; expected both or neither");
    ZEROED(loaded, l);
    OWNED(graze_envelope, envelope);
    scene_files(&o->scene, given);
    TRY(loaded_read(&l, &o->scene, EXIT_INPUT, NULL));
    TRY(load_takes(l.solid, o->scene.solid, "envelope", TAKES_STRAIGHT));
    TRY(complain_of(graze_envelope_create(&envelope, l.context, l.scene), l.context));
    TRY(write_tables(o, &l, envelope));
    return print_summary(l.context, envelope);
}

COMMAND(envelope, envelope_given, .takes = "SOLID and MOTION", .least = 2, .reads = 2);
