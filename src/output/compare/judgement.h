/* Texts and JSON of comparisons and of judged meshes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_OUTPUT_COMPARE_JUDGEMENT_H
#define GRAZE_OUTPUT_COMPARE_JUDGEMENT_H

#include "output/compare/counts.h"

/* The answers of a row, and the judgement of the candidate's. */

/** Names of the classes, in the order of the matrix. */
extern const char *const class_words[5];

/** Answers as indices into pmc_words and class_words; -1 where there is none. */
typedef struct answer {
    int pmc, class_;
    unsigned long i, t;
    field word;
} answer;

/** Fail with GRAZE_EINPUT because a field is no answer; `right` names the expected values. */
graze_status judged_no_answer(const table *t, const table_row *row, column c, const char *right);
/** Check that a word is one. GRAZE_EINPUT. */
graze_status judged_word(const table *t, const table_row *row);

/** Read the answers of a row: pmc always (or from the sign of `sdf`), the others where judged.
 * @return GRAZE_EINPUT a field that is no answer */
graze_status answer_read(answer *out, const table *t, const table_row *row, const int *judged,
                         int sdf);

/** Check the position (topo) of a golden `on` row, if the question is the closed sweep; the field
 * may be empty.
 * @return GRAZE_EINPUT a field that is no position */
graze_status judged_position(const graze_comparison *c, const table *golden, const table_row *row,
                             int pmc);

/** Judge an answer's pmc by the truth, under the convention `on_as`, and under each convention. */
void judge_pmc(judgement *j, graze_on_as on_as, int given);

/** Judge a pair of rows by these answers. */
judgement judge(const graze_comparison *c, const int *judged, const table *golden,
                const table_row *row, const answer *right, const answer *given,
                const valuation *value);

/* Rows in reports: how they were matched, shares, conventions for `on`, and how deep errors are. */

/** Quantiles of errors; the name is the share of errors in percent. Depths lack the last quantile.
 */
enum { QUANTILES = 4, DEPTH_QUANTILES = 3 };
extern const struct quantile {
    const char *name;
    unsigned long per_mille;
} quantiles[QUANTILES];
/** Further cells of a row of Markdown: the first quantiles, and the largest error. */
void put_quantiles(text *out, const errors *e, int count);
/** Write a ceiling as a string of JSON. */
void put_ceiling(json_writer *w, const char *name, ceiling c);
/** The first quantiles as an object of JSON, and the largest error. */
void put_json_quantiles(json_writer *w, const errors *e, int count);

/** Append part / whole with two digits, rounded to nearest by whole numbers alone, so that the text
 * does not depend on the locale. */
void put_share(text *out, unsigned long part, unsigned long whole);

/** Write a line on the columns by which points were matched; nothing for contact points. If rows
 * were matched by order alone, the line says how far their points are apart. */
void put_matched(text *out, const graze_comparison *c);

/** Write the share of wrong rows (unless rows are missing) and their number by column; the points
 * on a judged mesh; and, if the candidate never answers `on`, the wrong rows under each convention.
 */
void put_wrong_rows(text *out, const graze_comparison *c);

/** Write a table of |s| of the wrong rows by the golden answer; nothing if no distance was taken.
 */
void put_depths(text *out, const graze_comparison *c);

/** Write the matching, the depths and the conventions for `on` as members of a JSON object. */
void put_json_rows(json_writer *w, const graze_comparison *c);

/* The part of a comparison's report on contact points; empty for other tables. */
/** Write the columns by which rows are matched, and those that are not judged. */
void put_sites(text *out, const graze_comparison *c);
/** Write for each column how many rows of both tables agree. */
void put_sites_by_column(text *out, const graze_comparison *c);

/** Write the contents of put_sites as members of a JSON object; the errors by column are members of
 * every report. */
void put_json_sites(json_writer *w, const graze_comparison *c);

/* A comparison as text. */

/** A likely reason where many rows have no counterpart; NULL if nothing points to one. Static. */
const char *comparison_hint(const graze_comparison *c);

/** The command that explains a disagreement, malloc'ed; NULL when out of memory. */
char *explain_command(const graze_comparison *c, const disagreement *d);

/* Errors of values in reports. */

/** The number of groupings, the first ones, whose groups have errors of values in the report. */
enum { SHOWN_BY = BY_SDF + 1 };
/** "outside" or "pseudo". */
const char *truth_name(const graze_comparison *c);
/** The number of values inside their enclosures. */
unsigned long values_within(const errors *e);

#endif
