/* A slab's normal is the sum of the normals of its simplices, weighted by their size. The slab is
 * right for any normal; a good normal makes it thin.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include <math.h>
#include <stdlib.h>

/* A node of more than SLAB_MOST simplices is seldom flat. At a node of fewer than SLAB_LEAST,
 * testing the simplices themselves costs no more; half of all nodes are so small. */
enum { SLAB_LEAST = 4, SLAB_MOST = 512 };

typedef struct slab_maker {
    slabs *out;
    tree *boxes;
    const corners *corners;
    int dimension;
    uint32_t made;
} slab_maker;

static const double *slab_corners(const slab_maker *m, uint32_t simplex) {
    return m->corners->at + (size_t)simplex * (size_t)(m->dimension * m->dimension);
}

static void add_normal(double *sum, const slab_maker *m, uint32_t simplex) {
    const double *v = slab_corners(m, simplex);
    if (m->dimension == 2) {
        sum[0] += v[3] - v[1];
        sum[1] += v[0] - v[2];
        return;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        sum[i] += (v[3 + j] - v[j]) * (v[6 + k] - v[k]) - (v[3 + k] - v[k]) * (v[6 + j] - v[j]);
    }
}

/* Widen a slab until it holds the corners below a node. */
static void hold_below(slab *s, const slab_maker *m, uint32_t index) {
    const tree_node *node = &m->boxes->node[index];
    int d = m->dimension;
    if (node->child) {
        hold_below(s, m, node->child);
        hold_below(s, m, node->child + 1);
        return;
    }
    const double *v = slab_corners(m, node->simplex);
    for (int c = 0; c < d; c++, v += d) {
        double at = 0;
        for (int i = 0; i < d; i++)
            at += s->normal[i] * v[i];
        s->low = fmin(s->low, at);
        s->high = fmax(s->high, at);
    }
}

static void make_slab(slab *s, const slab_maker *m, uint32_t index, const double *sum) {
    double most = fmax(fabs(sum[0]), fmax(fabs(sum[1]), fabs(sum[2]))), margin = 0x1p-780;
    *s = m->out->item[0];
    if (!(most > 0))
        return;
    *s = (slab){{0, 0, 0}, INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++) {
        s->normal[i] = sum[i] / most;
        margin += 0x1p-49 * m->corners->axis_reach[i] + (1 + 0x1p-20) * m->corners->error;
    }
    hold_below(s, m, index);
    s->low -= margin;
    s->high += margin;
}

static int has_slab(size_t count) {
    return count >= SLAB_LEAST && count <= SLAB_MOST;
}

/* Count the simplices below a node, and add the number of nodes with a slab to `slabs`. */
static size_t count_below(uint32_t *slabs, const tree *boxes, uint32_t index) {
    uint32_t child = boxes->node[index].child;
    size_t count =
        child ? count_below(slabs, boxes, child) + count_below(slabs, boxes, child + 1) : 1;
    *slabs += has_slab(count);
    return count;
}

/* Make the slabs of a node and of all inner nodes below, and add the normals of the node's
 * simplices to `sum`.
 * @return the number of these simplices */
static size_t make_below(double *sum, slab_maker *m, uint32_t index) {
    tree_node *node = &m->boxes->node[index];
    double own[3] = {0, 0, 0};
    size_t count = 1;
    if (node->child) {
        count = make_below(own, m, node->child) + make_below(own, m, node->child + 1);
        node->slab = has_slab(count) ? m->made++ : 0;
        if (node->slab)
            make_slab(&m->out->item[node->slab], m, index, own);
    } else {
        add_normal(own, m, node->simplex);
    }
    for (int i = 0; i < 3; i++)
        sum[i] += own[i];
    return count;
}

int slabs_make(slabs *out, tree *boxes, const corners *corners, int dimension) {
    slab_maker m = {out, boxes, corners, dimension, 1};
    double sum[3] = {0, 0, 0};
    uint32_t most = 1;
    out->item = NULL;
    if (!corners->at)
        return 1;
    (void)count_below(&most, boxes, 0);
    out->item = malloc(most * sizeof *out->item);
    if (!out->item)
        return 0;
    out->item[0] = (slab){{0, 0, 0}, -INFINITY, INFINITY};
    (void)make_below(sum, &m, 0);
    return 1;
}

void slabs_clear(slabs *s) {
    free(s->item);
    s->item = NULL;
}
