/* graze collide: a moving solid against a fixed one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/values.h"

#include "base/context/scope.h"

HELP(collide);

enum { FORMAT_TEXT, FORMAT_JSON, FORMAT_CSV, FORMAT_JSONL, FORMAT_UNSET };

static option_read value_ask, value_collide_format;
VALUE_OF_WORDS(value_ask, int, "any", "overlap")
VALUE_OF_WORDS(value_collide_format, int, "text", "json", "csv", "jsonl")

static const option_entry collide_table[] = {
    FLAG("first", classify_options, pairs.options.first, value_flag),
    OPTION("ask", classify_options, pairs.overlap_alone, value_ask),
    FLAG("inside", classify_options, pairs.options.question, value_flag),
    OPTION("closest", classify_options, pairs.options, value_closest),
    OPTION("clearance", classify_options, pairs.clearance, value_width),
    OPTION("motion-error", classify_options, pairs.motion_error, value_width),
    FILE_READ("motion-of-fixed", classify_options, pairs.motion_of_fixed),
    FILE_READ("list", classify_options, points),
    OPTION("format", classify_options, pairs.format, value_collide_format),
    OPTION("jobs", classify_options, threads, value_jobs),
    OUTPUT(classify_options, output, value_output),
    FILE_WRITTEN("resume", classify_options, resume),
    OPTION("shard", classify_options, shard, value_shard),
    FLAG("quiet", classify_options, quiet, value_quiet),
    SOLID_OPTIONS(classify_options, scene.solid_flags, scene.context),
    OPTIONS_END};

/* Check that the options of a list, or of a pair, go together. */
static int check_list(const classify_options *o, int operands) {
    int is_table = o->pairs.format == FORMAT_CSV || o->pairs.format == FORMAT_JSONL;
    if (o->pairs.options.first && o->pairs.overlap_alone)
        return complain(EXIT_USAGE, "--first ends before an overlap is known; expected --first or "
                                    "--ask overlap");
    int alone = (o->pairs.options.closest > 0) + (o->pairs.motion_error != NULL);
    if (alone > 1 ||
        (alone && (o->pairs.options.first || o->pairs.overlap_alone || o->pairs.options.question)))
        return complain(EXIT_USAGE, "--closest, --motion-error: expected one of them, and no "
                                    "--first, --ask overlap or --inside");
    if (o->points && o->pairs.options.closest > 0)
        return complain(EXIT_USAGE, "--closest is asked of one pair; expected no --list");
    if (o->points && operands)
        return complain(EXIT_USAGE, "--list names the pairs; expected no operands beside it");
    if (o->points && !is_table && o->pairs.format != FORMAT_UNSET)
        return complain(EXIT_USAGE, "--list makes a table; expected --format csv or jsonl");
    if (!o->points && operands != 3)
        return complain(EXIT_USAGE,
                        "collide takes MOVING, MOTION and FIXED, %d operands given; see graze "
                        "collide --help",
                        operands);
    if (!o->points && (is_table || o->threads || o->resume || o->shard.given))
        return complain(EXIT_USAGE, "%s with --list alone",
                        is_table ? "--format csv: expected text or json; csv and jsonl go"
                                 : "--jobs, --resume and --shard go");
    TRY(classify_check_files(o));
    return classify_check_table(o);
}

static void add_list_files(guard *g, const void *options, const operands *given) {
    if (((const classify_options *)options)->points)
        classify_add_record(g, options, given);
}

static int print_pair(const classify_options *o, char *const file[3]) {
    const struct pair_choice *asked = &o->pairs;
    const char *clearance = asked->clearance ? asked->clearance : "";
    const char *error = asked->motion_error ? asked->motion_error : "";
    ZEROED(pair_question, q);
    q = (pair_question){{file[0], file[1], file[2], asked->motion_of_fixed},
                        o->scene.solid_flags,
                        asked->options,
                        {clearance, strlen(clearance)},
                        {error, strlen(error)},
                        {NULL}};
    OWNED(graze_context, context);
    OWNED(graze_pair, pair);
    ZEROED(fault, f);
    FREED(char, written, NULL);
    TRY(context_make(&context, &o->scene.context));
    if (pair_decide(&pair, &f, context, &q))
        return fault_tell(&f);
    TRY(complain_of(asked->format == FORMAT_JSON ? graze_pair_json(&written, context, pair)
                                                 : graze_pair_text(&written, context, pair),
                    context));
    TRY(output_text(o->output, written));
    int asks = asked->options.closest == 0 || asked->clearance; /* for more than a distance */
    return asks && pair_meets(o, pair) ? EXIT_NO : EXIT_DONE;
}

static int run_collide(void *options, const operands *given) {
    classify_options *o = options;
    o->pairs.wanted = 1;
    o->scene.rows.format = o->pairs.format == FORMAT_JSONL ? GRAZE_FORMAT_JSONL : GRAZE_FORMAT_CSV;
    TRY(check_list(o, given->count));
    if (o->points)
        return classify_run(o);
    waiting_start(); /* a list shows its rows instead */
    int status = print_pair(o, given->item);
    pairs_end();
    return status;
}

static const classify_options whole_run = {.shard.part = {0, 1}, .pairs.format = FORMAT_UNSET};

COMMAND(collide, classify_options, .initial = &whole_run, .reads = 3, .add_files = add_list_files);
