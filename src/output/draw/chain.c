/* Segments with equal keys at their ends are neighbours.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "output/draw/draw.h"

#include <math.h>
#include <stdlib.h>
#include "base/context/scope.h"
#include "output/draw/panel.h"
#include "output/draw/views.h"

/* End `end` of a segment. */
typedef struct chain_end {
    uint64_t key;
    size_t segment;
    int end;
} chain_end;

static int order_ends(const void *a, const void *b) {
    const chain_end *e = a, *f = b;
    if (e->key != f->key)
        return e->key < f->key ? -1 : 1;
    if (e->segment != f->segment)
        return e->segment < f->segment ? -1 : 1;
    return e->end - f->end;
}

/* 2 * segment + end of the end that meets an end, or NONE. */
static const size_t NONE = SIZE_MAX;

static void link_ends(size_t *next, chain_end *ends, size_t count) {
    for (size_t k = 0; k < count; k++)
        next[k] = NONE;
    qsort(ends, count, sizeof *ends, order_ends);
    for (size_t k = 0; k + 1 < count; k++) {
        if (ends[k].key != ends[k + 1].key)
            continue;
        size_t a = 2 * ends[k].segment + (size_t)ends[k].end;
        size_t b = 2 * ends[k + 1].segment + (size_t)ends[k + 1].end;
        next[a] = b;
        next[b] = a;
        k++;
    }
}

void chain_to(drawn_path *out, double x, double y, double apart) {
    const path_node *last = out->count ? &out->node[out->count - 1] : NULL;
    if (out->failed || !last || last->verb == 'z' || apart == 0 ||
        hypot(x - last->x, y - last->y) >= apart)
        drawn_path_to(out, 'L', x, y);
}

/* The end at which a line begins that runs through a segment: one without a neighbour, or, of a
 * ring, the segment's own first end. */
static size_t first_end(const size_t *next, size_t segment) {
    size_t at = 2 * segment;
    while (next[at] != NONE && next[at] / 2 != segment)
        at = next[at] ^ 1;
    return next[at] == NONE ? at : 2 * segment;
}

static void put_chain(drawn_path *out, const chain_segment *segments, const size_t *next,
                      char *taken, size_t from, double apart) {
    size_t at = from;
    drawn_path_to(out, 'M', segments[at / 2].x[at % 2], segments[at / 2].y[at % 2]);
    for (;;) {
        const chain_segment *s = &segments[at / 2];
        size_t far = at ^ 1;
        taken[at / 2] = 1;
        if (next[far] == from) {
            drawn_path_to(out, 'z', 0, 0);
            return;
        }
        int last = next[far] == NONE || taken[next[far] / 2];
        chain_to(out, s->x[far % 2], s->y[far % 2], last ? 0 : apart);
        if (last)
            return;
        at = next[far];
    }
}

void chain_path(drawn_path *out, const chain_segment *segments, size_t count, double apart) {
    FREED(chain_end, ends, calloc(2 * count + 1, sizeof *ends));
    FREED(size_t, next, calloc(2 * count + 1, sizeof *next));
    FREED(char, taken, calloc(count + 1, 1));
    out->failed |= !ends || !next || !taken;
    if (!out->failed) {
        for (size_t k = 0; k < 2 * count; k++)
            ends[k] = (chain_end){segments[k / 2].key[k % 2], k / 2, (int)(k % 2)};
        link_ends(next, ends, 2 * count);
        for (size_t k = 0; k < count; k++)
            if (!taken[k])
                put_chain(out, segments, next, taken, first_end(next, k), apart);
    }
}
