/* graze classify: the table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "program/cli/values.h"

#include "base/context/scope.h"
#include "output/report/columns.h"

HELP(classify);

int value_shard(void *to, const char *name, const char *value) {
    struct shard_choice *out = to;
    out->given = 1;
    if (!shard_read(&out->part, value))
        return complain(EXIT_USAGE, "--%s %s: expected i/n, 1 <= i <= n <= %d", name, value,
                        SHARDS_MOST);
    return EXIT_DONE;
}

static const option_entry classify_table[] = {
    FLAG("at-rest", classify_options, scene.rows.at_rest, value_flag),
    OPTION("grid", classify_options, grid.sizes, value_text),
    OPTION("box", classify_options, grid.box, value_text),
    OPTION("operation", classify_options, scene.scene.operation, value_operation),
    OPTION("overlap", classify_options, scene.scene.overlap, value_overlap),
    OPTION("folds", classify_options, scene.scene.folds, value_folds),
    OPTION("sdf", classify_options, scene, value_sdf),
    FLAG("boundary-distance", classify_options, scene.rows.boundary, value_flag),
    OPTION("motion-error", classify_options, scene.rows.motion_error, value_motion_error),
    FLAG("moments", classify_options, scene.rows.moments, value_flag),
    FLAG("topo", classify_options, scene.rows.topo, value_flag),
    FLAG("regular", classify_options, scene.rows.regular, value_flag),
    OPTION("columns", classify_options, scene.rows.columns, value_columns),
    OPTION("coordinates", classify_options, coordinates.form, value_coordinates),
    OPTION("digits", classify_options, coordinates.digits, value_digits),
    OPTION("format", classify_options, scene.rows.format, value_format),
    OPTION("round", classify_options, scene.context.rounding, value_rounding),
    FLAG("triangulate", classify_options, scene.solid_flags, value_triangulate),
    OPTION("jobs", classify_options, threads, value_jobs),
    FLAG("no-filter", classify_options, scene.context.exact_only, value_flag),
    OUTPUT(classify_options, output, value_output),
    FILE_WRITTEN("certify", classify_options, certificate),
    FLAG("times", classify_options, times, value_flag),
    FILE_WRITTEN("resume", classify_options, resume),
    OPTION("shard", classify_options, shard, value_shard),
    FILE_READ("receipt", classify_options, receipt),
    FLAG("quiet", classify_options, quiet, value_quiet),
    OPTION("limit", classify_options, scene.context.limits, value_limit),
    OPTIONS_END};

void classify_add_record(guard *g, const void *options, const operands *given) {
    const classify_options *o = options;
    const char *path = o->resume ? o->resume : o->output;
    if (path && !output_is_standard(path))
        guard_add(g, GUARD_WRITTEN, o->resume ? "resume" : "output", path, RECORD_ENDING);
    if (o->scene.rows.at_rest && given->count == 2) /* POINTS, which may be standard input */
        guard_add(g, GUARD_INPUT, NULL, given->item[1], "");
}

int classify_check_files(const classify_options *o) {
    if (o->resume && o->output)
        return complain(EXIT_USAGE, "--resume FILE writes to FILE; expected no --output beside it");
    if (o->resume && (output_is_standard(o->resume) || output_is_standard(o->certificate)))
        return complain(EXIT_USAGE, "--resume goes on with plain files; expected their names in "
                                    "place of -");
    return EXIT_DONE;
}

int classify_check_table(const classify_options *o) {
    if ((o->resume || o->shard.given) && o->scene.rows.format != GRAZE_FORMAT_CSV)
        return complain(EXIT_USAGE, "%s needs the head of a table; expected --format csv",
                        o->resume ? "--resume" : "--shard");
    return EXIT_DONE;
}

/* With --columns pmc, refuse options that need more than pmc. */
static int check_columns(const classify_options *o) {
    const graze_row_options *rows = &o->scene.rows;
    const char *more = NULL;
    if (rows->columns == GRAZE_COLUMNS_ALL)
        return EXIT_DONE;
    for (const column_set *set = NULL; !more && (set = columns_next(set, rows));)
        more = set->needs > NEEDS_PMC ? set->option : NULL;
    if (!more)
        more = o->certificate                       ? "certify"
               : rows->format == GRAZE_FORMAT_JSONL ? "format jsonl"
                                                    : NULL;
    return more ? complain(EXIT_USAGE,
                           "--%s needs all answers; expected no --columns pmc beside it", more)
                : EXIT_DONE;
}

/* Refuse columns that need other columns which are missing, or that do not go with the form of the
 * rows. */
static int check_column_sets(const classify_options *o) {
    const graze_row_options *rows = &o->scene.rows;
    const char *distances = NULL;
    for (const column_set *set = NULL; (set = columns_next(set, rows));)
        distances = set->beside_sdf ? set->option : distances;
    if (distances && !(rows->sdf > 0))
        return complain(EXIT_USAGE, "--%s needs distances; expected --sdf beside it", distances);
    for (const column_set *set = NULL; (set = columns_next(set, rows));)
        if (set->is_exact && rows->format > GRAZE_FORMAT_JSONL)
            return complain(EXIT_USAGE, "--%s has exact times; expected --format csv or jsonl",
                            set->option);
    return EXIT_DONE;
}

/* The default form of coordinates: as given in the file of points, but exact with a certificate,
 * another format than CSV, a rounding or a grid. */
static coordinate_form default_form(const classify_options *o) {
    int exact = o->certificate || o->scene.rows.format != GRAZE_FORMAT_CSV ||
                o->scene.context.rounding || o->grid.sizes;
    return exact ? COORDINATES_EXACT : COORDINATES_AS_GIVEN;
}

/* Check the form of coordinates. A form other than exact needs CSV rows and no certificate;
 * as-given also needs points from a file, read without rounding. */
static int check_coordinates(classify_options *o) {
    const char *other = NULL;
    if (o->coordinates.form == COORDINATES_UNSET)
        o->coordinates.form = default_form(o);
    if (o->coordinates.form == COORDINATES_EXACT)
        return coordinates_check(&o->coordinates);
    if (o->certificate)
        return complain(EXIT_USAGE, "--certify needs a table with --coordinates exact");
    if (o->scene.rows.format != GRAZE_FORMAT_CSV)
        return complain(EXIT_USAGE, "--coordinates goes with --format csv");
    if (o->coordinates.form == COORDINATES_AS_GIVEN)
        other = o->scene.context.rounding ? "--round" : o->grid.sizes ? "--grid" : NULL;
    if (other)
        return complain(EXIT_USAGE,
                        "--coordinates as-given repeats numbers that are read and not changed; "
                        "expected no %s beside it",
                        other);
    return coordinates_check(&o->coordinates);
}

static int was_given(const operands *given, const char *name) {
    int k = 0;
    while (strcmp(classify_table[k].name, name) != 0)
        k++;
    return given->options >> k & 1;
}

/* Refuse options that ask about a motion beside --at-rest, whose rows have pmc alone. */
static int check_at_rest(classify_options *o, const operands *given) {
    static const char *const moving[] = {"operation",    "overlap", "folds",  "boundary-distance",
                                         "motion-error", "moments", "topo",   "regular",
                                         "times",        "certify", "receipt"};
    const char *named = was_given(given, "columns") && o->scene.rows.columns == GRAZE_COLUMNS_ALL
                            ? "columns all"
                            : NULL;
    for (size_t k = 0; !named && k < sizeof moving / sizeof *moving; k++)
        named = was_given(given, moving[k]) ? moving[k] : NULL;
    if (named)
        return complain(EXIT_USAGE, "--%s needs a motion; expected no --at-rest beside it", named);
    o->scene.rows.columns = GRAZE_COLUMNS_PMC;
    return EXIT_DONE;
}

/* Check the number of operands and take them over. */
static int take_operands(classify_options *o, const operands *given) {
    int rest = o->scene.rows.at_rest, wanted = (o->grid.sizes ? 2 : 3) - rest;
    if (given->count != wanted)
        return complain(EXIT_USAGE,
                        "classify takes SOLID, %s %s, %d operands given; see graze classify --help",
                        rest ? "with --at-rest no MOTION, and" : "MOTION and",
                        o->grid.sizes ? "with --grid no POINTS" : "POINTS or --grid", given->count);
    o->scene.solid = given->item[0];
    o->scene.motion = rest ? NULL : given->item[1];
    o->points = given->item[rest ? 1 : 2];
    return EXIT_DONE;
}

int classify_take(classify_options *o, const operands *given) {
    if (o->grid.box && !o->grid.sizes)
        return complain(EXIT_USAGE, "--box goes with --grid; see graze classify --help");
    TRY(take_operands(o, given));
    TRY(classify_check_files(o));
    TRY(o->scene.rows.at_rest ? check_at_rest(o, given) : check_columns(o));
    TRY(check_coordinates(o));
    TRY(check_column_sets(o));
    if (o->times && !o->certificate)
        return complain(EXIT_USAGE, "--times goes with --certify; see graze classify --help");
    return classify_check_table(o);
}

static int run_classify(void *options, const operands *given) {
    TRY(classify_take(options, given));
    return classify_run(options);
}

static const classify_options whole_run = {.shard.part = {0, 1},
                                           .coordinates.form = COORDINATES_UNSET};

COMMAND(classify, classify_options, .initial = &whole_run, .reads = 3, .inputs = 1,
        .add_files = classify_add_record);
