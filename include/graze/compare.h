/* graze/compare.h - a candidate's table against a golden one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_H
#define GRAZE_COMPARE_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Set that the pmc of a candidate refers to. */
typedef enum graze_question {
    GRAZE_QUESTION_OPEN = 0,  /**< the open sweep: pmc as Graze gives it */
    GRAZE_QUESTION_CLOSED = 1 /**< the closed sweep, which has the `on` points as members: `on` with
                                   topo `interior` counts as `in`; without a column topo, `on` rows
                                   that may be seams are undecided. Only pmc is compared */
} graze_question;

/** Meaning of `on` for candidates that only have in and out. */
typedef enum graze_on_as {
    GRAZE_ON_AS_ON = 0,  /**< an answer of its own */
    GRAZE_ON_AS_ANY = 1, /**< any answer agrees with a golden `on` */
    GRAZE_ON_AS_IN = 2,  /**< the same as `in`, in both tables */
    GRAZE_ON_AS_OUT = 3  /**< the same as `out`, in both tables */
} graze_on_as;

/** Columns with the answers of a candidate. */
typedef enum graze_candidate_has {
    GRAZE_HAS_COLUMNS = 0, /**< the columns among pmc, class, i, t, word that the candidate has */
    GRAZE_HAS_SDF = 1      /**< the column sdf: negative inside, 0 `on`. Its sign is judged, and its
                                value where the golden table has sdf_low and sdf_high */
} graze_candidate_has;

/** Rows whose values are judged. */
typedef enum graze_truth {
    GRAZE_TRUTH_PSEUDO = 0, /**< all rows; the value is s, the least signed distance to a position
                               of the solid */
    GRAZE_TRUTH_OUTSIDE = 1 /**< `out` rows alone, where s is the distance to the sweep */
} graze_truth;

/** Options of a comparison (rule 6). All pointers are borrowed. */
typedef struct graze_compare_options {
    size_t size; /**< sizeof(graze_compare_options) */
    graze_question question;
    graze_on_as on_as;
    graze_candidate_has has;
    size_t show; /**< number of disagreements to keep, each with the command that explains it: the
                      deepest wrong rows, at most two of a stratum, then rows that are missing or
                      extra; where distances are not known, the first rows that disagree */
    const char *solid, *motion; /**< file names for those commands, or NULL */
    int transient;     /**< 1: the tables will be gone when the report is read, so the report has
                            the rows that disagree, and names neither files nor their lines */
    graze_truth truth; /**< with GRAZE_HAS_SDF */
    const char *sdf_tolerance; /**< a number from 0 up: values that miss the enclosure by more are
                                    wrong. NULL: values are reported, not judged. Signs have no
                                    tolerance */
    const char *motion_error;  /**< a positive number: enclosures are widened by it; rows whose sign
                                    is not certain then are undecided (proofs/distance.md C73). Only
                                    pmc and sdf are compared. NULL: none */
    const graze_scene *scene;  /**< scene of the golden table, in which the signed distances of at
                                    most 1000 wrong rows are enclosed to 1e-13 of the diagonal; the
                                    wrong rows kept are among these. NULL: only columns sdf_low and
                                    sdf_high of the table give distances */
} graze_compare_options;

/** Counts of rows: rows = agree + wrong + undecided + missing; `extra` rows are in the candidate
 * only.
 */
typedef struct graze_comparison_counts {
    unsigned long rows, agree, wrong, undecided, missing, extra;
    unsigned long wrong_as[4]; /**< how many rows are wrong under each graze_on_as */
    int has_no_on;             /**< 1: golden rows are `on`, and the candidate never answers it */
} graze_comparison_counts;

/** Form of a report. */
typedef enum graze_comparison_format {
    GRAZE_COMPARISON_TEXT = 0, /**< Markdown, readable as plain text */
    GRAZE_COMPARISON_JSON = 1
} graze_comparison_format;

typedef struct graze_comparison graze_comparison;

/**
 * Compare a candidate's table with a golden one, row by row. Rows are matched by the column `id` if
 * both tables have it (numbers by value), in any order; else by the point, rounded as the context
 * says. If equally many rows of each table then lack a counterpart, these are matched by order,
 * provided that their points differ by no more than rounding explains. A candidate without points
 * is matched by order alone. Missing rows and extra rows are counted; hashes in the `#` lines of
 * both tables must agree. Tables in the same order are streamed: at most 1000 rows of each are in
 * memory. In another order all rows of the candidate are, and with rounding at most 160 MB of
 * digests of golden points. A pipe is read only once, so its rows must be in the same order. Two
 * tables of graze contact are compared too: the key of a row is its time and its point (bx, by, bz,
 * else x, y, z); rows may stand in any order, rows with equal keys are matched in order, and all
 * rows of the candidate are in memory. Each column that both tables have is judged; of the options
 * only show, solid, motion and transient have an effect.
 * @param golden    file name of a whole table of graze classify or graze contact (last line `#
 * complete N`), or `-`
 * @param candidate file name of a CSV table with a column line, or `-`; `#` lines are optional
 * @param options   may be NULL for the defaults
 * @return GRAZE_EUSE; GRAZE_ESYSTEM a file cannot be read; GRAZE_EINPUT a table is incomplete,
 * lacks columns, has another order, another scene or another kind of rows, has an unknown answer,
 * an option is not a number as described above, or rounding makes golden points with different
 * answers equal; GRAZE_ELIMIT; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_compare(graze_comparison **out, graze_context *context,
                                                   const char *golden, const char *candidate,
                                                   const graze_compare_options *options);
/** Free a comparison. NULL is allowed. */
GRAZE_API void graze_comparison_destroy(graze_comparison *comparison);
/** Counts of a comparison; the tables differ if wrong + missing + extra > 0, and while rows are
 * missing nothing is said of the candidate's answers. Zeros for NULL. */
GRAZE_API graze_comparison_counts graze_comparison_count(const graze_comparison *comparison);
/** A disagreement that was kept. Texts are borrowed from the comparison. */
typedef struct graze_disagreement {
    unsigned long row; /**< number in the golden table, from 0; for a row that
                            only the candidate has, the number of golden
                            rows before it */
    unsigned long golden_line, candidate_line; /**< in the files; 0: no such row */
    const char *point;                         /**< coordinates with blanks between */
    const char *golden, *candidate;            /**< answers as `pmc=on i=0`; NULL: no such row */
} graze_disagreement;

/** Disagreement `index` of those kept, in their order (`show`); zero past the end. */
GRAZE_API graze_disagreement graze_comparison_disagreement(const graze_comparison *comparison,
                                                           size_t index);
/** The golden table's scene as options of `graze explain`, each with a blank before it; "" for
 * NULL. Borrowed. */
GRAZE_API const char *graze_comparison_head(const graze_comparison *comparison);
/** Report of a comparison: confusion matrices, errors by stratum, distance, class, definition and
 * case (contact points: by column, stratum, distance, status and role), and the disagreements kept.
 * Text for graze_free.
 * @return GRAZE_EUSE, GRAZE_ESYSTEM */
GRAZE_API GRAZE_CHECKED graze_status graze_comparison_report(char **out, graze_context *context,
                                                             const graze_comparison *comparison,
                                                             graze_comparison_format format);

#ifdef __cplusplus
}
#endif
#endif
