/* The point of some convex sets that is nearest to a given one, found set by set.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_NEARBY_H
#define GRAZE_CONTACT_NEARBY_H

#include <flint/fmpq.h>

/** The nearest point so far; of two equally near the lexicographically first. `from` is borrowed.
 */
typedef struct nearby {
    int dimension, found;
    const fmpq *from;
    fmpq *point;
    fmpq_t square; /* of the distance */
} nearby;

void nearby_init(nearby *n, const fmpq *from, int dimension);
void nearby_clear(nearby *n);

/** Take a point if it is nearer, or as near and lexicographically before. */
void nearby_try(nearby *n, const fmpq *point);

/** Take the point of the segment from a to b that is nearest to `from`; a may be b. */
void nearby_try_segment(nearby *n, const fmpq *a, const fmpq *b);

#endif
