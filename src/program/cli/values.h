/* Options and values of the command line, and parts that commands share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_PROGRAM_CLI_VALUES_H
#define GRAZE_PROGRAM_CLI_VALUES_H

#include <stddef.h>
#include "program/cli/cli.h"

/* Boundaries by sampling as files: PLY, legacy VTK, CSV. */

/** Write a file in the form of its extension. Coordinates are the nearest binary64, in CSV exact.
 * Each returns an exit status and says what is wrong; EXIT_INPUT for a coordinate past the range of
 * binary64. */
int boundary_write_surface(const char *path, const graze_boundary *b, graze_context *context,
                           int dimension);
int boundary_write_cells(const char *path, const graze_boundary *b, graze_context *context,
                         int dimension);
int boundary_write_points(const char *path, const graze_boundary *b, graze_context *context,
                          int dimension);

/* A candidate's command, which is cut into words, gets its placeholders filled, and is run and
 * timed; and the file that it writes.
 *
 * No shell is started. Blanks separate words. Text in '...' is taken as it is; a backslash quotes "
 * and \ in "...", and any byte outside quotes. Nothing is expanded. A placeholder is a word of its
 * own and becomes one argument, with any bytes. */

/** Values of {solid}, {motion}, {points}, {out}. */
typedef struct candidate_paths {
    const char *solid, *motion, *points, *out;
} candidate_paths;

/**
 * Cut a command into words and fill its placeholders.
 * @param[out] words NULL-ended, for candidate_free; NULL on failure
 * @return EXIT_USAGE a quote left open, a placeholder inside a word or unknown, {points} or {out}
 * missing
 */
int candidate_split(char ***words, const char *command, const candidate_paths *paths);
void candidate_free(char **words);

/**
 * Run the command in `words` and wait, at most `timeout` seconds. Its standard output goes to the
 * standard error of graze.
 * @param[out] seconds time that the command took
 * @param hint text behind the message if its exit status is not 0; may be empty
 * @return EXIT_INPUT the command cannot be run, fails or takes too long; EXIT_SIGNAL
 */
int candidate_run(double *seconds, char **words, unsigned long timeout, const char *hint);

/** Check that a plain file, or a link to one, is at `path` and can be read. A FIFO is refused,
 * since reading it could wait for ever.
 * @return EXIT_INPUT if not
 */
int candidate_wrote(const char *name, const char *path);
/** Remove a folder with all that is in it; links are not followed. */
void candidate_remove(const char *folder);

/* A command, and how its options are read.
 *
 * A command names its options in a table. Each entry has a function that reads the option's value
 * into one field of the command's own struct. */

/** The entry of an option with a value, and of one without. */
#define OPTION(name, type, field, read)                                                            \
    { name, OPTION_VALUE, read, offsetof(type, field) }
#define FLAG(name, type, field, read)                                                              \
    { name, OPTION_FLAG, read, offsetof(type, field) }

/** Options whose value is a file to read, and a file to write. */
#define FILE_READ(name, type, field)                                                               \
    { name, OPTION_READ, value_text, offsetof(type, field) }
#define FILE_WRITTEN(name, type, field)                                                            \
    { name, OPTION_WRITTEN, value_text, offsetof(type, field) }

/** The entries of `--output FILE` and `-o FILE`, read by value_text, or by value_output if `-`
 * means the same as neither option. */
#define OUTPUT(type, field, read)                                                                  \
    {"output", OPTION_WRITTEN, read, offsetof(type, field)}, OPTION("o", type, field, read)

/** An option that may be given several times. */
#define REPEATED(name)                                                                             \
    { name, OPTION_VALUE, NULL, 0 }

/** The options --triangulate, --round and --limit of a solid that is read; for a scene also
 * --overlap. */
#define SOLID_OPTIONS(type, flags, context)                                                        \
    FLAG("triangulate", type, flags, value_triangulate),                                           \
        OPTION("round", type, context.rounding, value_rounding),                                   \
        OPTION("limit", type, context.limits, value_limit)
#define SCENE_OPTIONS(type, of)                                                                    \
    SOLID_OPTIONS(type, of.solid_flags, of.context),                                               \
        OPTION("overlap", type, of.scene.overlap, value_overlap)

/** The last entry of a table. */
#define OPTIONS_END                                                                                \
    { NULL, OPTION_FLAG, NULL, 0 }

/** Define word_help, the text of a file of help/. */
#define HELP(word)                                                                                 \
    extern const char word##_help[] ASSET;                                                         \
    ASSET_FILE(word##_help, "src/program/cli/help/" #word ".txt")

/** COMMAND(mend, mend_options, .reads = 1) defines command_mend from mend_table, mend_help and
 * run_mend. */
#define COMMAND(word, type, ...)                                                                   \
    const command command_##word = {.name = #word,                                                 \
                                    .options = word##_table,                                       \
                                    .size = sizeof(type),                                          \
                                    .help = word##_help,                                           \
                                    .run = run_##word,                                             \
                                    __VA_ARGS__}

/** The most options of one command. */
enum { OPTIONS_MOST = 40 };

/** Read the words of a command and run it; returns an exit status. */
int command_run(const command *c, int argc, char **argv);

/** Take the first two operands as the files of a scene. */
void scene_files(scene_options *o, const operands *given);

/* graze classify, for the programs that start it, and what graze certify shares with it. */

/** Add the file of the run's record (src/program/run/results.h), if one may be written. */
void classify_add_record(guard *g, const void *options, const operands *given);

/** Check that --output and --resume go together. Returns an exit status and says what is wrong. */
int classify_check_files(const classify_options *o);

/** Check that --resume and --shard go with the form of the table. Returns an exit status and says
 * what is wrong. */
int classify_check_table(const classify_options *o);

/** Read the value i/n of --shard into a struct shard_choice. */
int value_shard(void *to, const char *name, const char *value);

/* The commands, each in the file of its name. */

extern const command command_check, command_explain, command_generate, command_cases,
    command_compare, command_validate, command_merge, command_motion, command_boundary,
    command_draw, command_certify, command_convert, command_contact, command_envelope, command_mend,
    command_solid, command_collide, command_judge, command_outline;

/* Parts that graze validate shares with graze compare. */

/** Check that the options of a comparison go together. Returns an exit status and says what is
 * wrong. */
int compare_check(const graze_compare_options *o);

/* Strata that get fewer points than their weights ask for, and messages about them. */
/** Strata that get fewer points than their weights ask for, as sets of 1 << graze_stratum. Absent:
 * the scene has no point of them; unrepresentable: it has none with binary64 coordinates; spent: no
 * further points of them were found. */
typedef struct lost_strata {
    unsigned absent, unrepresentable, spent;
    int replaced;   /* 1: the stratum `rounded` has the weight of the unrepresentable ones */
    int has_dyadic; /* 1: the motion that `motion dyadic` makes has points of some of these */
} lost_strata;

/** Set has_dyadic where the dyadic motion near the scene's has points of the unrepresentable
 * strata.
 * @return GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status lost_strata_dyadic(lost_strata *lost, const loaded *l, const scene_options *o,
                                unsigned long long seed);

/** Lines about the lost strata, with `between` between them; an empty text if there are none.
 * malloc'ed; NULL when out of memory. */
char *lost_strata_text(const lost_strata *lost, const char *between);

/* One run of graze generate: a table of query points. */

/** The option --seed, which value_seed reads. */
typedef struct seed_value {
    int given;
    unsigned long long seed;
} seed_value;

/** Results of a generation; zeroed at first, freed by generated_clear. */
typedef struct generated {
    lost_strata lost;
    int dimension;
    unsigned long rows;
    char *box; /* box of the points, low then high, as decimals of up to 17 digits with commas */
} generated;

/** Options of a generation. Strings are borrowed. */
typedef struct generate_options {
    scene_options scene;
    unsigned long count;
    seed_value seed;
    const char *strata;  /* NAME=W,...; NULL: all, with default weights, and `rounded` with the
                            weight of the strata that --representable leaves without points */
    unsigned long level; /* weight of the stratum `level` where strata is NULL */
    coordinate_options coordinates;
    int representable;  /* coordinates that a binary64 holds */
    int plain;          /* no `#` lines */
    const char *output; /* NULL: standard output */
    int quiet;          /* no progress */
} generate_options;

/** Make the points, all different, and write the table. It ends early where no other
 * points are found. Returns an exit status and says what is wrong.
 * @param[out] made may be NULL; standard error names the lost strata too */
int generate_run(generated *made, const generate_options *o);
void generated_clear(generated *made);

/* Points to be drawn, with their names and strata. */

/** Points of one dimension; the texts are malloc'ed. Zeroed but for `dimension`, there are none. */
typedef struct marks {
    int dimension;
    mpq_t *value;
    size_t values, value_capacity; /* `values` of them are initialised */
    char **name, **stratum;        /* a stratum is NULL where the file has none */
    size_t count, capacity, stratum_capacity;
} marks;

void marks_clear(marks *m);
/** Add the points of a CSV file or `-`, named by the column id or by their numbers. Returns an exit
 * status and says what is wrong. */
int marks_read(marks *m, const char *path, graze_context *context);
/** Add the points of the option -p. */
int marks_take_points(marks *m, const char *const *points, int count, graze_context *context);
/** Set points, names and strata in the options of a picture. */
void marks_give(graze_draw_options *out, const marks *m);

/* Examples of motion files. */

/* Values of options that several commands take.
 *
 * Each function is an option_read (cli.h); its comment names the type of the field. */

option_read value_text;        /**< const char *: the value, borrowed */
option_read value_output;      /**< const char *: the value, borrowed; NULL for `-` */
option_read value_standard;    /**< const char *: the form of standard output, as `-.svg` */
option_read value_flag;        /**< int: 1 */
option_read value_quiet;       /**< int: 1, and no notes from then on */
option_read value_rounding;    /**< graze_rounding */
option_read value_limit;       /**< unsigned long[GRAZE_LIMIT_COUNT]: NAME=V */
option_read value_triangulate; /**< unsigned: GRAZE_SOLID_TRIANGULATE is added */
option_read value_draw_by;     /**< graze_draw_by */
option_read value_overlap;     /**< graze_overlap */
option_read value_folds;       /**< graze_folds */
option_read value_columns;     /**< graze_columns */
option_read value_sdf; /**< scene_options: the width of enclosures; relative if `r` follows it */
option_read value_motion_error; /**< double: a positive number, rounded up */
option_read value_side;         /**< graze_polygon_side */
option_read value_operation;    /**< graze_operation */
option_read value_count;        /**< unsigned long from 1 up */
option_read value_seed;         /**< seed_value */
option_read value_binary64;     /**< int: 1 if the value is binary64 */
option_read value_jobs;         /**< int from 1 to 1024 */
option_read value_format;       /**< graze_format */
option_read value_rows;         /**< graze_format: csv or jsonl */
option_read value_report;       /**< graze_comparison_format */
option_read value_question;     /**< graze_question */
option_read value_on_as;        /**< graze_on_as */
option_read value_has;          /**< graze_candidate_has */
option_read value_truth;        /**< graze_truth */
option_read value_closest;      /**< graze_pair_options: as value_sdf, of the least distance */
option_read value_width;        /**< const char *: a number from 0 up, borrowed */
option_read value_positive;     /**< const char *: a number above 0, borrowed */
option_read value_coordinates;  /**< coordinate_form */
option_read value_digits;       /**< int from 1 to 1000 */
option_read value_show;         /**< size_t up to 10^6 */

/** Refuse a name with an extension that is not among `endings`, as ".ply, .vtk or .stl"; a path of
 * NULL is fine. EXIT_USAGE. */
int value_ends_in(const char *option, const char *path, const char *endings);

/** Read a whole number from `low` to `most`; a value of NULL changes nothing. EXIT_USAGE. */
int numbers_within(unsigned long *to, const char *option, const char *value, unsigned long low,
                   unsigned long most);

/** Find the place of a value among `count` words, at most 8. EXIT_USAGE: it is none of them. */
int value_choice(int *out, const char *name, const char *value, const char *const *words,
                 int count);

/** Define a reader of an enumeration whose values 0, 1, ... have these words. */
#define VALUE_OF_WORDS(reader, type, ...)                                                          \
    int reader(void *to, const char *name, const char *value) {                                    \
        static const char *const words[] = {__VA_ARGS__};                                          \
        int chosen = 0;                                                                            \
        int status = value_choice(&chosen, name, value, words, sizeof words / sizeof *words);      \
        *(type *)to = (type)chosen;                                                                \
        return status;                                                                             \
    }

/* One run of graze validate: options, files and what was found. */

/** Files of the folder. */
enum { POINTS, GOLDEN, ANSWERS, FILE_COUNT };

typedef struct validate_options {
    const char *candidate;
    const char *points; /* NULL: points are generated */
    const char *keep;   /* folder for the files; NULL: one that is removed at the end */
    const char *output;
    const char *shrink; /* folder for the smallest scene in which the candidate is wrong, or NULL */
    unsigned long timeout; /* seconds */
    generate_options generate;
    classify_options classify;
    graze_compare_options compare;
    graze_comparison_format format;
} validate_options;

typedef struct validation {
    char *folder;
    int temporary;           /* 1: the folder is removed at the end */
    char *files[FILE_COUNT]; /* paths of the files in the folder */
    char **words;
    double seconds;
    int deep; /* the golden table has distances */
    generated made;
    graze_context *context;
    graze_comparison *comparison;
} validation;

/* Parts that graze validate and its reports share. */

/** The text `a` followed by `b`, malloc'ed; NULL when out of memory. */
char *joined_texts(const char *a, const char *b);

/** Write the reports asked for. Returns an exit status: EXIT_NO where the tables differ. */
int validation_report(const validation *v, const validate_options *o);

/** Check that --shrink has what it needs. Returns an exit status and says what is wrong. */
int shrink_check(const validate_options *o);
/** Become the program that shrinks the scene, which removes the folder of the files if it is
 * temporary and ends as validate does. Returns only if it cannot be run: EXIT_IO. */
int shrink_become(const validation *v, const validate_options *o);

/* The signed distances of a mesh's vertices, and its answers, as files. */

/**
 * Write a row for each vertex in the mesh's order: x, y, z, pmc, sdf_low, sdf_high; or a VTK file
 * of the mesh, with pmc and both bounds as data of its points. Returns an exit status and says what
 * is wrong.
 * @param found one enclosure for each vertex
 */
int vertex_table_write(const char *path, graze_context *context, const graze_mesh *mesh,
                       const graze_enclosure *found);

/** Write a row for each point: x, y, z and the mesh's pmc. Returns an exit status and says what is
 * wrong.
 * @param parity 1 if the mesh's rule is parity; the head names the rule
 * @param points 3 count rationals */
int answer_table_write(const char *path, int parity, graze_rationals points, const graze_pmc *found,
                       size_t count);

#endif
