/* Searches over the times of a motion and the tree of a solid.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_TIME_SEARCH_H
#define GRAZE_DISTANCE_TIME_SEARCH_H

#include "questions/distance/nearest.h"

/** A place, put aside, and a window [from, to] of an arc. */
typedef struct pair_aside {
    place place;
    uint32_t arc;
    double from, to;
} pair_aside;

/** A time, the simplex nearest then and the distance. */
typedef struct time_sample {
    double time, high;
    uint32_t simplex;
} time_sample;

/** A window of a stretch of time, with samples at its ends and its middle: nothing is farther than
 * most. */
typedef struct window_aside {
    const struct stretch_of_time *of;
    time_sample sample[3];
    double most;
} window_aside;

/** The distance that is sought lies in [low, high]; the bound that the sought kind of search can
 * show at a time is met at `time` of the arc. */
typedef struct search {
    graze_context *context;
    const arc_maps *base;
    const double *point_low, *point_high;
    double tolerance;
    double low, high;
    size_t arc;
    double time;
    int met;                /* the greatest alone: there is such a time among doubles */
    size_t visits, counted; /* work so far, and what the context knows of it */
    double step;            /* what a round puts aside is so near to the bound that is met */
    place *list;            /* the least alone: nodes of windows under way, and what is put aside */
    size_t list_count, list_capacity;
    pair_aside *aside;
    size_t aside_count, aside_capacity;
    window_aside *window; /* the greatest alone: what is put aside */
    size_t window_count, window_capacity;
} search;

/** Begin: no bound is known. */
void search_begin(search *s, graze_context *context, const arc_maps *base, const double *low,
                  const double *high, double tolerance);
void search_end(search *s);

/** Work that one point may cost; beyond it the bounds that stand are taken. */
int search_is_over(const search *s);
/** Tell the context; GRAZE_ECANCELED. */
graze_status search_poll(search *s);
/** The failure of a search without memory. */
graze_status search_no_room(search *s);
/** Bounds of a window are not brought nearer to each other than this. */
double search_floor(const window *w);
/** 1 if bounds are as near to each other as was asked for: the only place that looks at that. */
int search_is_done(const search *s, double low, double high);

#endif
