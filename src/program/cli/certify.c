/* graze certify: a certificate of the answers for points.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(certify);

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
