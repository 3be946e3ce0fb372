/* An arc's box holds the images of the solid's box under the maps in Bernstein form.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/distance/gap.h"

#include <math.h>
#include "base/context/scope.h"

/* ERROR bounds the relative error of sums of coefficients: 2^-52 of each coefficient and a few
 * roundings. */
static const double ERROR = 0x1p-44;
/* FLOOR bounds the errors of coefficients below 2^-1000, which are 0 here. */
static const double FLOOR = 0x1p-900;

/* Bound coordinate i of the images of S: by the range of the images of the box's middle, and half
 * the box's extent. */
static void bound_arc_coordinate(box *out, const carrier *map, int i, const box *b, double off) {
    int d = map->dimension, n = map->degree + 1;
    const double *row = map->entry + i * (d + 1) * n;
    double low = INFINITY, high = -INFINITY, size = 0, more = 0, least = INFINITY;
    for (int k = 0; k < n; k++) {
        double sum = row[d * n + k], all = fabs(sum), half = 0, weight = map->weight[k];
        for (int j = 0; j < d; j++) {
            double entry = row[j * n + k];
            sum += entry * (b->low[j] / 2 + b->high[j] / 2);
            all += fabs(entry) * (larger(fabs(b->low[j]), fabs(b->high[j])) + off);
            half += fabs(entry) * ((b->high[j] - b->low[j]) / 2 + off);
        }
        low = smaller(low, sum / weight);
        high = larger(high, sum / weight);
        more = larger(more, half / weight);
        size = larger(size, all);
        least = smaller(least, weight);
    }
    more += ERROR * (more + size / least) + FLOOR;
    out->low[i] = low - more;
    out->high[i] = high + more;
}

static int has_even_weight(const carrier *map) {
    double least = INFINITY;
    for (int k = 0; k <= map->degree; k++)
        least = smaller(least, map->weight[k]);
    return least > 0x1p-12; /* the largest weight is less than 1 */
}

/* Set a box that holds S during an arc: all of space, if the weight's coefficients give no bound.
 * @return 0 if memory runs out */
static int bound_arc_world(box *out, const arc_maps *g, const arc *a) {
    const motion_piece *piece = &g->scene->motion->piece[a->piece];
    const graze_solid *solid = g->scene->solid;
    carrier map;
    int exponent;
    (void)frexp(a->length, &exponent);
    HELD(dyadic_interval, part);
    fmpz_set_d(part.low, a->from / a->length);
    fmpz_add_ui(part.high, part.low, 1);
    part.exponent = (ulong)(1 - exponent);
    int made = carrier_make_on(&map, motion_placing(piece, g->scene->options.operation), &part);
    *out = (box){{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
    if (made && map.usable && has_even_weight(&map))
        for (int i = 0; i < map.dimension; i++)
            bound_arc_coordinate(out, &map, i, &solid->boxes.node[0].box, solid->corners.error);
    carrier_clear(&map);
    return made;
}

/* Make the node of arcs [first, last) and the nodes below it; returns 0 if memory runs out. */
static int make_arc_node(arc_tree *t, const arc_maps *g, uint32_t index, uint32_t first,
                         uint32_t last) {
    arc_node *here = &t->node[index];
    *here = (arc_node){.first = first, .last = last};
    if (last - first == 1)
        return bound_arc_world(&here->world, g, &g->arc[first]);
    uint32_t middle = first + (last - first) / 2;
    here->child = (uint32_t)t->count;
    t->count += 2;
    const arc_node *left = &t->node[here->child], *right = left + 1;
    if (!make_arc_node(t, g, here->child, first, middle) ||
        !make_arc_node(t, g, here->child + 1, middle, last))
        return 0;
    for (int i = 0; i < 3; i++) {
        here->world.low[i] = smaller(left->world.low[i], right->world.low[i]);
        here->world.high[i] = larger(left->world.high[i], right->world.high[i]);
    }
    return 1;
}

static void free_arc_tree(void *value) {
    arc_tree *t = value;
    if (t)
        free(t->node);
    free(t);
}

static arc_tree *make_arc_tree(const arc_maps *g) {
    arc_tree *t = calloc(1, sizeof *t);
    if (!t || !(t->node = calloc(2 * g->arc_count, sizeof *t->node))) {
        free_arc_tree(t);
        return NULL;
    }
    t->count = 1;
    if (make_arc_node(t, g, 0, 0, (uint32_t)g->arc_count))
        return t;
    free_arc_tree(t);
    return NULL;
}

graze_status arc_tree_of(const arc_tree **out, graze_context *context, const arc_maps *base) {
    scene_memo *memo = base->tree;
    graze_status status = GRAZE_OK;
    pthread_mutex_lock(&memo->lock);
    if (!memo->value) {
        memo->value = make_arc_tree(base);
        memo->free = free_arc_tree;
    }
    if (!memo->value)
        status = context_fail(context, GRAZE_ESYSTEM, "out of memory for the maps of a motion");
    *out = memo->value;
    pthread_mutex_unlock(&memo->lock);
    return status;
}

double arc_node_distance(const arc_node *n, const double *low, const double *high, int d) {
    double square = 0;
    for (int i = 0; i < d; i++) {
        double gap = larger(n->world.low[i] - high[i], low[i] - n->world.high[i]);
        square += gap > 0 ? gap * gap : 0;
    }
    return square < INFINITY ? sqrt(square) * (1 - 0x1p-48) : 0;
}
