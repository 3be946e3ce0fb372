/* The answers of a row, and the judgement of the candidate's.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_JUDGEMENT_H
#define GRAZE_COMPARE_JUDGEMENT_H

#include "output/compare/values.h"

/** Names of the judged answers, and of their values in the matrices. */
const char *judged_name(int judged);
extern const char *const class_words[5];

/** Answers as indices into pmc_words and class_words; -1 where there is none. */
typedef struct answer {
    int pmc, class_;
    unsigned long i, t;
    field word;
} answer;

typedef struct judgement {
    int wrong[JUDGED_COUNT];
    int any_wrong;
    int wrong_as[CONVENTIONS]; /* any_wrong under each convention for `on` */
    int undecided; /* the golden answer is `on`, and the closed sweep may hold the point inside; or
                      the motion error leaves it undecided */
    int truth;     /* the golden pmc under the question asked */
} judgement;

/** The column with this index among those judged. */
column judged_column(int judged);

/** GRAZE_EINPUT: a field is no answer; `right` says what is expected. */
graze_status judged_no_answer(const table *t, const table_row *row, column c, const char *right);
/** Check that a word is one. GRAZE_EINPUT. */
graze_status judged_word(const table *t, const table_row *row);

/** Read the answers of a row: pmc always (or from the sign of `sdf`), the others where judged.
 * @return GRAZE_EINPUT a field that is no answer */
graze_status answer_read(answer *out, const table *t, const table_row *row, const int *judged,
                         int sdf);

/** Check the position of a golden `on` row, which the closed question asks for; it may be empty.
 * @return GRAZE_EINPUT a field that is none */
graze_status judged_position(const graze_comparison *c, const table *golden, const table_row *row,
                             int pmc);

/** Judge an answer's pmc beside the truth, under a convention and under each. */
void judge_pmc(judgement *j, graze_on_as on_as, int given);

/** Judge a pair of rows by these answers. */
judgement judge(const graze_comparison *c, const int *judged, const table *golden,
                const table_row *row, const answer *right, const answer *given,
                const valuation *value);

#endif
