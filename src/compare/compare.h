/* Comparison of a candidate with a golden table: options, counts, disagreements.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant of a finished comparison: rows = agree + wrong + apart + missing, and every tally adds
 * up to the rows that have a value for it.
 */
#ifndef GRAZE_COMPARE_COMPARE_H
#define GRAZE_COMPARE_COMPARE_H

<<<<<<< HEAD
#include "compare/comparison.h"
=======
#include "graze/compare.h"
#include "compare/table.h"
#include "number/text.h"

/** Columns that are judged, in their order. */
enum { JUDGED_PMC, JUDGED_CLASS, JUDGED_I, JUDGED_T, JUDGED_WORD, JUDGED_COUNT };

/** Columns by which errors are counted. */
typedef enum grouping {
    BY_STRATUM,
    BY_DISTANCE,
    BY_CLASS,
    BY_DEFINITION,
    BY_CASE,
    GROUPING_COUNT
} grouping;

/** Groups past this number are counted as one. */
enum { MOST_GROUPS = 1000 };

typedef struct group {
    char *name;
    unsigned long rows, wrong, apart, missing;
} group;

typedef struct tally {
    size_t count, capacity;
    group *groups;
    group others;
} tally;

/** One disagreement. Texts are malloc'ed. */
typedef struct disagreement {
    unsigned long golden_line, candidate_line; /* 0: no such row */
    char *point;                               /* coordinates with blanks between */
    char *golden, *candidate;                  /* the answers; NULL where there is no row */
} disagreement;

/** Golden answers by candidate answers; the last column of a matrix counts missing rows. */
typedef struct matrix {
    unsigned long pmc[3][4];    /* in, on, out */
    unsigned long class_[5][6]; /* in the order of Definitions 5 to 9 */
} matrix;

struct graze_comparison {
    graze_compare_options options;
    graze_rounding rounding;
    char *golden, *candidate, *solid, *motion; /* names */
    int judged[JUDGED_COUNT];                  /* 1: the candidate has this column */
    char *explain_options;                     /* of `graze explain`, with a blank before each */
    unsigned long rows, agree, wrong, apart, missing, extra;
    unsigned long column_wrong[JUDGED_COUNT];
    unsigned long apart_answers[3]; /* of the candidate, in rows that are apart */
    matrix confusion;
    int grouped[GROUPING_COUNT]; /* 1: the golden table has this column */
    tally tallies[GROUPING_COUNT];
    size_t shown;
    disagreement *disagreements;
};

/** Names of judged columns, of groupings, and of the answers in the matrices. */
const char *judged_name(int judged);
const char *grouping_name(grouping g);
extern const char *const pmc_words[3], *const class_words[5];
>>>>>>> dc5de61 (Words: comparison, contexts, reports and poses say what is expected)

/** Open both tables, match their rows, judge them. `out` is zeroed by the caller and cleared by
 * comparison_clear in either case. */
graze_status comparison_make(graze_comparison *out, graze_context *context, const char *golden,
                             const char *candidate, const graze_compare_options *options);
void comparison_clear(graze_comparison *c);

#endif
