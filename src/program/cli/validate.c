/* graze validate: makes points, classifies them, runs a candidate on them and reports.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The steps are the commands generate, classify and compare, joined by files in one folder.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/number/text.h"
#include "program/cli/commands.h"
#include "program/cli/compare.h"
#include "program/cli/values.h"
#include "program/run/candidate.h"
#include "program/run/generate.h"
#include "program/run/memory.h"
#include "program/run/numbers.h"
#include "program/run/output.h"

static const char validate_help[] =
    "graze validate SOLID MOTION --candidate 'CMD {solid} {motion} {points} {out}'\n"
    "\n"
    "Makes points (graze generate), classifies them, runs CMD on them, compares the table it "
    "wrote\n"
    "to {out} (see graze compare --help) and reports: figures, time and a verdict.\n"
    "Exit status 0: no difference; 1: differences; 3: the candidate failed or wrote no table.\n"
    "\n"
    "CMD is cut into words at blanks, without a shell: '...', \"...\" and \\ quote as in sh,\n"
    "nothing is expanded. Each placeholder is a word of its own. Its standard output goes to\n"
    "standard error. For a pipeline: sh -c 'mine <\"$1\" >\"$2\"' sh {points} {out}\n"
    "\n"
    "  -n N, --seed K       how many points (10000), and their seed (1)\n"
    "  --strata, --representable   as in graze generate; with --candidate-has sdf also points\n"
    "                       of the stratum level, unless strata are named\n"
    "  --points FILE        these points instead\n"
    "  --timeout V          seconds the candidate may take (3600)\n"
    "  --keep DIR           leave points.csv, golden.csv, candidate.csv there\n"
    "  --output NAME        write NAME.md and NAME.json instead of to standard output\n"
    "  --question, --on-as, --candidate-has, --truth, --sdf-tolerance, --motion-error, --round,\n"
    "  --show, --format     as in graze compare\n"
    "  --sdf TOL            width of the enclosures that values are compared with (1e-10r)\n"
    "  --overlap, --folds, --operation, --triangulate, --jobs, --limit,\n"
    "  --quiet   as in graze classify\n"
    "\n"
    "Example: graze validate cube.off move.json --representable binary64 \\\n"
    "             --candidate './mine {solid} {motion} {points} {out}'\n";

/* The weight of the stratum `level` among the default ones, where values are compared. */
enum { LEVEL_WEIGHT = 30 };

enum { POINTS, GOLDEN, ANSWERS, FILE_COUNT };

static const char *const file_names[FILE_COUNT] = {"/points.csv", "/golden.csv", "/candidate.csv"};

typedef struct validate_options {
    const char *candidate;
    const char *points; /* NULL: points are generated */
    const char *keep;   /* NULL: a folder that goes when all is done */
    const char *output;
    unsigned long timeout; /* seconds; 0: an hour */
    seed_value seed;
    generate_options generate;
    classify_options classify;
    graze_compare_options compare;
    graze_comparison_format format;
} validate_options;

typedef struct validation {
    char *folder;
    int temporary;           /* the folder goes when all is done */
    char *files[FILE_COUNT]; /* in the folder */
    char **words;
    double seconds;
    lost_strata lost; /* of the points that were made */
    graze_context *context;
    graze_comparison *comparison;
} validation;

static char *joined_texts(const char *a, const char *b) {
    char *text = malloc(strlen(a) + strlen(b) + 1);
    return text ? strcat(strcpy(text, a), b) : NULL;
}

/* The folder for the files: the one to keep, or a fresh one. */
static int make_work_folder(validation *v, const validate_options *o) {
    const char *base = getenv("TMPDIR");
    v->folder =
        o->keep ? strdup(o->keep) : joined_texts(base && *base ? base : "/tmp", "/graze-XXXXXX");
    if (!v->folder)
        return complain(EXIT_IO, "out of memory");
    v->temporary = !o->keep && mkdtemp(v->folder) != NULL;
    int failed = o->keep ? mkdir(o->keep, 0777) != 0 && errno != EEXIST : !v->temporary;
    if (failed)
        return complain(EXIT_IO, "%s: cannot be made: %s", v->folder, strerror(errno));
    for (int k = 0; k < FILE_COUNT; k++)
        if (!(v->files[k] = joined_texts(v->folder, file_names[k])))
            return complain(EXIT_IO, "out of memory");
    return EXIT_DONE;
}

static void remove_work_folder(validation *v) {
    for (int k = 0; v->temporary && k < FILE_COUNT; k++)
        if (v->files[k])
            unlink(v->files[k]);
    if (v->temporary && rmdir(v->folder) != 0)
        candidate_remove(v->folder);
}

/* The validation whose folder goes before a sudden end. */
static validation *at_work;

static void remove_folder_at_work(void) {
    remove_work_folder(at_work);
}

static const char *points_of(const validation *v, const validate_options *o) {
    return o->points ? o->points : v->files[POINTS];
}

/* Points and golden table, as graze generate and graze classify make them. */
static int make_golden(validation *v, const validate_options *o) {
    generate_options points = o->generate;
    classify_options golden = o->classify;
    points.scene = golden.scene;
    points.count = points.count ? points.count : 10000;
    points.seed = o->seed.given ? o->seed.seed : 1;
    points.output = v->files[POINTS];
    points.quiet = golden.quiet;
    points.level = o->compare.has == GRAZE_HAS_SDF ? LEVEL_WEIGHT : 0;
    golden.points = points_of(v, o);
    golden.output = v->files[GOLDEN];
    golden.transient = 1;
    int status = o->points ? EXIT_DONE : generate_run(&v->lost, &points);
    return status ? status : classify_run(&golden);
}

static int compare_answers(validation *v, const validate_options *o) {
    graze_compare_options chosen = o->compare;
    chosen.solid = o->classify.scene.solid;
    chosen.motion = o->classify.scene.motion;
    chosen.transient = v->temporary;
    chosen.size = sizeof chosen;
    int status = context_make(&v->context, &o->classify.scene.context);
    if (status)
        return status;
    return complain_of(
        graze_compare(&v->comparison, v->context, v->files[GOLDEN], v->files[ANSWERS], &chosen),
        v->context);
}

static void put_validation_verdict(char *out, size_t size, const graze_comparison_counts *n) {
    if (n->wrong + n->missing + n->extra == 0)
        snprintf(out, size, "no difference in %lu rows%s", n->rows,
                 n->undecided ? ", the undecided ones not judged" : "");
    else
        snprintf(out, size,
                 "differs from the exact answer: %lu of %lu rows wrong, %lu missing, %lu extra",
                 n->wrong, n->rows, n->missing, n->extra);
}

/* The text between the quotes of a JSON string. */
static void put_json_quoted(text *out, const char *string) {
    for (; *string; string++) {
        unsigned char c = (unsigned char)*string;
        char plain[] = {c < 0x20 || c > 126 ? '?' : *string, '\0'};
        text_put(out, c == '"' ? "\\\"" : c == '\\' ? "\\\\" : plain);
    }
}

static void put_json_text(text *out, const char *name, const char *value) {
    text_format(out, "\"%s\": \"", name);
    put_json_quoted(out, value);
    text_put(out, "\",\n");
}

/* What no points were made of, if anything. */
static void put_lost(text *out, const lost_strata *lost, graze_comparison_format format) {
    char *said = lost_strata_text(lost);
    if (!said)
        out->failed = 1;
    else if (*said && format == GRAZE_COMPARISON_JSON)
        put_json_text(out, "points", said);
    else if (*said && format == GRAZE_COMPARISON_TEXT)
        text_format(out, "points: %s\n", said);
    free(said);
}

static void put_validated(text *out, const validate_options *o, const char *verdict) {
    text_put(out, "# Validation\n\ncommand: ");
    text_code(out, o->candidate);
    text_put(out, "\nsolid: ");
    text_markdown(out, o->classify.scene.solid);
    text_put(out, "\nmotion: ");
    text_markdown(out, o->classify.scene.motion);
    text_format(out, "\nverdict: %s\n", verdict);
}

/* Whole numbers keep the locale's decimal comma out. */
static void put_validation(text *out, const validation *v, const validate_options *o,
                           const char *body, graze_comparison_format format) {
    graze_comparison_counts n = graze_comparison_count(v->comparison);
    unsigned long milliseconds = (unsigned long)(1000 * v->seconds + 0.5);
    unsigned long rate = milliseconds ? (unsigned long)((double)n.rows / v->seconds + 0.5) : 0;
    char verdict[160];
    put_validation_verdict(verdict, sizeof verdict, &n);
    if (format == GRAZE_COMPARISON_JSON) {
        text_put(out, "{\n");
        put_json_text(out, "command", o->candidate);
        put_json_text(out, "solid", o->classify.scene.solid);
        put_json_text(out, "motion", o->classify.scene.motion);
        put_json_text(out, "verdict", verdict);
        put_lost(out, &v->lost, format);
        text_format(out, "\"milliseconds\": %lu,\n\"rows-per-second\": %lu,\n", milliseconds, rate);
        text_put(out, "\"comparison\": ");
        text_put(out, body);
        text_put(out, "}\n");
        return;
    }
    put_validated(out, o, verdict);
    put_lost(out, &v->lost, format);
    text_format(out, "time: %lu.%03lu s, %lu rows a second\n\n", milliseconds / 1000,
                milliseconds % 1000, rate);
    text_put(out, body);
}

/* One report to a file NAME + suffix, or to standard output; it is made whole before the file is
 * opened. */
static int write_validation(const validation *v, const validate_options *o, const char *suffix,
                            graze_comparison_format format) {
    char *body = NULL, *path = o->output ? joined_texts(o->output, suffix) : NULL;
    text report;
    text_init(&report);
    int status =
        complain_of(graze_comparison_report(&body, v->context, v->comparison, format), v->context);
    if (!status)
        put_validation(&report, v, o, body, format);
    if (!status && (report.failed || (o->output && !path)))
        status = complain(EXIT_IO, "out of memory");
    if (!status)
        status = output_text(path, report.data);
    text_clear(&report);
    graze_free(body);
    free(path);
    return status;
}

static int report_validation(validation *v, const validate_options *o) {
    graze_comparison_counts n = graze_comparison_count(v->comparison);
    int status = o->output ? write_validation(v, o, ".md", GRAZE_COMPARISON_TEXT)
                           : write_validation(v, o, "", o->format);
    if (!status && o->output)
        status = write_validation(v, o, ".json", GRAZE_COMPARISON_JSON);
    return status ? status : n.wrong + n.missing + n.extra ? EXIT_NO : EXIT_DONE;
}

static int validate(validation *v, const validate_options *o) {
    int status = make_work_folder(v, o);
    if (status)
        return status;
    candidate_paths paths = {o->classify.scene.solid, o->classify.scene.motion, points_of(v, o),
                             v->files[ANSWERS]};
    status = candidate_split(&v->words, o->candidate, &paths);
    if (!status)
        status = make_golden(v, o);
    if (!status && unlink(v->files[ANSWERS]) != 0 && errno != ENOENT)
        status = complain(EXIT_IO, "%s: cannot be removed: %s", v->files[ANSWERS], strerror(errno));
    if (!status)
        status = candidate_run(&v->seconds, v->words, o->timeout ? o->timeout : 3600);
    if (!status)
        status = candidate_wrote(v->words[0], v->files[ANSWERS]);
    if (!status)
        status = compare_answers(v, o);
    return status ? status : report_validation(v, o);
}

static void add_validation_files(guard *g, const void *options, const operands *given) {
    const validate_options *o = options;
    (void)given;
    for (int k = o->points ? GOLDEN : POINTS; k < FILE_COUNT && o->keep; k++)
        guard_add(g, GUARD_WRITTEN, "keep", o->keep, file_names[k]);
    if (!o->output)
        return;
    guard_add(g, GUARD_WRITTEN, "output", o->output, ".md");
    guard_add(g, GUARD_WRITTEN, "output", o->output, ".json");
}

static int value_seconds(void *to, const char *name, const char *value) {
    if (!numbers_count(to, value, 1))
        return complain(EXIT_USAGE, "--%s %s: expected whole seconds from 1 up", name, value);
    return EXIT_DONE;
}

static const option_entry validate_table[] = {
    OPTION("candidate", validate_options, candidate, value_text),
    OPTION("n", validate_options, generate.count, value_count),
    OPTION("seed", validate_options, seed, value_seed),
    OPTION("strata", validate_options, generate.strata, value_text),
    OPTION("representable", validate_options, generate.representable, value_binary64),
    FILE_READ("points", validate_options, points),
    OPTION("timeout", validate_options, timeout, value_seconds),
    OPTION("keep", validate_options, keep, value_text),
    OPTION("output", validate_options, output, value_text),
    OPTION("o", validate_options, output, value_text),
    OPTION("question", validate_options, compare.question, value_question),
    OPTION("on-as", validate_options, compare.on_as, value_on_as),
    OPTION("candidate-has", validate_options, compare.has, value_has),
    OPTION("truth", validate_options, compare.truth, value_truth),
    OPTION("sdf-tolerance", validate_options, compare.sdf_tolerance, value_width),
    OPTION("motion-error", validate_options, compare.motion_error, value_positive),
    OPTION("sdf", validate_options, classify.scene.scene, value_sdf),
    OPTION("round", validate_options, classify.scene.context.rounding, value_rounding),
    OPTION("show", validate_options, compare.show, value_show),
    OPTION("format", validate_options, format, value_report),
    OPTION("overlap", validate_options, classify.scene.scene.overlap, value_overlap),
    OPTION("folds", validate_options, classify.scene.scene.folds, value_folds),
    OPTION("operation", validate_options, classify.scene.scene.operation, value_operation),
    FLAG("triangulate", validate_options, classify.scene.solid_flags, value_triangulate),
    OPTION("jobs", validate_options, classify.threads, value_jobs),
    OPTION("limit", validate_options, classify.scene.context.limits, value_limit),
    FLAG("quiet", validate_options, classify.quiet, value_quiet),
    {NULL, OPTION_FLAG, NULL, 0}};

/* Values are compared with enclosures, which the golden table has by default then. */
static int choose_enclosures(validate_options *o) {
    graze_options *golden = &o->classify.scene.scene;
    int needed = o->compare.has == GRAZE_HAS_SDF || o->compare.motion_error;
    if (golden->sdf > 0 && !needed)
        return complain(EXIT_USAGE, "--sdf is for --candidate-has sdf or --motion-error; see graze "
                                    "validate --help");
    if (!golden->sdf && needed)
        return value_sdf(golden, "sdf", "1e-10r");
    return EXIT_DONE;
}

static int run_validate(void *options, const operands *given) {
    validate_options *o = options;
    if (given->count != 2 || !o->candidate)
        return complain(EXIT_USAGE, "validate takes SOLID, MOTION and --candidate; see graze "
                                    "validate --help");
    if (o->points &&
        (o->generate.count || o->seed.given || o->generate.strata || o->generate.representable))
        return complain(EXIT_USAGE, "--points takes the place of -n, --seed, --strata and "
                                    "--representable");
    if (o->points && strcmp(o->points, "-") == 0)
        return complain(EXIT_USAGE, "--points -: expected a file, it is read twice");
    int status = compare_check(&o->compare);
    if (!status)
        status = choose_enclosures(o);
    if (status)
        return status;
    o->classify.scene.solid = given->item[0];
    o->classify.scene.motion = given->item[1];
    validation *v = calloc(1, sizeof *v);
    if (!v)
        return complain(EXIT_IO, "out of memory");
    at_work = v;
    memory_before_end(remove_folder_at_work);
    status = validate(v, o);
    memory_before_end(NULL);
    remove_work_folder(v);
    candidate_free(v->words);
    for (int k = 0; k < FILE_COUNT; k++)
        free(v->files[k]);
    free(v->folder);
    graze_comparison_destroy(v->comparison);
    graze_context_destroy(v->context);
    graze_thread_finish();
    free(v);
    return status;
}

static const validate_options ten_shown = {.classify.shard.part = {0, 1},
                                           .classify.scene.scene.size = sizeof(graze_options),
                                           .compare.show = 10};

const command command_validate = {.name = "validate",
                                  .options = validate_table,
                                  .size = sizeof(validate_options),
                                  .initial = &ten_shown,
                                  .reads = 2,
                                  .add_files = add_validation_files,
                                  .help = validate_help,
                                  .run = run_validate};
