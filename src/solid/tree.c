/* Median splits along the widest axis of the boxes' centres.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "solid/tree.h"

#include <stdlib.h>

typedef struct builder {
    const box *boxes;
    uint32_t *order;
    tree *out;
} builder;

int box_meets(const box *a, const box *b) {
    for (int i = 0; i < 3; i++)
        if (a->low[i] > b->high[i] || b->low[i] > a->high[i])
            return 0;
    return 1;
}

static void box_extend(box *a, const box *b) {
    for (int i = 0; i < 3; i++) {
        if (b->low[i] < a->low[i])
            a->low[i] = b->low[i];
        if (b->high[i] > a->high[i])
            a->high[i] = b->high[i];
    }
}

static double centre(const box *b, int axis) {
    return b->low[axis] / 2 + b->high[axis] / 2;
}

static int widest_axis(const builder *b, size_t first, size_t count) {
    int widest = 0;
    double width = -1;
    for (int axis = 0; axis < 3; axis++) {
        double low = centre(&b->boxes[b->order[first]], axis), high = low;
        for (size_t k = first + 1; k < first + count; k++) {
            double c = centre(&b->boxes[b->order[k]], axis);
            low = c < low ? c : low;
            high = c > high ? c : high;
        }
        if (high - low > width) {
            width = high - low;
            widest = axis;
        }
    }
    return widest;
}

/* Quickselect: afterwards order[nth] is what sorting by centre would put there. */
static void select_nth(const builder *b, int axis, size_t first, size_t last, size_t nth) {
    while (first < last) {
        double pivot = centre(&b->boxes[b->order[first + (last - first) / 2]], axis);
        size_t i = first, j = last;
        for (;;) {
            while (centre(&b->boxes[b->order[i]], axis) < pivot)
                i++;
            while (centre(&b->boxes[b->order[j]], axis) > pivot)
                j--;
            if (i >= j)
                break;
            uint32_t swap = b->order[i];
            b->order[i++] = b->order[j];
            b->order[j--] = swap;
        }
        if (nth <= j)
            last = j;
        else
            first = j + 1;
    }
}

static void build(builder *b, size_t node, size_t first, size_t count) {
    tree_node *here = &b->out->node[node];
    here->box = b->boxes[b->order[first]];
    for (size_t k = first + 1; k < first + count; k++)
        box_extend(&here->box, &b->boxes[b->order[k]]);
    here->simplex = b->order[first];
    here->child = 0;
    if (count == 1)
        return;
    size_t half = count / 2;
    select_nth(b, widest_axis(b, first, count), first, first + count - 1, first + half);
    here->child = (uint32_t)b->out->node_count;
    b->out->node_count += 2;
    build(b, here->child, first, half);
    build(b, here->child + 1, first + half, count - half);
}

int tree_build(tree *out, const box *boxes, size_t n) {
    builder b = {boxes, malloc(n * sizeof *b.order), out};
    out->node = malloc((2 * n - 1) * sizeof *out->node);
    out->node_count = 1;
    if (!b.order || !out->node) {
        free(b.order);
        free(out->node);
        out->node = NULL;
        return -1;
    }
    for (size_t k = 0; k < n; k++)
        b.order[k] = (uint32_t)k;
    build(&b, 0, 0, n);
    free(b.order);
    return 0;
}

void tree_clear(tree *t) {
    free(t->node);
    t->node = NULL;
    t->node_count = 0;
}
