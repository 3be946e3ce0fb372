/* Golden table against candidate: what is asked, what is counted.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant of a finished comparison: rows = agree + wrong + apart + missing, and every tally adds
 * up to the rows that have a value for it.
 */
#ifndef GRAZE_COMPARE_COMPARE_H
#define GRAZE_COMPARE_COMPARE_H

#include "graze/compare.h"
#include "compare/table.h"
#include "number/text.h"

/** What is judged, in the order of columns. */
enum { JUDGED_PMC, JUDGED_CLASS, JUDGED_I, JUDGED_T, JUDGED_WORD, JUDGED_COUNT };

/** What errors are counted by. */
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

/** One disagreement, as it is shown. Texts are malloc'ed. */
typedef struct disagreement {
    unsigned long golden_line, candidate_line; /* 0: no such row */
    char *point;                               /* coordinates with blanks between */
    char *golden, *candidate;                  /* the answers; NULL where there is no row */
} disagreement;

/** Candidate's answers beside golden ones; the last column of a matrix counts missing rows. */
typedef struct matrix {
    unsigned long pmc[3][4];    /* in, on, out */
    unsigned long class_[5][6]; /* in the order of Definitions 5 to 9 */
} matrix;

struct graze_comparison {
    graze_compare_options options;
    graze_rounding rounding;
    char *golden, *candidate, *solid, *motion; /* names */
    int judged[JUDGED_COUNT];                  /* 1: the candidate answers this */
    char *explain_options;                     /* of `graze explain`, with a blank before each */
    unsigned long rows, agree, wrong, apart, missing, extra;
    unsigned long column_wrong[JUDGED_COUNT];
    unsigned long apart_answers[3]; /* the candidate's, for rows that are apart */
    matrix confusion;
    int grouped[GROUPING_COUNT]; /* 1: the golden table tells */
    tally tallies[GROUPING_COUNT];
    size_t shown;
    disagreement *disagreements;
};

/** Names of the columns judged, of the groupings, and of the answers in the matrices. */
const char *judged_name(int judged);
const char *grouping_name(grouping g);
extern const char *const pmc_words[3], *const class_words[5];

/** Open both tables, match their rows, judge them. `out` is zeroed by the caller and cleared by
 * comparison_clear in either case. */
graze_status comparison_make(graze_comparison *out, graze_context *context, const char *golden,
                             const char *candidate, const graze_compare_options *options);
void comparison_clear(graze_comparison *c);

/** The reports. */
graze_status comparison_text(char **out, graze_context *context, const graze_comparison *c);
graze_status comparison_json(char **out, graze_context *context, const graze_comparison *c);

/** The command that explains a disagreement, malloc'ed; NULL when out of memory. */
char *explain_command(const graze_comparison *c, const disagreement *d);

/** Count a row under its group. `status` is 'a'gree, 'w'rong, a'p'art or 'm'issing.
 * @return GRAZE_ESYSTEM */
graze_status tally_add(tally *t, graze_context *context, field name, char status);
/** Order the groups by name, numbers by value. */
void tally_sort(tally *t);
void tally_clear(tally *t);

#endif
