/* A priority queue of numbers, the one with the greatest bound first.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_JUDGE_PRIORITY_H
#define GRAZE_JUDGE_PRIORITY_H

#include <stdint.h>
#include "base/context/context.h"

typedef struct waiting_part {
    double bound;
    uint32_t number;
} waiting_part;

/** A queue; zeros are an empty one. Of equal bounds the lower number is first, so that the order is
 * always the same. */
typedef struct priority {
    size_t count, capacity;
    waiting_part *item;
} priority;

graze_status priority_add(priority *p, graze_context *context, double bound, uint32_t number);
/** Remove the first entry of a queue that is not empty. */
waiting_part priority_take(priority *p);
void priority_clear(priority *p);

#endif
