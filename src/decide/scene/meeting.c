/* A simultaneous descent of the tree and of its image, in doubles, excludes pairs of simplices that
 * are apart. The remaining simplices are tested exactly, in batches.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/scene/scene.h"

#include <math.h>
#include <stdlib.h>
#include "base/number/rounding.h"

/* Sizes of batches: the first one is small, since a meeting is often found at once. */
enum { FEWEST = 16, MOST = 65536 };

typedef struct finder {
    graze_context *context;
    const graze_solid *solid;
    const fmpq *map;
    double entry[12];    /* entries of the map, rounded */
    unsigned char *held; /* by simplex: 1 if it is in the batch */
    uint32_t *batch;
    size_t count, most;
    int met;
    graze_status status;
} finder;

/* The simplices of the batch as a solid of their own; the coordinates are borrowed from the soup.
 */
static graze_status borrow_batch(soup *part, simplices *cut, const finder *f) {
    const soup *whole = &f->solid->input;
    size_t d = (size_t)whole->dimension;
    *part = (soup){.dimension = whole->dimension, .vertex_count = f->count * d};
    *cut = (simplices){.count = f->count};
    part->coordinates = malloc(f->count * d * d * sizeof *part->coordinates);
    cut->item = malloc(f->count * sizeof *cut->item);
    if (!part->coordinates || !cut->item)
        return context_fail(f->context, GRAZE_ESYSTEM, "out of memory for %zu simplices", f->count);
    for (size_t k = 0; k < f->count; k++) {
        cut->item[k] = f->solid->cut.item[f->batch[k]];
        for (size_t m = 0; m < d; m++) {
            const fmpq *from = whole->coordinates + cut->item[k].vertex[m] * d;
            for (size_t i = 0; i < d; i++)
                part->coordinates[(k * d + m) * d + i] = from[i];
            cut->item[k].vertex[m] = (uint32_t)(k * d + m);
        }
    }
    return GRAZE_OK;
}

/* Test the batch, and begin another, twice as large. */
static void test_batch(finder *f) {
    soup part;
    simplices cut;
    if (f->count == 0)
        return;
    f->status = borrow_batch(&part, &cut, f);
    if (f->status == GRAZE_OK)
        f->status = boundaries_meet(&f->met, f->context, &part, &cut, f->map);
    free(part.coordinates);
    free(cut.item);
    for (size_t k = 0; k < f->count; k++)
        f->held[f->batch[k]] = 0;
    f->count = 0;
    f->most = 2 * f->most < MOST ? 2 * f->most : MOST;
}

static void hold(finder *f, uint32_t simplex) {
    if (!f->held[simplex])
        f->batch[f->count++] = simplex;
    f->held[simplex] = 1;
}

/* Are a box and the image of another certainly disjoint? Comparisons with NaN are false, so they
 * exclude nothing. */
static int are_apart(const finder *f, const box *standing, const box *moving) {
    int d = f->solid->input.dimension;
    box image;
    box_image(&image, f->entry, d, moving);
    for (int i = 0; i < d; i++) {
        double margin = 0x1p-40 * (fabs(standing->low[i]) + fabs(standing->high[i]));
        if (image.high[i] < standing->low[i] - margin || image.low[i] > standing->high[i] + margin)
            return 1;
    }
    return 0;
}

static void descend_both(finder *f, uint32_t standing, uint32_t moving) {
    const tree_node *a = &f->solid->boxes.node[standing], *b = &f->solid->boxes.node[moving];
    if (f->met || f->status != GRAZE_OK || are_apart(f, &a->box, &b->box))
        return;
    if (a->child && (!b->child || box_extent(&a->box) >= box_extent(&b->box))) {
        descend_both(f, a->child, moving);
        descend_both(f, a->child + 1, moving);
    } else if (b->child) {
        descend_both(f, standing, b->child);
        descend_both(f, standing, b->child + 1);
    } else {
        hold(f, a->simplex);
        hold(f, b->simplex);
        if (f->count + 2 > f->most)
            test_batch(f);
        if (f->status == GRAZE_OK)
            f->status = context_poll(f->context);
    }
}

graze_status meeting_find(int *out, graze_context *context, const graze_solid *solid,
                          const fmpq *map) {
    int d = solid->input.dimension;
    finder f = {.context = context, .solid = solid, .map = map, .most = FEWEST};
    for (int k = 0; k < d * (d + 1); k++) {
        double high;
        rational_bounds(&f.entry[k], &high, map + k);
    }
    f.held = calloc(solid->cut.count, 1);
    f.batch = malloc(MOST * sizeof *f.batch);
    if (!f.held || !f.batch)
        f.status = context_fail(context, GRAZE_ESYSTEM, "out of memory for %zu simplices",
                                solid->cut.count);
    descend_both(&f, 0, 0);
    if (f.status == GRAZE_OK && !f.met)
        test_batch(&f);
    free(f.held);
    free(f.batch);
    *out = f.met;
    return f.status;
}
