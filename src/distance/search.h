/* Searches over the times of a motion and the tree of a solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_SEARCH_H
#define GRAZE_DISTANCE_SEARCH_H

#include "distance/nearest.h"

/** The distance that is sought lies in [low, high]; the bound that the sought kind of search can
 * show at a time is met at `time` of the arc. */
typedef struct search {
    graze_context *context;
    const ground *base;
    const double *point_low, *point_high;
    double tolerance;
    double low, high;
    size_t arc;
    double time;
    int met;                /* the greatest alone: there is such a time among doubles */
    size_t visits, counted; /* work so far, and what the context knows of it */
    uint32_t *list;         /* the least alone: nodes of windows under way */
    size_t list_count, list_capacity;
} search;

/** Begin: no bound is known. */
void search_begin(search *s, graze_context *context, const ground *base, const double *low,
                  const double *high, double tolerance);
void search_end(search *s);

/** Work that one point may cost; beyond it the bounds that stand are taken. */
int search_is_over(const search *s);
/** Tell the context; GRAZE_ECANCELED. */
graze_status search_poll(search *s);
/** The tolerance that a path's rounding allows. */
double search_tolerance(const search *s, const window *w);

#endif
