/* The tree is built by median splits along the axis on which the boxes' centres spread most.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/solid/solid.h"

#include <stdlib.h>

/* A box's centre and its simplex, side by side in memory for the splits. */
typedef struct entry {
    double centre[3];
    uint32_t simplex;
} entry;

typedef struct builder {
    const box *boxes;
    entry *entry;
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

static int widest_axis(const entry *first, size_t count) {
    int widest = 0;
    double width = -1;
    for (int axis = 0; axis < 3; axis++) {
        double low = first->centre[axis], high = low;
        for (size_t k = 1; k < count; k++) {
            double c = first[k].centre[axis];
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

/* Quickselect: afterwards list[nth] is the entry that sorting by centre would put there. */
static void select_nth(entry *list, int axis, size_t first, size_t last, size_t nth) {
    while (first < last) {
        double pivot = list[first + (last - first) / 2].centre[axis];
        size_t i = first, j = last;
        for (;;) {
            while (list[i].centre[axis] < pivot)
                i++;
            while (list[j].centre[axis] > pivot)
                j--;
            if (i >= j)
                break;
            entry swap = list[i];
            list[i++] = list[j];
            list[j--] = swap;
        }
        if (nth <= j)
            last = j;
        else
            first = j + 1;
    }
}

static void build(builder *b, size_t node, size_t first, size_t count) {
    tree_node *here = &b->out->node[node];
    here->simplex = b->entry[first].simplex;
    here->child = 0;
    if (count == 1) {
        here->box = b->boxes[here->simplex];
        return;
    }
    size_t half = count / 2;
    int axis = widest_axis(b->entry + first, count);
    select_nth(b->entry + first, axis, 0, count - 1, half);
    here->child = (uint32_t)b->out->node_count;
    b->out->node_count += 2;
    build(b, here->child, first, half);
    build(b, here->child + 1, first + half, count - half);
    here->box = b->out->node[here->child].box;
    box_extend(&here->box, &b->out->node[here->child + 1].box);
}

int tree_build(tree *out, const box *boxes, size_t n) {
    builder b = {boxes, malloc(n * sizeof *b.entry), out};
    out->node = malloc((2 * n - 1) * sizeof *out->node);
    out->node_count = 1;
    if (!b.entry || !out->node) {
        free(b.entry);
        free(out->node);
        out->node = NULL;
        return -1;
    }
    for (size_t k = 0; k < n; k++) {
        b.entry[k].simplex = (uint32_t)k;
        for (int i = 0; i < 3; i++)
            b.entry[k].centre[i] = boxes[k].low[i] / 2 + boxes[k].high[i] / 2;
    }
    build(&b, 0, 0, n);
    free(b.entry);
    return 0;
}

void tree_clear(tree *t) {
    free(t->node);
    t->node = NULL;
    t->node_count = 0;
}
