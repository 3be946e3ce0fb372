/* The least distance: windows of time with the nodes that may come nearer than is known.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Invariant (proofs/distance.md C71): every pair of a time and a place of the boundary is in a
 * window under way with a node on its list, or no nearer than s->low; s->high is reached.
 */
#include "distance/least.h"

#include <math.h>
#include <stdlib.h>
#include "context/array.h"
#include "distance/along.h"
#include "distance/gap.h"
#include "filter/normal.h"

/* Shorter windows are not cut. */
static const double SHORTEST = 0x1p-48;

typedef struct look {
    search *s;
    const window *w;
    const stance *mid;
    stance *end;  /* two, at the window's ends, */
    int has_ends; /* 1: made, 0: not needed so far, -1: beyond doubles */
    double tolerance, travel;
    double kept_low; /* least bound of what is kept */
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

/* Drop a node whose bound is good enough; 0 if it is not. */
static int leave_out(look *l, double low) {
    if (!(low >= l->s->high - l->tolerance))
        return 0;
    l->s->low = smaller(l->s->low, low);
    return 1;
}

static void keep_node(look *l, uint32_t node, double low) {
    search *s = l->s;
    l->kept_low = smaller(l->kept_low, low);
    if (array_reserve(&s->list, &s->list_capacity, s->list_count + 1, sizeof *s->list))
        s->list[s->list_count++] = node;
    else
        l->out_of_memory = 1;
}

/* The bound from the places nearest at the window's ends. */
static double low_about(look *l, const double *corner) {
    const path *p = l->w->of;
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
    if (!(low >= l->s->high - l->tolerance) && !f.inner)
        low = larger(low, low_about(l, corner));
    return low;
}

/* Bound a node; what stays is kept, or its children are asked if it is larger than the window. */
static void ask_node(look *l, uint32_t node) {
    const tree_node *here = &l->s->base->scene->solid->boxes.node[node];
    double g[3], low;
    l->s->visits++;
    if (here->child) {
        foot_of_box(g, l->mid, &here->box);
        low = gap_along(l->w, g, gap_box(g, &here->box));
    } else {
        low = simplex_low(l, here->simplex);
    }
    if (leave_out(l, low))
        return;
    if (here->child && box_extent(&here->box) > l->travel) {
        ask_node(l, here->child);
        ask_node(l, here->child + 1);
    } else {
        keep_node(l, node, low);
    }
}

/* Ask the boundary at the middle of the window; a smaller distance is remembered. Returns whether
 * the left half is nearer to what is found. */
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

static graze_status explore_least(search *s, const path *p, double from, double to, size_t first,
                                  size_t count);

static graze_status explore_halves(search *s, const path *p, double from, double to, size_t first,
                                   int left_first) {
    double middle = from + (to - from) / 2;
    size_t count = s->list_count - first;
    for (int half = 0; half < 2; half++) {
        int left = (half == 0) == left_first;
        graze_status status =
            explore_least(s, p, left ? from : middle, left ? middle : to, first, count);
        if (status)
            return status;
    }
    return GRAZE_OK;
}

/* Bound the nodes of a list over a window; those that are not good enough stand at the end of the
 * list. */
static graze_status bound_list(search *s, const path *p, double from, double to, size_t first,
                               size_t count, int *left_first, double *kept_low) {
    window w;
    stance mid, end[2];
    double time = from + (to - from) / 2;
    if (!window_make(&w, p, from, to) || !stance_make(&mid, p, time)) {
        *kept_low = 0; /* a weight that may vanish on the window: cut it */
        for (size_t k = 0; k < count; k++) {
            if (!array_reserve(&s->list, &s->list_capacity, s->list_count + 1, sizeof *s->list))
                return context_fail(s->context, GRAZE_ESYSTEM, "out of memory for a distance");
            s->list[s->list_count++] = s->list[first + k];
        }
        s->visits += 1 + count;
        return search_poll(s);
    }
    look l = {.s = s,
              .w = &w,
              .mid = &mid,
              .end = end,
              .tolerance = search_tolerance(s, &w),
              .travel = travel_of(&w),
              .kept_low = INFINITY};
    *left_first = ask_middle(s, &w, &mid, time, first, count);
    for (size_t k = 0; k < count; k++)
        ask_node(&l, s->list[first + k]);
    *kept_low = l.kept_low;
    if (l.out_of_memory)
        return context_fail(s->context, GRAZE_ESYSTEM, "out of memory for a distance");
    return search_poll(s);
}

static graze_status explore_least(search *s, const path *p, double from, double to, size_t first,
                                  size_t count) {
    size_t mine = s->list_count;
    int left_first = 1;
    double kept_low = INFINITY;
    graze_status status = bound_list(s, p, from, to, first, count, &left_first, &kept_low);
    if (!status && s->list_count > mine) {
        if (to - from <= SHORTEST || search_is_over(s))
            s->low = smaller(s->low, kept_low);
        else
            status = explore_halves(s, p, from, to, mine, left_first);
    }
    s->list_count = mine;
    return status;
}

typedef struct arc_bound {
    double low;
    size_t arc;
} arc_bound;

static int compare_bounds(const void *left, const void *right) {
    const arc_bound *a = left, *b = right;
    return a->low < b->low ? -1 : a->low > b->low ? 1 : a->arc < b->arc ? -1 : 1;
}

/* What the solid's box says about a whole arc. */
static graze_status bound_arc(arc_bound *out, search *s, size_t index) {
    path p;
    window w;
    stance mid;
    double g[3];
    const box *root = &s->base->scene->solid->boxes.node[0].box;
    out->arc = index;
    out->low = 0;
    graze_status status = path_make(&p, s->context, s->base, index, s->point_low, s->point_high);
    if (status || !window_make(&w, &p, 0, 1) || !stance_make(&mid, &p, 0.5))
        return status;
    foot_of_box(g, &mid, root);
    out->low = gap_along(&w, g, gap_box(g, root));
    return status;
}

static graze_status explore_arcs(search *s, arc_bound *bound, size_t count) {
    graze_status status = GRAZE_OK;
    for (size_t k = 0; k < count && !status; k++)
        status = bound_arc(&bound[k], s, k);
    if (status)
        return status;
    qsort(bound, count, sizeof *bound, compare_bounds);
    for (size_t k = 0; k < count && !status; k++) {
        path p;
        if (bound[k].low >= s->high) {
            s->low = smaller(s->low, bound[k].low);
            break;
        }
        status = path_make(&p, s->context, s->base, bound[k].arc, s->point_low, s->point_high);
        if (!status)
            status = explore_least(s, &p, 0, 1, 0, 1);
    }
    return status;
}

graze_status search_least(search *s) {
    size_t count = s->base->arc_count;
    arc_bound *bound = malloc(count * sizeof *bound);
    s->low = s->high = INFINITY;
    s->list_count = 0;
    int room = array_reserve(&s->list, &s->list_capacity, 1, sizeof *s->list);
    if (!bound || !room) {
        free(bound);
        return context_fail(s->context, GRAZE_ESYSTEM, "out of memory for a distance");
    }
    s->list[s->list_count++] = 0;
    graze_status status = explore_arcs(s, bound, count);
    s->low = smaller(s->low, s->high);
    free(bound);
    return status;
}
