/* graze certify: a certificate of the answers for points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"
#include "program/points/points.h"
#include "program/run/run.h"

static const char certify_help[] =
    "graze certify SOLID MOTION POINTS -o FILE: answers that graze-check can verify\n"
    "\n"
    "Example: graze convert move.json -o pieces.json\n"
    "         graze certify cube.off pieces.json points.csv -o certificate.txt\n"
    "         graze-check cube.off pieces.json certificate.txt\n"
    "\n"
    "Writes a certificate: each point's answer, and hints by which graze-check, a program that\n"
    "shares nothing with graze, proves it from SOLID (.off, .wkt) and MOTION (plain pieces)\n"
    "alone. graze convert writes any solid and motion so; those in another form are converted to\n"
    "FILE.off and FILE.json beside the certificate FILE, which is of them. POINTS as in graze\n"
    "classify, which can write table and certificate in one run.\n"
    "\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --times              each contact's time and boundary cells too\n"
    "  --operation sweep|unsweep, --folds separate|combined, --overlap extend|reject,\n"
    "  --jobs N, --receipt FILE, --quiet, --limit NAME=V   as in graze classify\n"
    "  --resume FILE        continue the certificate in FILE, if there is one, after its last row\n"
    "  --shard i/n          rows i, i + n, i + 2n, ... only; graze merge makes one of them\n";

static const option_entry certify_table[] = {
    OPTION("operation", classify_options, scene.scene.operation, value_operation),
    OPTION("folds", classify_options, scene.scene.folds, value_folds),
    OPTION("overlap", classify_options, scene.scene.overlap, value_overlap),
    OPTION("limit", classify_options, scene.context.limits, value_limit),
    OPTION("jobs", classify_options, threads, value_jobs),
    OUTPUT(classify_options, output, value_output),
    FILE_WRITTEN("resume", classify_options, resume),
    OPTION("shard", classify_options, shard, value_shard),
    FILE_READ("receipt", classify_options, receipt),
    FLAG("times", classify_options, times, value_flag),
    FLAG("quiet", classify_options, quiet, value_quiet),
    OPTIONS_END};

static int run_certify(void *options, const operands *given) {
    classify_options *o = options;
    TRY(classify_check_files(o));
    scene_files(&o->scene, given);
    o->points = given->item[2];
    return classify_run(o);
}

static const classify_options certificate_alone = {.no_table = 1, .shard.part = {0, 1}};

COMMAND(certify, classify_options, .initial = &certificate_alone,
        .takes = "SOLID, MOTION and POINTS", .least = 3, .reads = 3, .inputs = 1,
        .add_files = classify_add_record);
