/* Tables of contact points: which they are, and the judgement of their rows.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_SITES_H
#define GRAZE_COMPARE_SITES_H

#include "output/compare/comparison.h"

/** Find out whether both tables have contact points.
 * @return GRAZE_EINPUT one of them does, the other has answers of graze classify; a column of
 * contact points stands twice */
graze_status sites_known(int *contacts, const table *golden, const table *candidate);

/** Choose the columns to judge: those that both tables have.
 * @return GRAZE_EINPUT there is none; an option is asked for that contact points do not have */
graze_status sites_choose(graze_comparison *c, const table *golden, const table *candidate);

/**
 * Judge a pair of rows; without a row of the candidate (NULL) the golden one is only read.
 * @param[out] wrong JUDGED_COUNT numbers, 1 where the candidate's answer is another or none
 * @return GRAZE_EINPUT a field is no answer; GRAZE_ELIMIT
 */
graze_status sites_judge(int *wrong, const graze_comparison *c, const table *golden,
                         const table_row *row, const table *candidate, const table_row *given);

#endif
