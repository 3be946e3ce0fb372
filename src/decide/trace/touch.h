/* Exact times at which a trajectory lies in boundary cells, on one piece of the motion.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_TOUCH_H
#define GRAZE_TRACE_TOUCH_H

#include "base/number/algebraic.h"
#include "decide/filter/curve.h"
#include "decide/trace/candidates.h"
#include "input/solid/known.h"

/**
 * The trajectory is in the relative interior of `cell` at the instant time[from] = time[to], or on
 * the whole open interval between the two.
 */
typedef struct touch {
    size_t from, to;
    graze_cell cell;
} touch;

/**
 * All touches of one piece. `from` and `to` number times in the order they were found; after
 * touches_order they are ranks, equal for equal times, and time.item[by_rank[r]] is a time of rank
 * r.
 */
typedef struct touches {
    algebraic_list time;
    size_t *by_rank;
    size_t count, capacity;
    touch *item;
} touches;

/** The curve of the trajectory in doubles, and the span that is its whole piece; and forms of the
 * solid that are known. */
typedef struct touch_filter {
    const curve *curve;
    const span *piece;
    form_memory *forms;
} touch_filter;

void touches_init(touches *t);
void touches_clear(touches *t);

/**
 * Find every touch of the candidates (proofs/claims.md C9: the events of a
 * simplex). The union of the closed intervals [from, to] is exactly the set of times at which the
 * trajectory is on the boundary.
 * @param quick the trajectory in doubles, which spares the sides that are certain, and a memory of
 * forms; or NULL
 */
graze_status touches_find(touches *t, graze_context *context, const graze_solid *solid,
                          const trajectory *c, const touch_filter *quick, const candidates *list);

/** Order the times exactly, then the touches by the rank of `from`. */
graze_status touches_order(touches *t, graze_context *context);

#endif
