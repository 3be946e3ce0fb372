/* The least distance: windows of time are searched with the nodes that may come nearer than s->high
 * in them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant (proofs/distance.md C71): every pair of a time and a place of the boundary is in a
 * window under way with a node on its list, or put aside with a bound, or no nearer than s->low; at
 * s->time the distance is at most s->high. Nothing but the end of the rounds depends on the
 * tolerance.
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/distance/time_search.h"

/* Windows of this length or less are not cut. */
static const double SHORTEST = 0x1p-48;

typedef struct look {
    search *s;
    const window *w;
    const stance *mid;
    stance *end;  /* room for two stances, at the window's ends */
    int has_ends; /* 1: these stances are made, 0: not needed so far, -1: beyond doubles */
    double floor, travel;
    int out_of_memory;
} look;

static double travel_of(const window *w) {
    int d = w->of->dimension;
    double most = 0;
    for (int k = 1; k <= w->degree; k++)
        for (int i = 0; i < d; i++)
            most = larger(most, fabs(w->x[i][k] / w->x[d][k] - w->x[i][0] / w->x[d][0]));
    return most;
}

static void keep_pair(look *l, const pair_aside *pair) {
    search *s = l->s;
    if (array_reserve(&s->aside, &s->aside_capacity, s->aside_count + 1, sizeof *s->aside))
        s->aside[s->aside_count++] = *pair;
    else
        l->out_of_memory = 1;
}

/* Drop a place with a bound of s->high - floor or more; else put it aside if its bound is s->high -
 * s->step or more. Returns 0 if the place is still to be searched. */
static int leave_out(look *l, const place *p) {
    search *s = l->s;
    if (p->low >= s->high - l->floor) {
        s->low = smaller(s->low, p->low);
        return 1;
    }
    if (!(p->low >= s->high - s->step))
        return 0;
    keep_pair(l, &(pair_aside){*p, (uint32_t)l->w->of->arc, l->w->from, l->w->to});
    return 1;
}

static int is_large(const look *l, const tree_node *node) {
    return node->child && box_extent(&node->box) > l->travel;
}

static void keep_place(look *l, const place *p) {
    search *s = l->s;
    if (array_reserve(&s->list, &s->list_capacity, s->list_count + 1, sizeof *s->list))
        s->list[s->list_count++] = *p;
    else
        l->out_of_memory = 1;
}

/* Bound the distance to a simplex by its places that are nearest at the window's ends. */
static double low_about(look *l, const double *corner) {
    const point_arc *p = l->w->of;
    foot first, last;
    if (!l->has_ends)
        l->has_ends =
            stance_make(&l->end[0], p, l->w->from) && stance_make(&l->end[1], p, l->w->to) ? 1 : -1;
    if (l->has_ends < 0)
        return 0;
    foot_find(&first, &l->end[0], corner);
    foot_find(&last, &l->end[1], corner);
    return gap_about(l->w, first.q, last.q, corner, p->dimension);
}

static double simplex_low(look *l, uint32_t simplex) {
    int d = l->mid->dimension;
    const double *corner = l->s->base->scene->solid->corners.at + (size_t)simplex * d * d;
    foot f;
    foot_find(&f, l->mid, corner);
    double low = gap_along(l->w, f.m, gap_corners(f.m, corner, d, d));
    if (!(low >= l->s->high - larger(l->s->step, l->floor)) && !f.inner)
        low = larger(low, low_about(l, corner));
    return low;
}

static void ask_node(look *l, place here);

/* Keep a bounded place for shorter windows or, if it is large, ask its two children. */
static void enter_node(look *l, const place *p) {
    const tree_node *node = &l->s->base->scene->solid->boxes.node[p->node];
    if (is_large(l, node)) {
        ask_node(l, (place){node->child, PLACE_SEEN, p->low});
        ask_node(l, (place){node->child + 1, PLACE_SEEN, p->low});
    } else {
        keep_place(l, &(place){p->node, PLACE_NEW, p->low});
    }
}

/* Bound a place, which is no nearer than the larger place that contains it. */
static void ask_node(look *l, place here) {
    const tree_node *node = &l->s->base->scene->solid->boxes.node[here.node];
    double g[3], low;
    if (leave_out(l, &here))
        return;
    if (here.state < PLACE_BOUNDED) {
        l->s->visits++;
        if (node->child) {
            foot_of_box(g, l->mid, &node->box);
            low = gap_along(l->w, g, gap_box(g, &node->box));
        } else {
            low = simplex_low(l, node->simplex);
        }
        here.low = larger(low, here.low);
        here.state = is_large(l, node) ? PLACE_BOUNDED : PLACE_SMALL;
        if (leave_out(l, &here))
            return;
    }
    enter_node(l, &here);
}

/* Find the distance at the middle of the window, and keep it if it is less than s->high. Returns 1
 * if the window's left end is nearer to the place found than its right end, or none is found. */
static int ask_middle(search *s, const window *w, const stance *mid, double time, size_t first,
                      size_t count) {
    nearest found;
    foot f;
    int d = mid->dimension, n = w->degree;
    nearest_boundary(&found, mid, s->list + first, count, s->high, &s->visits);
    if (!found.found)
        return 1;
    if (found.high < s->high) {
        s->high = found.high;
        s->arc = w->of->arc;
        s->time = time;
    }
    foot_find(&f, mid, s->base->scene->solid->corners.at + (size_t)found.simplex * d * d);
    double left = 0, right = 0;
    for (int i = 0; i < d; i++) {
        double a = w->x[i][0] / w->x[d][0] - f.q[i], b = w->x[i][n] / w->x[d][n] - f.q[i];
        left += a * a;
        right += b * b;
    }
    return left <= right;
}

static graze_status explore_least(search *s, const point_arc *p, double from, double to,
                                  size_t first, size_t count);

static graze_status explore_halves(search *s, const point_arc *p, double from, double to,
                                   size_t first, int left_first) {
    double middle = from + (to - from) / 2;
    size_t count = s->list_count - first;
    for (int half = 0; half < 2; half++) {
        int left = (half == 0) == left_first;
        TRY(explore_least(s, p, left ? from : middle, left ? middle : to, first, count));
    }
    return GRAZE_OK;
}

/* Bound the places of a list over a window; the places to be searched further are appended to the
 * list. */
static graze_status bound_list(search *s, const point_arc *p, double from, double to, size_t first,
                               size_t count, int *left_first) {
    window w;
    stance mid, end[2];
    double time = from + (to - from) / 2;
    int made = window_make(&w, p, from, to) && stance_make(&mid, p, time);
    look l = {.s = s, .w = &w, .mid = &mid, .end = end};
    if (made) {
        l.floor = search_floor(&w);
        l.travel = travel_of(&w);
        if (s->list[first].state == PLACE_NEW)
            *left_first = ask_middle(s, &w, &mid, time, first, count);
    }
    for (size_t k = first; k < first + count; k++) {
        place here = s->list[k];
        if (made && here.state == PLACE_NEW)
            here.state = PLACE_SEEN;
        if (made)
            ask_node(&l, here);
        else /* a weight may vanish on the window: keep all places, so that it is cut */
            keep_place(&l, &here);
    }
    s->visits += made ? 0 : 1 + count;
    if (l.out_of_memory)
        return search_no_room(s);
    return search_poll(s);
}

/* Go on in the halves of a window with the places from `first` to the end of the list. */
static graze_status cut_least(search *s, const point_arc *p, double from, double to, size_t first,
                              int left_first) {
    if (s->list_count > first && to - from > SHORTEST && !search_is_over(s))
        return explore_halves(s, p, from, to, first, left_first);
    for (size_t k = first; k < s->list_count; k++)
        s->low = smaller(s->low, s->list[k].low);
    return GRAZE_OK;
}

static graze_status explore_least(search *s, const point_arc *p, double from, double to,
                                  size_t first, size_t count) {
    size_t mine = s->list_count;
    int left_first = 1;
    TRY(bound_list(s, p, from, to, first, count, &left_first));
    TRY(cut_least(s, p, from, to, mine, left_first));
    s->list_count = mine;
    return GRAZE_OK;
}

/* Go on with those pairs of one window that the round asks for; of the others, those below s->high
 * stay aside. */
static graze_status resume_window(search *s, const pair_aside *pair, size_t count) {
    size_t mine = s->list_count;
    int small = 1;
    look l = {.s = s};
    point_arc p;
    for (size_t k = 0; k < count; k++) {
        const place *here = &pair[k].place;
        if (!(here->low >= s->high - s->step)) {
            keep_place(&l, here);
            small = small && here->state == PLACE_SMALL;
        } else if (here->low < s->high) {
            keep_pair(&l, &pair[k]);
        }
    }
    if (l.out_of_memory)
        return search_no_room(s);
    if (s->list_count == mine)
        return GRAZE_OK;
    TRY(point_arc_make(&p, s->context, s->base, pair->arc, s->point_low, s->point_high));
    for (size_t k = mine; k < s->list_count && small; k++)
        s->list[k].state = PLACE_NEW; /* not looked at in the halves */
    TRY(small ? cut_least(s, &p, pair->from, pair->to, mine, 1)
              : explore_least(s, &p, pair->from, pair->to, mine, s->list_count - mine));
    s->list_count = mine;
    return GRAZE_OK;
}

static int same_window(const pair_aside *a, const pair_aside *b) {
    return a->arc == b->arc && a->from == b->from && a->to == b->to;
}

/* Do one round: go on with those pairs put aside whose bound is below s->high - s->step; of the
 * others, those below s->high stay aside. */
static graze_status least_round(search *s) {
    FREED(pair_aside, was, s->aside);
    size_t count = s->aside_count;
    s->aside = NULL;
    s->aside_count = s->aside_capacity = 0;
    for (size_t k = 0, end; k < count; k = end) {
        for (end = k + 1; end < count && same_window(&was[k], &was[end]);)
            end++;
        TRY(resume_window(s, was + k, end - k));
    }
    return GRAZE_OK;
}

static double least_aside(const search *s) {
    double low = INFINITY;
    for (size_t k = 0; k < s->aside_count; k++)
        low = smaller(low, s->aside[k].place.low);
    return low;
}

graze_status search_least(search *s) {
    TRY(least_begin(s));
    double low = least_aside(s);
    while (s->aside_count > 0 && !search_is_done(s, low, s->high) && !search_is_over(s)) {
        s->step = (s->high - low) / 2;
        TRY(least_round(s));
        low = least_aside(s);
    }
    s->low = smaller(smaller(s->low, low), s->high);
    return GRAZE_OK;
}
