/* Tables of an envelope. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

static int put_events(output *out, graze_context *context, const graze_envelope *envelope) {
    char *text = NULL, last[48];
    graze_status status = graze_envelope_header(&text, context, envelope, NULL);
    size_t count = graze_envelope_event_count(envelope);
    for (size_t k = 0; !status && !out->error; k++) {
        output_put(out, text);
        graze_free(text);
        text = NULL;
        if (k == count)
            break;
        status = graze_envelope_row(&text, context, envelope, k);
    }
    graze_free(text);
    snprintf(last, sizeof last, "# complete %zu\n", count);
    if (!status)
        output_put(out, last);
    return complain_of(status, context);
}

int envelope_write_events(const char *path, graze_context *context,
                          const graze_envelope *envelope) {
    output out;
    int status = output_open(&out, path);
    if (status)
        return status;
    status = put_events(&out, context, envelope);
    int closed = output_close(&out);
    return status ? status : closed;
}

/* The rows of one curve; *rows grows by their number. */
static int put_curve(output *out, size_t *rows, graze_context *context,
                     const graze_envelope *envelope, const mpq_t time) {
    graze_curve *curve = NULL;
    graze_status status = graze_curve_create(&curve, context, envelope, time);
    if (status == GRAZE_EINPUT)
        return complain(EXIT_INPUT, "--at: %s", graze_context_message(context));
    for (size_t k = 0; !status && k < graze_curve_count(curve); k++) {
        char *row = NULL;
        status = graze_curve_row(&row, context, curve, k);
        if (!status)
            output_put(out, row);
        graze_free(row);
        *rows += !status;
    }
    graze_curve_destroy(curve);
    return complain_of(status, context);
}

/* All curves of a list of times between commas. */
static int put_curves(output *out, const char *times, graze_context *context,
                      const graze_envelope *envelope) {
    char *text = NULL, last[48];
    size_t rows = 0;
    int status = complain_of(graze_curve_header(&text, context, envelope, NULL), context);
    if (!status)
        output_put(out, text);
    graze_free(text);
    LOCAL(mpq, time);
    while (!status && times && !out->error) {
        const char *end = strchr(times, ',');
        size_t length = end ? (size_t)(end - times) : strlen(times);
        graze_status read = graze_number_parse(time, context, times, length);
        status =
            read ? complain(exit_for(read, EXIT_USAGE), "--at: %s", graze_context_message(context))
                 : put_curve(out, &rows, context, envelope, time);
        times = end ? end + 1 : NULL;
    }
    snprintf(last, sizeof last, "# complete %zu\n", rows);
    if (!status)
        output_put(out, last);
    return status;
}

int envelope_write_curves(const char *path, const char *times, graze_context *context,
                          const graze_envelope *envelope) {
    output out;
    int status = output_open(&out, path);
    if (status)
        return status;
    status = put_curves(&out, times, context, envelope);
    int closed = output_close(&out);
    return status ? status : closed;
}

/* A row of a table of patches, by number. */
typedef graze_status patch_row(char **out, graze_context *context, const graze_patches *patches,
                               size_t index);

/* A table of `count` rows behind its head, which is freed. */
static int write_patch_table(const char *path, char *head, size_t count, patch_row *row,
                             graze_context *context, const graze_patches *patches) {
    output out;
    char last[48];
    graze_status found = GRAZE_OK;
    int status = output_open(&out, path);
    if (!status)
        output_put(&out, head);
    graze_free(head);
    if (status)
        return status;
    for (size_t k = 0; k < count && !found && !out.error; k++) {
        char *text = NULL;
        found = row(&text, context, patches, k);
        if (!found)
            output_put(&out, text);
        graze_free(text);
    }
    snprintf(last, sizeof last, "# complete %zu\n", count);
    if (!found)
        output_put(&out, last);
    status = complain_of(found, context);
    int closed = output_close(&out);
    return status ? status : closed;
}

int envelope_write_patches(const char *patches, const char *joints, graze_context *context,
                           const graze_envelope *envelope) {
    graze_patches *found = NULL;
    char *head = NULL;
    int status = complain_of(graze_patches_create(&found, context, envelope), context);
    if (!status && patches) {
        status = complain_of(graze_patches_header(&head, context, envelope, NULL), context);
        if (!status)
            status = write_patch_table(patches, head, graze_patches_count(found), graze_patches_row,
                                       context, found);
    }
    if (!status && joints) {
        status = complain_of(graze_patches_joint_header(&head, context, envelope, NULL), context);
        if (!status)
            status = write_patch_table(joints, head, graze_patches_joint_count(found),
                                       graze_patches_joint_row, context, found);
    }
    graze_patches_destroy(found);
    return status;
}

/* Times without contact give no row; after this number of them there may be none at all. */
enum { TRIES = 1000 };

static int put_contact_points(output *out, unsigned long count, unsigned long seed,
                              const char *notes, const loaded *l, const graze_envelope *envelope) {
    char *text = NULL, last[48];
    graze_context *context = l->context;
    graze_status status = graze_site_header(&text, context, l->scene, notes, NULL);
    unsigned long rows = 0, empty = 0;
    if (!status)
        output_put(out, text);
    graze_free(text);
    for (unsigned long k = 0; !status && rows < count && empty < TRIES && !out->error; k++) {
        graze_site *site = NULL;
        char *row = NULL;
        status = graze_envelope_site(&site, context, envelope, seed, k);
        empty = site ? 0 : empty + 1;
        if (!status && site)
            status = graze_site_row(&row, context, site, GRAZE_FORMAT_CSV, NULL);
        if (row)
            output_put(out, row);
        rows += row != NULL;
        graze_free(row);
        graze_site_destroy(site);
    }
    snprintf(last, sizeof last, "# complete %lu\n", rows);
    if (!status)
        output_put(out, last);
    return complain_of(status, context);
}

int envelope_write_contacts(const char *path, unsigned long count, unsigned long seed,
                            const char *notes, const loaded *l, const graze_envelope *envelope) {
    output out;
    int status = output_open(&out, path);
    if (status)
        return status;
    status = put_contact_points(&out, count, seed, notes, l, envelope);
    int closed = output_close(&out);
    return status ? status : closed;
}
