/* A distance reached in the arc that seems nearest rules out most of many arcs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/distance/time_search.h"

static int compare_pairs(const void *left, const void *right) {
    const pair_aside *a = left, *b = right;
    double x = a->place.low, y = b->place.low;
    return x < y ? -1 : x > y ? 1 : a->arc < b->arc ? -1 : 1;
}

/* Bound the distance over an arc by the solid's box. */
static graze_status bound_arc(pair_aside *out, search *s, size_t index) {
    point_arc p;
    window w;
    stance mid;
    double g[3];
    const box *root = &s->base->scene->solid->boxes.node[0].box;
    *out = (pair_aside){.to = 1, .arc = (uint32_t)index};
    TRY(point_arc_make(&p, s->context, s->base, index, s->point_low, s->point_high));
    if (!window_make(&w, &p, 0, 1) || !stance_make(&mid, &p, 0.5))
        return GRAZE_OK;
    foot_of_box(g, &mid, root);
    out->place.low = gap_along(&w, g, gap_box(g, root));
    return GRAZE_OK;
}

/* Put aside all arcs, each with the whole boundary, the nearest first. */
static graze_status begin_whole(search *s) {
    size_t count = s->base->arc_count;
    if (!array_reserve(&s->aside, &s->aside_capacity, count, sizeof *s->aside))
        return search_no_room(s);
    for (size_t k = 0; k < count; k++)
        TRY(bound_arc(&s->aside[k], s, k));
    s->aside_count = count;
    qsort(s->aside, count, sizeof *s->aside, compare_pairs);
    return GRAZE_OK;
}

static double node_low(const search *s, const arc_node *n) {
    return arc_node_distance(n, s->point_low, s->point_high, s->base->scene->motion->dimension);
}

/* The arc that a descent by the nearer child at each node leads to. */
static size_t nearest_arc(const search *s, const arc_tree *t) {
    const arc_node *here = t->node;
    while (here->child) {
        const arc_node *first = t->node + here->child, *second = first + 1;
        here = node_low(s, first) <= node_low(s, second) ? first : second;
    }
    return here->first;
}

/* Find the distance at the middle of an arc, and keep it if it is below s->high. */
static graze_status reach_arc(search *s, size_t index) {
    point_arc path;
    stance at;
    nearest found = {.found = 0};
    const place root = {0};
    const double time = 0.5;
    TRY(point_arc_make(&path, s->context, s->base, index, s->point_low, s->point_high));
    if (stance_make(&at, &path, time))
        nearest_boundary(&found, &at, &root, 1, s->high, &s->visits);
    if (found.found && found.high < s->high) {
        s->high = found.high;
        s->arc = index;
        s->time = time;
    }
    return GRAZE_OK;
}

/* Put aside the arcs below a node whose boxes are nearer than s->high. */
static graze_status add_arcs(search *s, const arc_tree *t, const arc_node *n) {
    double low = node_low(s, n);
    if (low >= s->high)
        return GRAZE_OK;
    if (n->child) {
        TRY(add_arcs(s, t, t->node + n->child));
        return add_arcs(s, t, t->node + n->child + 1);
    }
    if (!array_reserve(&s->aside, &s->aside_capacity, s->aside_count + 1, sizeof *s->aside))
        return search_no_room(s);
    pair_aside *pair = &s->aside[s->aside_count++];
    *pair = (pair_aside){.place.low = low, .arc = n->first, .to = 1};
    /* Until the arc is bounded, `from` has the squared distance of its box's middle. */
    for (int i = 0; i < s->base->scene->motion->dimension; i++) {
        double off = n->world.low[i] / 2 + n->world.high[i] / 2 - s->point_low[i];
        pair->from += off * off;
    }
    return GRAZE_OK;
}

/* Find the distance at the middle of the arc put aside whose box's middle is nearest. */
static graze_status reach_aside(search *s) {
    size_t best = 0;
    for (size_t k = 1; k < s->aside_count; k++)
        if (s->aside[k].from < s->aside[best].from)
            best = k;
    return s->aside_count ? reach_arc(s, s->aside[best].arc) : GRAZE_OK;
}

/* Bound the arcs put aside that may be nearer than s->high; drop the others. */
static graze_status bound_aside(search *s) {
    size_t kept = 0;
    for (size_t k = 0; k < s->aside_count; k++) {
        double low = s->aside[k].place.low;
        if (low >= s->high)
            continue;
        TRY(bound_arc(&s->aside[kept], s, s->aside[k].arc));
        s->aside[kept].place.low = larger(low, s->aside[kept].place.low);
        kept++;
    }
    s->aside_count = kept;
    return GRAZE_OK;
}

static graze_status begin_near(search *s) {
    const arc_tree *t;
    TRY(arc_tree_of(&t, s->context, s->base));
    TRY(reach_arc(s, nearest_arc(s, t)));
    TRY(add_arcs(s, t, t->node));
    TRY(reach_aside(s));
    TRY(bound_aside(s));
    if (s->aside_count > 0)
        qsort(s->aside, s->aside_count, sizeof *s->aside, compare_pairs);
    return GRAZE_OK;
}

graze_status least_begin(search *s) {
    enum { FEW = 8 };
    s->low = s->high = INFINITY;
    s->list_count = s->aside_count = 0;
    return s->base->arc_count < FEW ? begin_whole(s) : begin_near(s);
}
