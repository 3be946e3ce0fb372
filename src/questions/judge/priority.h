/* A queue of numbered things, the one with the greatest bound first.
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

/** Zeroed: empty. Equal bounds: the lower number first, so that runs do not differ. */
typedef struct priority {
    size_t count, capacity;
    waiting_part *item;
} priority;

graze_status priority_add(priority *p, graze_context *context, double bound, uint32_t number);
/** Take the first away; there is one. */
waiting_part priority_take(priority *p);
void priority_clear(priority *p);

#endif
