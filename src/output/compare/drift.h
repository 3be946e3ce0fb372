/* How far the points of rows are apart that were matched by something else.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_COMPARE_DRIFT_H
#define GRAZE_COMPARE_DRIFT_H

#include <flint/fmpq.h>
#include "output/compare/key.h"

/** Differences of coordinates over the rows counted so far. Tables are borrowed. */
typedef struct drift {
    const table *golden, *candidate;
    row_key axes;             /* coordinates that both tables have */
    unsigned long rows;       /* whose points differ */
    fmpq_t farthest;          /* the greatest difference of a coordinate */
    fmpq_t least[3], most[3]; /* of the golden coordinates of rows that are written otherwise */
    int any;                  /* 1: there are such rows */
} drift;

void drift_init(drift *d, const table *golden, const table *candidate);
void drift_clear(drift *d);

/** Count two rows, after the rounding of the context. GRAZE_EINPUT, GRAZE_ELIMIT. */
graze_status drift_add(drift *d, const table_row *right, const table_row *given);

/** Can numbers that were rounded or printed explain the differences: are all at most 2^-10 of the
 * box of the golden points that differ, or 2^-20 of their size? Other points differ by more. */
int drift_is_small(const drift *d);

#endif
