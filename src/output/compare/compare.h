/* compare: confusion, error rates and first disagreements of two tables, or of a scene and a mesh.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_COMPARE_H
#define GRAZE_OUTPUT_COMPARE_H

#include "base/number/text.h"
#include "decide/filter/filter.h"
#include "decide/scene/scene.h"
#include "graze/compare.h"
#include "input/delimited/delimited.h"
#include "output/report/report.h"
#include "questions/generate/generate.h"
#include "questions/judge/judge.h"

/* Comparison of a golden table with the table of a candidate.
 *
 * Invariant of a finished comparison: rows = agree + wrong + undecided + missing, and every tally
 * adds up to the rows that have a value for it. */

/** Open both tables, match their rows, judge them. `out` is zeroed by the caller and cleared by
 * comparison_clear in either case. */
graze_status comparison_make(graze_comparison *out, graze_context *context, const char *golden,
                             const char *candidate, const graze_compare_options *options);

void comparison_clear(graze_comparison *c);

/** Does the candidate never answer `on`, though golden rows have this answer? */
int comparison_has_no_on(const graze_comparison *c);

/* A mesh as a candidate: its memberships beside golden ones, with no table of either. */

/** Points at which a mesh is compared with exact answers. */
typedef struct mesh_points {
    const struct graze_generator *generator; /* gives the points, rows 0 to count - 1; or NULL */
    const fmpq *point; /* without a generator: the points, 3 canonical rationals each */
    size_t count;
    const char *explain_options; /* for `graze explain`, with a blank before each; NULL: none */
} mesh_points;

/**
 * Compare the answers of a mesh at points with exact answers, as graze_compare does with tables.
 * The report has the same form, and holds the rows that disagree.
 *
 * A point on the mesh is neither in nor out: with GRAZE_ON_AS_ANY it is undecided and counted as
 * `apart` unless the golden answer is `on`; with the other conventions its answer is `on`. The
 * matrix counts it in any case.
 *
 * @param[out] out zeroed by the caller, and cleared by comparison_clear in either case
 * @param scene in space; shared by threads
 * @param mesh not of GRAZE_MESH_NONE
 * @param options only on_as, show, solid, motion and scene (in which wrong points are measured;
 * NULL: they are not) have an effect
 * @param threads at most TEAM_MOST
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM, GRAZE_EINTERNAL
 */
graze_status comparison_of_mesh(graze_comparison *out, graze_context *context,
                                const graze_scene *scene, const judged_mesh *mesh,
                                const mesh_points *points, int threads,
                                const graze_compare_options *options);

/* Reports. */

/** The report as JSON. */
graze_status comparison_json(char **out, graze_context *context, const graze_comparison *c);

/** The report as Markdown. */
graze_status comparison_text(char **out, graze_context *context, const graze_comparison *c);

/** Report a judged mesh. Bounds are rounded outward, so that they hold as they are written.
 * @param points comparison of the mesh's answers at points, or NULL
 * @return GRAZE_ESYSTEM */
graze_status judge_report(text *out, graze_context *context, const graze_judgement *judgement,
                          const graze_comparison *points, graze_judgement_format format);

/* The members of a comparison. First: errors of values, by decades. */
/** A number rounded up to six digits: digits * 10^(exponent - 5) with 100000 <= digits <= 999999;
 * digits 0: zero. */
typedef struct ceiling {
    unsigned long digits;
    long exponent;
} ceiling;

/** Errors below the first decade count as the least number of this decade; errors past the last
 * decade have no bin. */
enum { FIRST_DECADE = -99, LAST_DECADE = 99, DECADES = LAST_DECADE - FIRST_DECADE + 1 };

/** Errors of values against their enclosures. */
typedef struct errors {
    unsigned long rows;          /* values judged */
    unsigned long over, under;   /* values above and below the enclosure; all others are inside */
    unsigned long beyond;        /* values outside it by more than the tolerance */
    unsigned long *bin[DECADES]; /* by decade: counts by the two leading digits; NULL: no error */
    ceiling largest, largest_over;
} errors;

/* Columns, and the keys and ways by which rows are matched. */

/** Columns that a comparison uses; others are skipped. Those from COLUMN_OPTIONS on are the columns
 * of options of graze classify, in the order of columns_known (output/report/columns.h). Reports
 * have columns in this order. */
typedef enum column {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_ID,
    COLUMN_STRATUM,
    COLUMN_ORDER,
    COLUMN_K,
    COLUMN_PMC,
    COLUMN_CLASS,
    COLUMN_DEFINITION,
    COLUMN_CASE,
    COLUMN_I,
    COLUMN_T,
    COLUMN_CELL,
    COLUMN_TIME,
    COLUMN_BX,
    COLUMN_BY,
    COLUMN_BZ,
    COLUMN_ROLE,
    COLUMN_THETA,
    COLUMN_CONTACT_ORDER,
    COLUMN_ORIENTATION,
    COLUMN_LEFT,
    COLUMN_RIGHT,
    COLUMN_TRIMMED,
    COLUMN_STATUS,
    COLUMN_NEAR,
    COLUMN_NEAR_IN,
    COLUMN_WORD,
    COLUMN_SHIFT,
    COLUMN_SDF,
    COLUMN_OPTIONS,
    COLUMN_COUNT = COLUMN_OPTIONS + COLUMNS_MOST
} column;

/** Columns that make a row's key: `id` alone, or columns of numbers; none if rows are matched by
 * order alone. */
typedef struct row_key {
    int by_id;
    size_t count;
    column at[4];
} row_key;

/** Ways to match rows. */
typedef enum match_way {
    MATCH_STREAMED, /* equal keys in the same order, but for rows that are missing or extra; rows
                       ahead are read only where the next ones differ, at most MATCH_AHEAD */
    MATCH_INDEXED,  /* equal keys in any order; the candidate's rows are in memory */
    MATCH_ORDER     /* row k of one table with row k of the other, whatever their keys */
} match_way;

/* Depths of wrong rows, and counts by group. */

/** The number of thresholds for depths, as parts of the size: 1e-12, 1e-9, 1e-6, 1e-3. */
enum { DEPTH_PARTS = 4 };

/** Depths of the wrong rows. Zeroed at first, with `size` initialised. */
typedef struct depths {
    unsigned long wrong, stride;       /* wrong rows; every stride-th waits to be measured */
    size_t waiting;                    /* number of rows that wait to be measured */
    errors by[3];                      /* sizes |s| of signed distances, by golden pmc */
    fmpq_t size;                       /* the diagonal of S^0's box; 0: not known */
    unsigned long deeper[DEPTH_PARTS]; /* rows that are certainly deeper than each threshold */
    char *unmeasured; /* the limit that stopped the measuring, malloc'ed; NULL: none */
} depths;

/** Counts of the rows of one value of a column. */
typedef struct group {
    char *name;
    unsigned long rows, wrong, undecided, missing;
    errors *values; /* NULL: none */
} group;

/** Counts by the values of one column; `others` counts the rows of values beyond MOST_GROUPS. */
typedef struct tally {
    size_t count, capacity;
    group *groups;
    group others;
} tally;

/* Options and counts of a comparison. */

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

/** Conventions for `on`, by graze_on_as. */
enum { CONVENTIONS = GRAZE_ON_AS_OUT + 1 };

/** One disagreement that is shown. Texts are malloc'ed. */
typedef struct disagreement {
    unsigned long order; /* its number in the order in which disagreements were met */
    int pmc;             /* the golden answer of a wrong row; -1: a row is missing or extra */
    ceiling depth;       /* upper bound of |s|, where it is known */
    char *stratum;       /* NULL: not told */
    unsigned long row;   /* number of golden rows before it */
    unsigned long golden_line, candidate_line; /* 0: no such row */
    char *point;                               /* coordinates with blanks between */
    char *golden, *candidate;                  /* the answers; NULL where there is no row */
    char *golden_row, *candidate_row;          /* whole rows, of transient tables alone */
} disagreement;

/** Counts by the golden answer (row) and the candidate's (column); the last column counts missing
 * rows. */
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
    row_key key;                               /* columns by which rows are matched */
    match_way way;                             /* way in which rows are matched */
    unsigned long drifted;                     /* rows matched by order alone whose points differ */
    ceiling drift;               /* largest difference of a coordinate in these rows */
    int judged[COLUMN_OPTIONS];  /* 1: the candidate answers this */
    int lacking[COLUMN_OPTIONS]; /* of contact points: 1 if only the candidate lacks the column, 2
                              if only the golden table does */
    int valued;                  /* values are compared with the golden enclosures */
    int enclosed;                /* golden enclosures are read */
    fmpq_t tolerance, eta;       /* the tolerance of values, the motion error */
    char *explain_options;       /* of `graze explain`, with a blank before each */
    unsigned long rows, agree, wrong, undecided, missing, extra;
    unsigned long column_wrong[COLUMN_OPTIONS];
    unsigned long wrong_as[CONVENTIONS];  /* rows that each convention would call wrong */
    unsigned long golden_on, answered_on; /* answered rows: golden `on`; candidate says `on` */
    unsigned long undecided_answers[3];   /* undecided rows by the candidate's answer */
    unsigned long undecided_by_motion;    /* rows that the motion error leaves undecided */
    unsigned long open;                   /* golden rows with no decided answer that is judged */
    unsigned long of_pmc;                 /* golden rows with pmc as their only decided answer */
    int of_mesh;                          /* 1: the candidate is a mesh */
    unsigned long apart; /* undecided rows: points on the mesh whose golden answer is in or out */
    errors values;
    depths depth; /* of wrong rows */
    matrix confusion;
    int grouped[GROUPING_COUNT]; /* 1: the golden table has the column */
    tally tallies[GROUPING_COUNT];
    unsigned long met; /* disagreements met */
    /* Disagreements kept to be shown, room for them, and how many are missing or extra rows. */
    size_t shown, shown_capacity, shown_alone;
    int by_depth; /* 1: the deepest wrong rows come first */
    disagreement *disagreements;
};

#endif
