/* graze/compare.h - a candidate's table against a golden one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_H
#define GRAZE_COMPARE_H

#include <graze/core.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a candidate's pmc is measured against. */
typedef enum graze_question {
    GRAZE_QUESTION_OPEN = 0, /**< the open sweep: pmc as Graze gives it */
    GRAZE_QUESTION_CLOSED =
        1 /**< position in the closed sweep, of which `on` points are members:
             `on` with topo `interior` counts as `in`; without such a column,
             `on` rows that may be seams are counted apart. pmc alone is judged */
} graze_question;

/** What `on` is, for candidates that only know in and out. */
typedef enum graze_on_as {
    GRAZE_ON_AS_ON = 0,  /**< an answer of its own */
    GRAZE_ON_AS_ANY = 1, /**< where the golden answer is `on`, any answer is right */
    GRAZE_ON_AS_IN = 2,  /**< the same as `in`, in both tables */
    GRAZE_ON_AS_OUT = 3  /**< the same as `out`, in both tables */
} graze_on_as;

/** Where a candidate's answers stand. */
typedef enum graze_candidate_has {
    GRAZE_HAS_COLUMNS = 0, /**< in those of the columns pmc, class, i, t, word that it has */
    GRAZE_HAS_SDF = 1      /**< in the sign of the column sdf: negative inside, 0 `on` */
} graze_candidate_has;

/** How to compare. Zeroed it holds the defaults. */
typedef struct graze_compare_options {
    graze_question question;
    graze_on_as on_as;
    graze_candidate_has has;
    size_t show; /**< disagreements to keep, each with the command that explains it */
    const char *solid, *motion; /**< names for those commands, or NULL */
} graze_compare_options;

/** rows = agree + wrong + apart + missing; `extra` rows are the candidate's only. */
typedef struct graze_comparison_counts {
    unsigned long rows, agree, wrong, apart, missing, extra;
} graze_comparison_counts;

typedef enum graze_comparison_format {
    GRAZE_COMPARISON_TEXT = 0, /**< Markdown that reads well as it is */
    GRAZE_COMPARISON_JSON = 1
} graze_comparison_format;

typedef struct graze_comparison graze_comparison;

/**
 * Compare a candidate's table with a golden one, row by row. Rows are matched by order, with the
 * column `id` as check where both tables have it and else the point, rounded as the context says.
 * Rows missing and rows too many are looked past; hashes in the `#` lines of both must agree. The
 * tables are streamed: no more than 1000 rows of each are in memory, and under rounding at most
 * 128 MB of digests of golden points.
 * @param golden    a whole table of graze classify (its last line is `# complete N`), or `-`
 * @param candidate CSV with a line of column names, or `-`; `#` lines are optional
 * @param options   or NULL
 * @return GRAZE_ESYSTEM a file cannot be read; GRAZE_EINPUT a table is not whole, lacks columns, is
 * in another order or of another scene, holds what is no answer, or rounding makes golden points
 * equal whose answers differ; GRAZE_ELIMIT; GRAZE_ECANCELED
 */
GRAZE_API GRAZE_CHECKED graze_status graze_compare(graze_comparison **out, graze_context *context,
                                                   const char *golden, const char *candidate,
                                                   const graze_compare_options *options);
/** Free a comparison. NULL is harmless. */
GRAZE_API void graze_comparison_destroy(graze_comparison *comparison);
/** The counts; the tables differ if wrong + missing + extra > 0. Zeroed for NULL. */
GRAZE_API graze_comparison_counts graze_comparison_count(const graze_comparison *comparison);
/** All figures: confusion matrices, errors by stratum, distance, class, definition and case, the
 * disagreements kept. Text for graze_free. */
GRAZE_API GRAZE_CHECKED graze_status graze_comparison_report(char **out, graze_context *context,
                                                             const graze_comparison *comparison,
                                                             graze_comparison_format format);

#ifdef __cplusplus
}
#endif
#endif
