/* graze validate: makes points, classifies them, runs a candidate on them and reports.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The steps are the commands generate, classify and compare, joined by files in one folder.
 */
#include "program/cli/values.h"

#include <errno.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/context/scope.h"

HELP(validate);

/* If values are compared, the weight of the stratum `level` beside the default weights. */
enum { LEVEL_WEIGHT = 30 };

static const char *const file_names[FILE_COUNT] = {"/points.csv", "/golden.csv", "/candidate.csv"};

/* Make the folder for the files: the one of --keep, or a new one. */
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

static void validation_clear(validation *v) {
    remove_work_folder(v);
    candidate_free(v->words);
    for (int k = 0; k < FILE_COUNT; k++)
        free(v->files[k]);
    free(v->folder);
    generated_clear(&v->made);
    graze_comparison_destroy(v->comparison);
    graze_context_destroy(v->context);
}

/* The validation whose folder is removed if memory runs out and the program ends at once. */
static validation *at_work;

static void remove_folder_at_work(void) {
    remove_work_folder(at_work);
}

static const char *points_of(const validation *v, const validate_options *o) {
    return o->points ? o->points : v->files[POINTS];
}

/* Put the facts about generated points into the candidate's environment. */
static int tell_candidate(const validation *v, const validate_options *o) {
    const char *names[] = {"GRAZE_DIMENSION", "GRAZE_ROWS", "GRAZE_SEED", "GRAZE_BOX"};
    char numbers[3][24];
    const char *values[] = {numbers[0], numbers[1], numbers[2], v->made.box};
    snprintf(numbers[0], sizeof *numbers, "%d", v->made.dimension);
    snprintf(numbers[1], sizeof *numbers, "%lu", v->made.rows);
    snprintf(numbers[2], sizeof *numbers, "%llu", o->generate.seed.seed);
    for (int k = 0; k < 4; k++)
        if (setenv(names[k], values[k], 1) != 0)
            return complain(EXIT_IO, "out of memory");
    return EXIT_DONE;
}

/* Run the candidate. If the points have ratios, a failure gets a hint, since a candidate that reads
 * floats fails on them. */
static int run_candidate(validation *v, const validate_options *o) {
    int ratios = !o->points && !o->generate.representable &&
                 o->generate.coordinates.form != COORDINATES_DECIMAL;
    if (!o->points)
        TRY(tell_candidate(v, o));
    TRY(candidate_run(&v->seconds, v->words, o->timeout,
                      ratios ? "; its points have ratios such as 1/3, those of "
                               "--representable binary64 are decimals"
                             : ""));
    return candidate_wrote(v->words[0], v->files[ANSWERS]);
}

/* Classify the points. A table that is kept also has distances, unless the solid is curved or the
 * distances exceed a limit. */
static int classify_golden(validation *v, const validate_options *o, classify_options *golden) {
    int chosen = golden->scene.rows.sdf > 0;
    v->deep = chosen;
    if (o->keep && !chosen) {
        ZEROED(loaded, l);
        TRY(loaded_read(&l, &golden->scene, EXIT_INPUT, NULL));
        v->deep = !graze_solid_primitive_count(l.solid);
    }
    if (v->deep && !chosen)
        TRY(value_sdf(&golden->scene, "sdf", "1e-12r"));
    int status = classify_run(golden);
    if (status != EXIT_LIMIT || chosen || !v->deep)
        return status;
    complain(EXIT_DONE, "note: %s has no sdf_low and sdf_high, which meet this limit",
             golden->output);
    v->deep = 0;
    golden->scene = o->classify.scene;
    return classify_run(golden);
}

/* Make points and golden table as graze generate and graze classify do. */
static int make_golden(validation *v, const validate_options *o) {
    generate_options points = o->generate;
    classify_options golden = o->classify;
    points.scene = golden.scene;
    points.output = v->files[POINTS];
    points.quiet = golden.quiet;
    points.plain = 1;
    if (points.coordinates.form == COORDINATES_UNSET)
        points.coordinates.form = points.representable ? COORDINATES_DECIMAL : COORDINATES_EXACT;
    points.level = o->compare.has == GRAZE_HAS_SDF ? LEVEL_WEIGHT : 0;
    golden.points = points_of(v, o);
    golden.output = v->files[GOLDEN];
    golden.transient = 1;
    if (!o->points)
        TRY(generate_run(&v->made, &points));
    return classify_golden(v, o, &golden);
}

/* Compare the tables. If `scene` is not NULL, wrong rows are measured in it. */
static int compare_in(validation *v, const validate_options *o, const graze_scene *scene) {
    graze_compare_options chosen = o->compare;
    chosen.solid = o->classify.scene.solid;
    chosen.motion = o->classify.scene.motion;
    chosen.transient = v->temporary;
    chosen.scene = scene;
    chosen.size = sizeof chosen;
    graze_comparison_destroy(v->comparison);
    return complain_of(
        graze_compare(&v->comparison, v->context, v->files[GOLDEN], v->files[ANSWERS], &chosen),
        v->context);
}

/* Compare the tables. If rows are wrong, the golden table has no distances and the scene can give
 * them, compare once more with the scene. */
static int compare_answers(validation *v, const validate_options *o) {
    ZEROED(loaded, l);
    TRY(context_make(&v->context, &o->classify.scene.context));
    TRY(compare_in(v, o, NULL));
    if (!graze_comparison_count(v->comparison).wrong || v->deep)
        return EXIT_DONE;
    TRY(loaded_read(&l, &o->classify.scene, EXIT_INPUT, NULL));
    return graze_solid_primitive_count(l.solid) ? EXIT_DONE : compare_in(v, o, l.scene);
}

static int validate(validation *v, const validate_options *o) {
    TRY(make_work_folder(v, o));
    candidate_paths paths = {o->classify.scene.solid, o->classify.scene.motion, points_of(v, o),
                             v->files[ANSWERS]};
    TRY(candidate_split(&v->words, o->candidate, &paths));
    TRY(make_golden(v, o));
    if (unlink(v->files[ANSWERS]) != 0 && errno != ENOENT)
        return complain(EXIT_IO, "%s: cannot be removed: %s", v->files[ANSWERS], strerror(errno));
    TRY(run_candidate(v, o));
    TRY(compare_answers(v, o));
    int status = validation_report(v, o);
    if (o->shrink && status == EXIT_NO && graze_comparison_count(v->comparison).wrong)
        return shrink_become(v, o);
    return status;
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
    OPTION("seed", validate_options, generate.seed, value_seed),
    OPTION("strata", validate_options, generate.strata, value_text),
    OPTION("representable", validate_options, generate.representable, value_binary64),
    OPTION("coordinates", validate_options, generate.coordinates.form, value_coordinates),
    OPTION("digits", validate_options, generate.coordinates.digits, value_digits),
    FILE_READ("points", validate_options, points),
    OPTION("timeout", validate_options, timeout, value_seconds),
    OPTION("keep", validate_options, keep, value_text),
    OPTION("shrink", validate_options, shrink, value_text),
    OPTION("output", validate_options, output, value_output),
    OPTION("o", validate_options, output, value_output),
    OPTION("question", validate_options, compare.question, value_question),
    OPTION("on-as", validate_options, compare.on_as, value_on_as),
    OPTION("candidate-has", validate_options, compare.has, value_has),
    OPTION("truth", validate_options, compare.truth, value_truth),
    OPTION("sdf-tolerance", validate_options, compare.sdf_tolerance, value_width),
    OPTION("motion-error", validate_options, compare.motion_error, value_positive),
    OPTION("sdf", validate_options, classify.scene, value_sdf),
    SCENE_OPTIONS(validate_options, classify.scene),
    OPTION("show", validate_options, compare.show, value_show),
    OPTION("format", validate_options, format, value_report),
    OPTION("folds", validate_options, classify.scene.scene.folds, value_folds),
    OPTION("operation", validate_options, classify.scene.scene.operation, value_operation),
    OPTION("jobs", validate_options, classify.threads, value_jobs),
    FLAG("quiet", validate_options, classify.quiet, value_quiet),
    OPTIONS_END};

/* Give the golden table enclosures if values are compared; refuse --sdf if nothing uses enclosures.
 */
static int choose_enclosures(validate_options *o) {
    scene_options *golden = &o->classify.scene;
    int needed = o->compare.has == GRAZE_HAS_SDF || o->compare.motion_error;
    if (golden->rows.sdf > 0 && !needed && !o->keep)
        return complain(EXIT_USAGE, "--sdf is for --candidate-has sdf, --motion-error or --keep; "
                                    "see graze validate --help");
    if (!golden->rows.sdf && needed)
        return value_sdf(golden, "sdf", "1e-10r");
    return EXIT_DONE;
}

static int run_validate(void *options, const operands *given) {
    validate_options *o = options;
    if (given->count != 2 || !o->candidate)
        return complain(EXIT_USAGE, "validate takes SOLID, MOTION and --candidate; see graze "
                                    "validate --help");
    if (o->points && (o->generate.count || o->generate.seed.given || o->generate.strata ||
                      o->generate.representable || o->generate.coordinates.digits ||
                      o->generate.coordinates.form != COORDINATES_UNSET))
        return complain(EXIT_USAGE, "--points takes the place of -n, --seed, --strata, "
                                    "--representable, --coordinates and --digits");
    if (o->points && strcmp(o->points, "-") == 0)
        return complain(EXIT_USAGE, "--points -: expected a file, it is read twice");
    if (o->generate.coordinates.form == COORDINATES_AS_GIVEN)
        return complain(EXIT_USAGE, "--coordinates as-given: expected exact or decimal; points "
                                    "that are made are not given");
    TRY(compare_check(&o->compare));
    TRY(coordinates_check(&o->generate.coordinates));
    TRY(choose_enclosures(o));
    TRY(shrink_check(o));
    if (!o->generate.count)
        o->generate.count = 10000;
    if (!o->generate.seed.given)
        o->generate.seed.seed = 1;
    scene_files(&o->classify.scene, given);
    ZEROED(validation, v);
    at_work = &v;
    memory_before_end(remove_folder_at_work);
    int status = validate(&v, o);
    memory_before_end(NULL);
    return status;
}

static const validate_options ten_shown = {.classify.shard.part = {0, 1},
                                           .generate.coordinates.form = COORDINATES_UNSET,
                                           .compare.show = 10,
                                           .timeout = 3600};

COMMAND(validate, validate_options, .initial = &ten_shown, .reads = 2,
        .add_files = add_validation_files);
