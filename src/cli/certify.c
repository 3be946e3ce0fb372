/* graze certify: a certificate of the answers for points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/commands.h"
#include "cli/values.h"
#include "run/csv.h"
#include "run/interrupt.h"
#include "run/load.h"
#include "run/output.h"

static const char certify_help[] =
    "graze certify SOLID MOTION POINTS -o FILE: answers that graze-check can verify\n"
    "\n"
    "Writes a certificate: each point's answer, and hints by which graze-check, a program that\n"
    "shares nothing with graze, proves it from SOLID (.off, .wkt) and MOTION (plain pieces) "
    "alone.\n"
    "graze convert writes any solid and motion so. POINTS as in graze classify.\n"
    "\n"
    "  --operation sweep|unsweep, --folds separate|combined, --overlap extend|reject,\n"
    "  --limit NAME=V       as in graze classify\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "\n"
    "Example: graze certify cube.off move.json points.csv -o certificate.txt\n"
    "         graze-check cube.off move.json certificate.txt table.csv\n";

typedef struct certify_options {
    scene_options scene;
    const char *points, *output;
} certify_options;

typedef struct certify_run {
    loaded l;
    graze_certifier *certifier;
    csv *points;
    block *b;
    reader reader;
    mpq_t point[3];
    unsigned long rows;
    output out;
} certify_run;

static int has_ending(const char *path, const char *ending) {
    size_t n = strlen(path), m = strlen(ending);
    return n > m && strcmp(path + n - m, ending) == 0;
}

static int prepare_certificate(certify_run *s, const certify_options *o) {
    const char *path = o->scene.solid;
    if (!has_ending(path, ".off") && !has_ending(path, ".wkt"))
        return complain(EXIT_INPUT, "%s: graze-check does not read it; expected .off or .wkt",
                        path);
    int status = loaded_read(&s->l, &o->scene, EXIT_INPUT, NULL);
    if (status)
        return status;
    graze_status made = graze_certifier_create(&s->certifier, s->l.context, s->l.scene, 0);
    if (made)
        return complain_of(made, s->l.context);
    status = csv_open(&s->points, o->points, graze_scene_dimension(s->l.scene), (shard){0, 1},
                      s->l.context);
    s->b = block_create();
    if (!status && !s->b)
        status = complain(EXIT_IO, "out of memory");
    if (!status && o->output && csv_same_file(s->points, o->output))
        status =
            complain(EXIT_USAGE, "--output %s: is the file the points are read from", o->output);
    s->reader.context = s->l.context;
    return status ? status : output_open(&s->out, o->output);
}

static int put_certified(certify_run *s, graze_status made, char *text) {
    if (!made)
        output_put(&s->out, text);
    graze_free(text);
    return complain_of(made, s->l.context);
}

static int put_certified_block(certify_run *s) {
    int status = EXIT_DONE;
    for (size_t k = 0; k < s->b->count && !status; k++) {
        fault f = {0, NULL};
        char *text = NULL;
        s->reader.rest_length = 0;
        if (columns_row(s->point, &f, csv_columns(s->points), &s->reader, s->b, k)) {
            status = fault_tell(&f);
        } else {
            graze_status made = graze_certificate_row(&text, s->l.context, s->certifier, s->point);
            status = put_certified(s, made, text);
        }
        fault_clear(&f);
        s->rows += !status;
        if (!status && s->out.error)
            status = EXIT_IO;
        if (!status && interrupt_signal())
            status = EXIT_SIGNAL;
    }
    return status;
}

static int put_certificate(certify_run *s) {
    char *head = NULL, end[40];
    graze_status made = graze_certificate_head(&head, s->l.context, s->certifier);
    int status = put_certified(s, made, head);
    while (!status) {
        block_reset(s->b, s->rows);
        int read = csv_fill(s->points, s->b, BLOCK_ROWS);
        if (s->b->count == 0 && !read)
            break;
        status = put_certified_block(s);
        if (!status && read)
            status = read == EXIT_SIGNAL ? EXIT_SIGNAL : fault_tell(csv_fault(s->points));
    }
    snprintf(end, sizeof end, "complete %lu\n", s->rows);
    if (!status)
        output_put(&s->out, end);
    return status;
}

static int certify(const certify_options *o) {
    certify_run *s = calloc(1, sizeof *s);
    if (!s)
        return complain(EXIT_IO, "out of memory");
    for (int k = 0; k < 3; k++)
        mpq_init(s->point[k]);
    int status = prepare_certificate(s, o);
    if (!status) {
        status = put_certificate(s);
        int closed = output_close(&s->out);
        status = status ? status : closed;
    }
    for (int k = 0; k < 3; k++)
        mpq_clear(s->point[k]);
    reader_clear(&s->reader);
    block_destroy(s->b);
    csv_close(s->points);
    graze_certifier_destroy(s->certifier);
    loaded_clear(&s->l);
    free(s);
    return status;
}

static const option_entry certify_table[] = {
    OPTION("operation", certify_options, scene.scene.operation, value_operation),
    OPTION("folds", certify_options, scene.scene.folds, value_folds),
    OPTION("overlap", certify_options, scene.scene.overlap, value_overlap),
    OPTION("limit", certify_options, scene.context.limits, value_limit),
    OPTION("output", certify_options, output, value_text),
    OPTION("o", certify_options, output, value_text),
    {NULL, OPTION_FLAG, NULL, 0}};

static int run_certify(void *options, const operands *given) {
    certify_options *o = options;
    if (given->count != 3)
        return complain(EXIT_USAGE,
                        "certify takes SOLID, MOTION and POINTS, %d operands given; see graze "
                        "certify --help",
                        given->count);
    o->scene.solid = given->item[0];
    o->scene.motion = given->item[1];
    o->points = given->item[2];
    return certify(o);
}

const command command_certify = {.name = "certify",
                                 .options = certify_table,
                                 .size = sizeof(certify_options),
                                 .help = certify_help,
                                 .run = run_certify};
