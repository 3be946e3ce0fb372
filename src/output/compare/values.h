/* A candidate's signed distance against the enclosure of the exact one.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_VALUES_H
#define GRAZE_COMPARE_VALUES_H

#include "output/compare/comparison.h"

/** Position of a value relative to the enclosure of its row. */
typedef struct valuation {
    int certain; /* pmc is the same for every motion within the comparison's motion error */
    int judged;  /* the candidate's value is */
    value_error error;
    char decade[24]; /* the power of ten at or below the greater bound's size, with the sign of the
                        answer; 0: `on` */
} valuation;

/** Take over what the options ask of values, and refuse tables that cannot answer it.
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

#endif
