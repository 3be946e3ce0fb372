/* graze contact: contact points of the envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(contact);

static const option_entry contact_table[] = {
    FLAG("snap", classify_options, sites.snap, value_flag),
    OPTION("format", classify_options, scene.rows.format, value_rows),
    OPTION("jobs", classify_options, threads, value_jobs),
    OUTPUT(classify_options, output, value_output),
    FILE_WRITTEN("resume", classify_options, resume),
    OPTION("shard", classify_options, shard, value_shard),
    SCENE_OPTIONS(classify_options, scene),
    FLAG("no-filter", classify_options, scene.context.exact_only, value_flag),
    FLAG("quiet", classify_options, quiet, value_quiet),
    OPTIONS_END};

static int run_contact(void *options, const operands *given) {
    classify_options *o = options;
    TRY(classify_check_files(o));
    TRY(classify_check_table(o));
    scene_files(&o->scene, given);
    o->points = given->item[2];
    return classify_run(o);
}

static const classify_options whole_run = {.shard.part = {0, 1}, .sites.wanted = 1};

COMMAND(contact, classify_options, .initial = &whole_run, .takes = "SOLID, MOTION and CONTACTS",
        .least = 3, .reads = 3, .inputs = 1, .add_files = classify_add_record);
