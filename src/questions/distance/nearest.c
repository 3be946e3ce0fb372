/* The distance at one instant: a descent of the solid's tree, the nearer child first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "questions/distance/gap.h"

#include <math.h>
#include "questions/distance/time_search.h"

/* Room for the nodes to be entered: each level of the tree halves the number of simplices. */
enum { DEPTH = 80 };

typedef struct descent {
    nearest *out;
    const stance *s;
    double limit;
    size_t *visits;
    uint32_t node[DEPTH];
    double low[DEPTH];
    int count;
} descent;

static const graze_solid *solid_of(const descent *d) {
    return d->s->at.of->base->scene->solid;
}

static double box_low(const descent *d, uint32_t node) {
    const box *b = &solid_of(d)->boxes.node[node].box;
    double g[3];
    ++*d->visits;
    foot_of_box(g, d->s, b);
    return gap_along(&d->s->at, g, gap_box(g, b));
}

static void ask_simplex(descent *d, uint32_t simplex) {
    int n = d->s->dimension;
    const double *corner = solid_of(d)->corners.at + (size_t)simplex * n * n;
    foot f;
    ++*d->visits;
    foot_find(&f, d->s, corner);
    double high = gap_most(&d->s->at, f.q, f.q);
    double low = gap_along(&d->s->at, f.m, gap_corners(f.m, corner, n, n));
    d->out->low = smaller(d->out->low, low);
    if (high < d->out->high) {
        d->out->high = high;
        d->out->simplex = simplex;
        d->out->found = 1;
    }
}

static void push(descent *d, uint32_t node, double low) {
    d->node[d->count] = node;
    d->low[d->count++] = low;
}

static void enter(descent *d, uint32_t node) {
    const tree_node *here = &solid_of(d)->boxes.node[node];
    if (!here->child) {
        ask_simplex(d, here->simplex);
        return;
    }
    double a = box_low(d, here->child), b = box_low(d, here->child + 1);
    push(d, here->child + (a < b), a < b ? b : a);
    push(d, here->child + !(a < b), a < b ? a : b);
}

void nearest_boundary(nearest *out, const stance *s, const place *list, size_t count, double limit,
                      size_t *visits) {
    descent d = {.out = out, .s = s, .limit = limit, .visits = visits};
    *out = (nearest){INFINITY, INFINITY, 0, 0};
    for (size_t k = 0; k < count; k++) {
        push(&d, list[k].node, count > 1 ? box_low(&d, list[k].node) : 0);
        while (d.count > 0) {
            d.count--;
            if (d.low[d.count] < smaller(d.out->high, d.limit))
                enter(&d, d.node[d.count]);
            else
                out->low = smaller(out->low, d.low[d.count]);
        }
    }
    out->low = smaller(out->low, out->high);
}
