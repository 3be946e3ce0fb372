/* Counts of compared rows: confusion, errors, depths, values.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_COMPARE_COUNTS_H
#define GRAZE_OUTPUT_COMPARE_COUNTS_H

#include "output/compare/rows.h"

/* Numbers rounded up to a few decimal digits, for reports. */

/** The ceiling of a number that is not negative. */
ceiling ceiling_of(const fmpq_t x);

/** Negative, 0 or positive as a is less than, equal to or greater than b. */
int ceiling_compare(ceiling a, ceiling b);

/** Append a number as 1.5e-05, without trailing zeros in the digits; zero as 0. */
void ceiling_put(text *out, ceiling c);

/** The k with 10^k <= x < 10^(k + 1), for a positive x. */
long decade_of(const fmpq_t x);

/* Errors of values: their number, sides, quantiles and the largest.
 *
 * Memory does not grow with the rows: errors are counted by their two leading digits, rounded up.
 */

/** An error: its size, side (1 above, -1 below, 0 within the enclosure), and whether it is more
 * than the tolerance. */
typedef struct value_error {
    ceiling size;
    int side, beyond;
} value_error;

/** Count an error. 0 when out of memory. */
int errors_add(errors *e, value_error one);

/** The least number of two digits that at least `per_mille` thousandths of the errors do not
 * exceed, or the largest error if this is past the last decade; 0 if there are no errors. */
ceiling errors_quantile(const errors *e, unsigned long per_mille);

void errors_clear(errors *e);

/* How deep wrong rows are: enclosures of the signed distances of their points.
 *
 * The golden table has the enclosures, or they are computed for at most MOST_MEASURED rows, spread
 * evenly over the wrong ones. */

enum { MOST_MEASURED = 1000 };
extern const char *const depth_parts[DEPTH_PARTS];

/** Count the enclosure that a golden row has; *out is the larger size of its bounds. GRAZE_EINPUT,
 * GRAZE_ELIMIT, GRAZE_ESYSTEM. */
graze_status depth_take(ceiling *out, depths *d, const table *golden, const table_row *row,
                        int pmc);

/* Distances between the points of two rows that were matched by id or by the order of rows. */

void drift_init(drift *d, const table *golden, const table *candidate);
void drift_clear(drift *d);

/** Count a pair of rows, with coordinates rounded as the context says. GRAZE_EINPUT, GRAZE_ELIMIT.
 */
graze_status drift_add(drift *d, const table_row *right, const table_row *given);

/** Can rounding or printing of numbers explain all differences of coordinates: is each at most
 * 2^-10 of the box of the golden points that differ, or 2^-20 of their size? */
int drift_is_small(const drift *d);

/* Rows counted by group. */

/** Groups past this number are counted as one, so that a column of many values takes little memory.
 */
enum { MOST_GROUPS = 1000 };

/** Count a row under its group. `status` is 'a' (agree), 'w' (wrong), 'u' (undecided) or 'm'
 * (missing).
 * @param value the error of its value, or NULL
 * @return GRAZE_ESYSTEM */
graze_status tally_add(tally *t, graze_context *context, field name, char status,
                       const value_error *value);
/** Order the groups by name, numbers by value. */
void tally_sort(tally *t);
void tally_clear(tally *t);

/** Is a column an answer of tables of contact points (if `contacts`), or else of graze classify? */
int judged_of(column c, int contacts);

/** The words `in`, `on` and `out`, and their indices. */
extern const char *const pmc_words[3];
enum { PMC_IN, PMC_ON, PMC_OUT };

/** The most wrong rows of one stratum that are shown if the deepest ones come first. */
enum { MOST_OF_STRATUM = 2 };

/* A candidate's signed distance against the enclosure of the exact one. */

/** Position of a value relative to the enclosure of its row. */
typedef struct valuation {
    int certain; /* pmc is the same for every motion within the comparison's motion error */
    int judged;  /* the candidate's value is judged */
    value_error error;
    char decade[24]; /* the power of ten at or below the greater bound's size, with the sign of the
                        answer; 0: `on` */
} valuation;

/** Take over the options on values, and refuse tables that lack the columns for them.
 * @return GRAZE_EINPUT, GRAZE_ELIMIT */
graze_status values_choose(graze_comparison *c, const table *golden);

/**
 * Read the enclosure of a golden row, and judge the value of the candidate's row, if there is one.
 * @param pmc the golden answer
 * @return GRAZE_EINPUT columns that are no enclosure with the sign of the answer; GRAZE_ELIMIT
 */
graze_status valuation_read(valuation *out, const graze_comparison *c, const table *golden,
                            const table_row *row, const table *candidate, const table_row *given,
                            int pmc);

/* Counts and rows that every comparison keeps, of two tables or of a mesh. */

/** Fill a comparison that is all zero with options and names. 0 without memory; comparison_clear in
 * either case. */
int comparison_begin(graze_comparison *c, const graze_context *context, const char *golden,
                     const char *candidate, const graze_compare_options *options);

/** The judgement of a row. */
typedef struct judgement {
    int wrong[COLUMN_OPTIONS];
    int any_wrong;
    int wrong_as[CONVENTIONS]; /* any_wrong under each convention for `on` */
    int undecided; /* the golden answer is `on`, and the point may be interior to the closed sweep;
                      or the motion error leaves the answer undecided */
    int truth;     /* the golden pmc under the question asked */
} judgement;

/** Count a golden row; `answered` if the candidate has this row.
 * @return status of the row for tally_add */
char comparison_count(graze_comparison *c, const judgement *j, int answered);

/** Make room for one more disagreement, zeroed except `pmc`: the golden one of a wrong row, else
 * -1. *out is NULL if the disagreement is not to be shown, or on failure. GRAZE_ESYSTEM. */
graze_status comparison_keep(disagreement **out, graze_comparison *c, graze_context *context,
                             int pmc);

/** Measure the wrong rows in the scene of the options, if there is one, and keep the rows to show:
 * the deepest wrong rows, at most MOST_OF_STRATUM of a stratum, then rows missing or extra. Where
 * depths are not known, or a limit stops the measuring, rows stay in the order of the tables. */
graze_status comparison_finish(graze_comparison *c, graze_context *context);

/** GRAZE_ESYSTEM. */
graze_status comparison_no_memory(graze_context *context);

/* Times as tables of contact points have them: a number, or `root(c0 c1 ...;a;b)`. */

/** Examples of times, for messages. */
#define MOMENT_FORMS "1/2 or root(-1 0 2;0;1)"

/** Is a field a root: whole numbers with a blank between each two, at least three, and the two ends
 * of an interval? Equal roots are equal text (src/program/cli/formats.md, Contact points). */
int moment_is_root(field f);
/** Is a field a number token or a root? */
int moment_is_token(field f);

/* Tables of contact points: how they are recognised, and the judgement of their rows. */

/** Find out whether both tables have contact points.
 * @return GRAZE_EINPUT one table has contact points, the other answers of graze classify; a table
 * has a column of contact points twice */
graze_status sites_known(int *contacts, const table *golden, const table *candidate);

/** Choose the columns to judge: those that both tables have.
 * @return GRAZE_EINPUT there is no such column; an option is set that contact points do not have */
graze_status sites_choose(graze_comparison *c, const table *golden, const table *candidate);

/**
 * Judge a pair of rows; without a row of the candidate (NULL) the golden one is only read.
 * @param[out] wrong by column, 1 where the candidate has another answer or none
 * @return GRAZE_EINPUT a field is no answer; GRAZE_ELIMIT
 */
graze_status sites_judge(int *wrong, const graze_comparison *c, const table *golden,
                         const table_row *row, const table *candidate, const table_row *given);

#endif
