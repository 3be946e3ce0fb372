/* The greatest distance to the boundary over the visits of the trajectory to a state.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant (proofs/distance.md C72): at every time of the stretches that is in no window under way
 * or put aside, the distance is at most s->high; at s->time the distance is at least s->low.
 * Nothing but the end of the rounds depends on the tolerance.
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/distance/time_search.h"

static const double SHORTEST = 0x1p-50;

static const double *corners_of(const search *s, uint32_t simplex) {
    int d = s->base->scene->motion->dimension;
    return s->base->scene->solid->corners.at + (size_t)simplex * d * d;
}

/* Find the distance to the boundary at a time; simplices nearest at other times, in `hint`, limit
 * the search. Returns 0 if no stance can be made in doubles. */
static int take_sample(time_sample *out, search *s, const stretch_of_time *of, const point_arc *p,
                       double time, const time_sample *hint, int hints) {
    stance at;
    nearest found;
    foot f;
    const place root = {0};
    out->time = time;
    out->high = INFINITY;
    out->simplex = 0;
    if (!stance_make(&at, p, time))
        return 0;
    for (int k = 0; k < hints; k++) {
        foot_find(&f, &at, corners_of(s, hint[k].simplex));
        double high = gap_most(&at.at, f.q, f.q);
        if (high < out->high) {
            out->high = high;
            out->simplex = hint[k].simplex;
        }
    }
    nearest_boundary(&found, &at, &root, 1, out->high, &s->visits);
    if (found.found && found.high < out->high) {
        out->high = found.high;
        out->simplex = found.simplex;
    }
    int sure = time >= of->sure_from && time <= of->sure_to;
    if (sure && (!s->met || found.low > s->low)) {
        s->met = 1;
        s->low = found.low;
        s->arc = of->arc;
        s->time = time;
    }
    return 1;
}

/* An upper bound of the distance during the window; sets `floor` to search_floor of the window. */
static double window_most(double *floor, search *s, const point_arc *p,
                          const time_sample *sample_of) {
    window w;
    stance first, last;
    double most = INFINITY;
    double from = sample_of[0].time, to = sample_of[2].time;
    if (!window_make(&w, p, from, to) || !stance_make(&first, p, from) ||
        !stance_make(&last, p, to))
        return most;
    *floor = search_floor(&w);
    for (int k = 0; k < 3; k++) {
        foot a, b;
        s->visits++;
        foot_find(&a, &first, corners_of(s, sample_of[k].simplex));
        foot_find(&b, &last, corners_of(s, sample_of[k].simplex));
        most = smaller(most, gap_most(&w, a.q, b.q));
    }
    return most;
}

static graze_status put_aside(search *s, const window_aside *window) {
    TRY(ARRAY_GROW(s->context, s->window, s->window_capacity, s->window_count + 1, "a distance"));
    s->window[s->window_count++] = *window;
    return GRAZE_OK;
}

static graze_status explore_greatest(search *s, const stretch_of_time *of, const point_arc *p,
                                     const time_sample *first, const time_sample *last,
                                     double known);

/* Go on in the halves of a window between its first and last sample. */
static graze_status cut_greatest(search *s, const stretch_of_time *of, const point_arc *p,
                                 const time_sample *three, double most) {
    if (three[2].time - three[0].time <= SHORTEST || search_is_over(s)) {
        s->high = larger(s->high, most);
        return GRAZE_OK;
    }
    int right_first = three[0].high < three[2].high;
    for (int half = 0; half < 2; half++) {
        const time_sample *at = &three[half == right_first ? 0 : 1];
        TRY(explore_greatest(s, of, p, &at[0], &at[1], most));
    }
    return GRAZE_OK;
}

/* Bound a window; `known` is the bound of the window that it is a half of. */
static graze_status explore_greatest(search *s, const stretch_of_time *of, const point_arc *p,
                                     const time_sample *first, const time_sample *last,
                                     double known) {
    window_aside here = {of, {*first, *first, *last}, known};
    const time_sample ends[2] = {*first, *last};
    double middle = first->time + (last->time - first->time) / 2, floor = 0;
    if (take_sample(&here.sample[1], s, of, p, middle, ends, 2))
        here.most = smaller(known, window_most(&floor, s, p, here.sample));
    TRY(search_poll(s));
    if (here.most <= s->low + floor) {
        s->high = larger(s->high, here.most);
        return GRAZE_OK;
    }
    if (here.most < INFINITY && here.most <= s->low + s->step)
        return put_aside(s, &here);
    return cut_greatest(s, of, p, here.sample, here.most);
}

static graze_status begin_stretch(search *s, const stretch_of_time *of) {
    point_arc p;
    time_sample first, last;
    TRY(point_arc_make(&p, s->context, s->base, of->arc, s->point_low, s->point_high));
    (void)take_sample(&first, s, of, &p, of->from, NULL, 0);
    (void)take_sample(&last, s, of, &p, of->to, &first, 1);
    return explore_greatest(s, of, &p, &first, &last, INFINITY);
}

/* Do one round: cut those windows put aside whose bound exceeds s->low by more than s->step. */
static graze_status greatest_round(search *s) {
    FREED(window_aside, was, s->window);
    size_t count = s->window_count;
    s->window = NULL;
    s->window_count = s->window_capacity = 0;
    for (size_t k = 0; k < count; k++) {
        point_arc p;
        const stretch_of_time *of = was[k].of;
        if (was[k].most <= s->low + s->step) {
            TRY(put_aside(s, &was[k]));
            continue;
        }
        TRY(point_arc_make(&p, s->context, s->base, of->arc, s->point_low, s->point_high));
        TRY(cut_greatest(s, of, &p, was[k].sample, was[k].most));
    }
    return GRAZE_OK;
}

static double most_aside(const search *s) {
    double most = 0;
    for (size_t k = 0; k < s->window_count; k++)
        most = larger(most, s->window[k].most);
    return most;
}

graze_status search_greatest(search *s, const stretch_of_time *stretch, size_t count) {
    s->low = s->high = 0;
    s->step = INFINITY;
    for (size_t k = 0; k < count; k++)
        TRY(begin_stretch(s, &stretch[k]));
    double most = most_aside(s);
    while (most > s->low && !search_is_done(s, s->low, most) && !search_is_over(s)) {
        s->step = (most - s->low) / 2;
        TRY(greatest_round(s));
        most = most_aside(s);
    }
    s->high = larger(larger(s->high, most), s->low);
    return GRAZE_OK;
}
