/* Options and counts of a comparison.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_COMPARISON_H
#define GRAZE_COMPARE_COMPARISON_H

#include "graze/compare.h"
#include "output/compare/depth.h"
#include "output/compare/match.h"
#include "output/compare/tally.h"

/** Answers that are judged, in the order of their columns; those of points and those of contact
 * points have the word in common. */
enum {
    JUDGED_PMC,
    JUDGED_CLASS,
    JUDGED_I,
    JUDGED_T,
    JUDGED_CELL,
    JUDGED_ROLE,
    JUDGED_THETA,
    JUDGED_CONTACT_ORDER,
    JUDGED_ORIENTATION,
    JUDGED_LEFT,
    JUDGED_RIGHT,
    JUDGED_TRIMMED,
    JUDGED_STATUS,
    JUDGED_NEAR,
    JUDGED_NEAR_IN,
    JUDGED_WORD,
    JUDGED_SHIFT,
    JUDGED_SDF,
    JUDGED_COUNT
};

/** Is this an answer of a table of contact points (1), or of graze classify (0)? */
int judged_of(int judged, int contacts);

/** Groupings of errors. */
typedef enum grouping {
    BY_STRATUM,
    BY_DISTANCE,
    BY_SDF, /* the decade of the signed distance */
    BY_CLASS,
    BY_DEFINITION,
    BY_CASE,
    BY_STATUS, /* of contact points */
    BY_ROLE,
    GROUPING_COUNT
} grouping;

/** Answers, and indices of them. */
extern const char *const pmc_words[3];
enum { PMC_IN, PMC_ON, PMC_OUT };

/** Conventions for `on`, by graze_on_as. */
enum { CONVENTIONS = GRAZE_ON_AS_OUT + 1 };

/** The name of a grouping, and a longer one for the head of a table. Static. */
const char *grouping_name(grouping g);
const char *grouping_title(grouping g);

/** Most wrong rows of one stratum that are shown where the deepest are. */
enum { MOST_OF_STRATUM = 2 };

/** One disagreement, as it is shown. Texts are malloc'ed. */
typedef struct disagreement {
    unsigned long order; /* in which it was met */
    int pmc;             /* the golden answer of a wrong row; -1: a row is missing or extra */
    ceiling depth;       /* upper bound of |s|, where it is known */
    char *stratum;       /* NULL: not told */
    unsigned long row;   /* golden rows before it */
    unsigned long golden_line, candidate_line; /* 0: no such row */
    char *point;                               /* coordinates with blanks between */
    char *golden, *candidate;                  /* the answers; NULL where there is no row */
    char *golden_row, *candidate_row;          /* whole rows, of transient tables alone */
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
    char *golden_columns, *candidate_columns;  /* their column lines */
    int contacts;                              /* 1: tables of contact points */
    row_key key;                               /* by which rows are matched, */
    match_way way;                             /* and how */
    unsigned long drifted;     /* rows matched by order alone whose points differ, */
    ceiling drift;             /* and the largest difference of a coordinate */
    int judged[JUDGED_COUNT];  /* 1: the candidate answers this */
    int lacking[JUDGED_COUNT]; /* of contact points: 1 the candidate, 2 the golden table alone does
                                  not have the column */
    int valued;                /* values are compared with the golden enclosures */
    int enclosed;              /* these are read */
    fmpq_t tolerance, eta;     /* of values, and of the motion */
    char *explain_options;     /* of `graze explain`, with a blank before each */
    unsigned long rows, agree, wrong, undecided, missing, extra;
    unsigned long column_wrong[JUDGED_COUNT];
    unsigned long wrong_as[CONVENTIONS];  /* rows that each convention would call wrong */
    unsigned long golden_on, answered_on; /* rows of either table; golden ones with an answer */
    unsigned long undecided_answers[3];   /* the candidate's, for such rows */
    unsigned long undecided_by_motion;    /* rows that the motion error leaves undecided */
    unsigned long open;                   /* golden rows that are undecided themselves, */
    unsigned long of_pmc;                 /* and those judged by pmc alone, as the rest is */
    int of_mesh; /* 1: the candidate is a mesh (mesh_rows.h), and these rows are undecided: */
    unsigned long apart; /* points on the mesh whose golden answer is `in` or `out` */
    errors values;
    depths depth; /* of wrong rows */
    matrix confusion;
    int grouped[GROUPING_COUNT]; /* 1: the golden table has the column */
    tally tallies[GROUPING_COUNT];
    unsigned long met; /* disagreements that were offered; the number shown or kept for that, */
    size_t shown, shown_capacity, shown_alone; /* the number of these that are missing or extra */
    int by_depth;                              /* 1: the deepest wrong rows come first */
    disagreement *disagreements;
};

/** Does the candidate never answer `on`, though golden rows are? */
int comparison_has_no_on(const graze_comparison *c);

#endif
