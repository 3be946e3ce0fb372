/* The search of the time at which the moving place is nearest.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_QUESTIONS_DISTANCE_TIME_SEARCH_H
#define GRAZE_QUESTIONS_DISTANCE_TIME_SEARCH_H

#include "questions/distance/distance.h"

/* Bounds of the distance to convex sets along a covector (proofs/distance.md C69). */

/** A lower bound of the distance to all places of a convex set during the window, measured along
 * the covector m. 0 if m proves no bound.
 * @param m 3 numbers in the solid's space, any
 * @param most at least m . v for all places v of the set, but for the stray
 */
double gap_along(const window *w, const double *m, double most);

/** The greatest m . v of a box, or of `count` corners of d coordinates. */
double gap_box(const double *m, const box *b);
double gap_corners(const double *m, const double *corner, int count, int dimension);

/** Make the stance at a time v of the arc; returns 0 if a weight is not certainly positive. */
int stance_make(stance *out, const point_arc *of, double time);

/* The distance of the query point to the boundary at one instant. */

/** low <= d <= high for the distance d, at the instant, to the simplices below the nodes asked. */
typedef struct nearest {
    double low, high;
    uint32_t simplex; /* a simplex whose distance is at most high, if `found` */
    int found;
} nearest;

/** Search below some nodes of the solid's tree, leaving out nodes that are certainly not nearer
 * than `limit`: if all are, high is infinite and nothing is found.
 * @param visits counts the boxes and simplices asked
 */
void nearest_boundary(nearest *out, const stance *s, const place *list, size_t count, double limit,
                      size_t *visits);

/* Searches over the times of a motion and the tree of a solid. */

/** A place and a window [from, to] of an arc, put aside for a later round. */
typedef struct pair_aside {
    place place;
    uint32_t arc;
    double from, to;
} pair_aside;

/** A time, the simplex that is nearest then, and its distance or more. */
typedef struct time_sample {
    double time, high;
    uint32_t simplex;
} time_sample;

/** A window of a stretch of time, with samples at its ends and its middle: at none of its times is
 * the distance greater than `most`. */
typedef struct window_aside {
    const struct stretch_of_time *of;
    time_sample sample[3];
    double most;
} window_aside;

/** The sought distance lies in [low, high]. At `time` of the arc `arc` the distance to the boundary
 * is at most `high` if the least distance is sought, at least `low` if the greatest is. */
typedef struct search {
    graze_context *context;
    const arc_maps *base;
    const double *point_low, *point_high;
    double tolerance;
    double low, high;
    size_t arc;
    double time;
    int met;                /* greatest distance only, 1: `time` is set */
    size_t visits, counted; /* work so far, and the part of it reported to the context */
    double step; /* a round puts aside pairs and windows whose bound is within this of the bound met
                    at `time` */
    place *list; /* least distance only: places of the windows under way, and in `aside` the pairs
                    put aside */
    size_t list_count, list_capacity;
    pair_aside *aside;
    size_t aside_count, aside_capacity;
    window_aside *window; /* greatest distance only: windows put aside */
    size_t window_count, window_capacity;
} search;

/** Begin: no bound is known. */
void search_begin(search *s, graze_context *context, const arc_maps *base, const double *low,
                  const double *high, double tolerance);
void search_end(search *s);

/** Has the search done the work that one point may cost? If so, the bounds found so far are taken.
 */
int search_is_over(const search *s);
/** Report the work since the last call to the context. @return GRAZE_ECANCELED */
graze_status search_poll(search *s);
/** Fail with GRAZE_ESYSTEM, as memory has run out. */
graze_status search_no_room(search *s);
/** Bounds of a window are not brought nearer to each other than this. */
double search_floor(const window *w);
/** 1 if two bounds are as near to each other as was asked for; only this function tests that. */
int search_is_done(const search *s, double low, double high);

/* The greatest distance to the boundary over stretches of time (proofs/distance.md C72). */

/** A stretch [from, to] of one arc. Its times [sure_from, sure_to] certainly belong to a visit to
 * the wanted state, I or, for an unsweep, O; no time is certain if sure_from > sure_to. */
typedef struct stretch_of_time {
    size_t arc;
    double from, to, sure_from, sure_to;
} stretch_of_time;

/** @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status search_greatest(search *s, const stretch_of_time *stretch, size_t count);

/* The least distance to the boundary over the whole motion (proofs/distance.md C71). */

/** @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM */
graze_status search_least(search *s);

/* The pairs of a time and a place that the search for the least distance begins with. */

/** Put aside the pairs with which a search begins, each with a bound, the nearest first: whole
 * arcs with the whole boundary; of many arcs only those that are nearer than a distance that is
 * reached.
 * @return GRAZE_ELIMIT, GRAZE_ESYSTEM
 */
graze_status least_begin(search *s);

#endif
