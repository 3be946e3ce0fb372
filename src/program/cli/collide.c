/* graze collide: a moving solid against a fixed one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "program/cli/cli.h"

#include <string.h>
#include "base/context/scope.h"
#include "program/cli/values.h"
#include "program/io/io.h"

static const char collide_help[] =
    "graze collide MOVING MOTION FIXED: does a moving solid meet a fixed one, when, with what\n"
    "\n"
    "Example: graze solid box --size 2,2,2 --at 9,0,0 -o post.off\n"
    "         graze collide cube.off move.json post.off\n"
    "         graze collide cube.off move.json post.off --first --format json\n"
    "\n"
    "Prints `clear`, `touch` or `overlap`, and the pair word: a letter for each state in order of\n"
    "time, O apart, B only the boundaries meet, I the interiors meet. Then each contact, a time "
    "or\n"
    "an interval of B, exactly, with all pairs of cells that meet when it begins.\n"
    "Exit status: 0 clear, 1 touch, overlap or, with --first, meets.\n"
    "\n"
    "Both are polyhedra or polygons, or balls and capsules of a .csg.json or .csg and unions of "
    "them.\n"
    "\n"
    "  --first              stop just after the first contact begins, which is much cheaper:\n"
    "                       `clear`, `overlap` from the start or `meets`; the word: OBI, OBO,\n"
    "                       or OB where the contact lasts or the motion ends\n"
    "  --clearance R        letters tell the distance: O above R, B at R, I below R; cells are "
    "those\n"
    "                       with points at distance R. Both keep R >= 0 apart (default 0: as "
    "above)\n"
    "  --closest TOL        also the least distance, between two numbers at most TOL apart (1e-10, "
    "or\n"
    "                       1e-10r of both sizes; else `wide`), with a time and a point of each\n"
    "  --ask any|overlap    what exit status 1 tells: touch or overlap (default), overlap alone\n"
    "  --inside             does MOVING stay inside FIXED? `inside`, `inside, touching`, or when "
    "it\n"
    "                       leaves; the word is that with the closed complement of FIXED. With\n"
    "                       --first also `touches at` a time, and what follows\n"
    "  --motion-of-fixed MOTION   FIXED moves too; times are those that both motions have\n"
    "  --list PAIRS.csv     a table of pairs instead: columns moving,motion,fixed, relative to "
    "it;\n"
    "                       id,clearance,motion_of_fixed,inside if wanted; others are kept\n"
    "  --jobs, --resume, --shard, --quiet   with --list, as in graze classify\n"
    "  --format text|json   json: one object, with all pairs of cells and exact times; with "
    "--list\n"
    "                       csv|jsonl\n"
    "  -o, --output FILE    write there instead of to standard output\n"
    "  --triangulate, --round, --limit NAME=V   as in graze classify\n";

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
    if (o->pairs.options.closest > 0 &&
        (o->pairs.options.first || o->pairs.overlap_alone || o->pairs.options.question))
        return complain(EXIT_USAGE, "--closest looks at the whole motion of one solid outside the "
                                    "other; expected no --first, --ask overlap or --inside");
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
    pair_question q = {{file[0], file[1], file[2], asked->motion_of_fixed},
                       o->scene.solid_flags,
                       asked->options,
                       {clearance, strlen(clearance)}};
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
    return pair_meets(o, pair) ? EXIT_NO : EXIT_DONE;
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
