/* A slab's normal is the sum of those of its simplices, each by its size, and may be any vector: it
 * makes a slab thin, and not right.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "solid/slabs.h"

#include <math.h>
#include <stdlib.h>

/* A node of more simplices is seldom flat, and has a slab without bounds. */
enum { SLAB_MOST = 512 };

typedef struct slab_maker {
    slabs *out;
    const tree *boxes;
    const corners *corners;
    int dimension;
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

/* Widen a slab by the corners below a node. */
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

/* Slabs of all inner nodes from one downwards; adds the normals of its simplices.
 * @return how many those are */
static size_t make_below(double *sum, const slab_maker *m, uint32_t index) {
    const tree_node *node = &m->boxes->node[index];
    double own[3] = {0, 0, 0};
    size_t count = 1;
    if (node->child) {
        slab *s = &m->out->item[node->child / 2];
        *s = (slab){{0, 0, 0}, -INFINITY, INFINITY};
        count = make_below(own, m, node->child) + make_below(own, m, node->child + 1);
        if (count <= SLAB_MOST)
            make_slab(s, m, index, own);
    } else {
        add_normal(own, m, node->simplex);
    }
    for (int i = 0; i < 3; i++)
        sum[i] += own[i];
    return count;
}

int slabs_make(slabs *out, const tree *boxes, const corners *corners, int dimension) {
    slab_maker m = {out, boxes, corners, dimension};
    double sum[3] = {0, 0, 0};
    out->item = NULL;
    if (!corners->at)
        return 1;
    out->item = malloc((boxes->node_count / 2 + 1) * sizeof *out->item);
    if (!out->item)
        return 0;
    (void)make_below(sum, &m, 0);
    return 1;
}

void slabs_clear(slabs *s) {
    free(s->item);
    s->item = NULL;
}
