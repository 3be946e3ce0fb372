/* Arcs of boundary pieces, and walks along them (proofs/outline.md C141).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/context/array.h"
#include "base/context/scope.h"
#include "questions/outline/arc_complex.h"

/* The number of a piece's end, at which it arrives (1) or from which it leaves (0), with the set on
 * its left. */
static size_t end_number(const graze_outline *o, size_t piece, int arrives) {
    return 2 * piece + (size_t)((o->piece[piece].turn > 0) == arrives);
}

static size_t end_point(const graze_outline *o, size_t piece, int arrives) {
    return o->piece[piece].end[(o->piece[piece].turn > 0) == arrives];
}

/* Among the pieces of one point set, the one of a curve at `cut` + or - `count`. */
static const outline_piece *continuing(const graze_outline *o, size_t same, size_t curve,
                                       size_t cut, size_t count) {
    for (size_t k = same; k != OUTLINE_NONE; k = o->piece[k].next_same) {
        const outline_piece *p = &o->piece[k];
        if (p->curve == curve && (p->cut == cut + count || p->cut + count == cut))
            return p;
    }
    return NULL;
}

const outline_piece *outline_last_of(const graze_outline *o, const outline_arc *arc,
                                     const outline_piece *first) {
    return continuing(o, o->arc_piece[arc->first + arc->count - 1], first->curve, first->cut,
                      arc->count - 1);
}

/* Does the next piece continue a piece's arc? All sources go on, and no others begin. */
static int continues(const graze_outline *o, const turn_order *turns, size_t piece) {
    size_t end = end_number(o, piece, 1), next = turns->next[end] / 2, sources = 0;
    const outline_piece *p = &o->piece[piece], *q = &o->piece[next];
    if (turns->next[turns->next[end]] != end || q->curve != p->curve || q->turn != p->turn ||
        q->cut + (p->turn < 0) != p->cut + (p->turn > 0))
        return 0;
    for (size_t k = piece; k != OUTLINE_NONE; k = o->piece[k].next_same, sources++)
        if (!continuing(o, next, o->piece[k].curve, o->piece[k].cut, 1))
            return 0;
    for (size_t k = next; k != OUTLINE_NONE; k = o->piece[k].next_same)
        sources--;
    return sources == 0;
}

static graze_status add_arc(graze_outline *o, graze_context *context, const turn_order *turns,
                            size_t piece, size_t *used) {
    TRY(array_grow(context, &o->arc, &o->arc_capacity, o->arc_count + 1, sizeof *o->arc,
                   "the arcs of an outline"));
    outline_arc *arc = &o->arc[o->arc_count++];
    *arc = (outline_arc){.first = *used, .from = end_point(o, piece, 0)};
    measure_init(&arc->area);
    measure_init(&arc->length);
    for (;;) {
        o->arc_piece[(*used)++] = piece;
        arc->count++;
        arc->to = end_point(o, piece, 1);
        if (!continues(o, turns, piece))
            return GRAZE_OK;
        piece = turns->next[end_number(o, piece, 1)] / 2;
    }
}

graze_status outline_arcs(graze_outline *o, graze_context *context, const turn_order *turns) {
    size_t used = 0, boundary = 0;
    for (size_t k = 0; k < o->piece_count; k++)
        boundary += o->piece[k].turn != 0;
    o->arc_piece = malloc((boundary + 1) * sizeof *o->arc_piece);
    o->ring_arc = malloc((2 * boundary + 1) * sizeof *o->ring_arc);
    if (!o->arc_piece || !o->ring_arc)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->piece_count; k++)
        if (o->piece[k].turn && !continues(o, turns, turns->next[end_number(o, k, 0)] / 2))
            TRY(add_arc(o, context, turns, k, &used));
    return used == boundary ? GRAZE_OK
                            : context_fail(context, GRAZE_EINTERNAL,
                                           "a piece of the boundary is in no arc, or in two");
}

/* Walks: the arc that begins with each piece, whether an arc is done, and for the ring that is
 * being made its arcs and 1 + its length at each point. */
typedef struct walker {
    graze_outline *o;
    graze_context *context;
    const turn_order *turns;
    size_t *of_piece, *stack, *at, depth, used;
    unsigned char *done;
} walker;

/* The arc that follows through the interior of the set (`inner`), or through its complement: the
 * next one clockwise, or counter-clockwise. */
static size_t arc_after(const walker *w, size_t arc, int inner) {
    const outline_arc *a = &w->o->arc[arc];
    size_t end = end_number(w->o, w->o->arc_piece[a->first + a->count - 1], 1);
    return w->of_piece[(inner ? w->turns->previous : w->turns->next)[end] / 2];
}

static graze_status keep_ring(outline_ring **list, size_t *count, size_t *capacity, walker *w,
                              const size_t *arc, size_t length, size_t walk) {
    TRY(array_grow(w->context, list, capacity, *count + 1, sizeof **list,
                   "the rings of an outline"));
    outline_ring *ring = &(*list)[*count];
    *ring = (outline_ring){.first = w->used, .count = length, .walk = walk, .within = (*count)++};
    measure_init(&ring->area);
    measure_init(&ring->length);
    memcpy(w->o->ring_arc + w->used, arc, length * sizeof *arc);
    w->used += length;
    return GRAZE_OK;
}

/* If the last arc comes back to a point of the ring that is being made, the arcs since then are a
 * ring of their own. */
static graze_status cut_ring(walker *w, size_t arc) {
    graze_outline *o = w->o;
    size_t to = o->arc[arc].to;
    if (!w->at[to]) {
        w->at[to] = w->depth + 1;
        return GRAZE_OK;
    }
    size_t first = w->at[to] - 1;
    for (size_t k = first; k + 1 < w->depth; k++)
        w->at[o->arc[w->stack[k]].to] = 0;
    TRY(keep_ring(&o->ring, &o->ring_count, &o->ring_capacity, w, w->stack + first,
                  w->depth - first, o->walk_count));
    w->depth = first;
    return GRAZE_OK;
}

/* Follow one walk through the interior, cut into simple rings, or through the complement. */
static graze_status follow_walk(walker *w, size_t start, int inner) {
    graze_outline *o = w->o;
    size_t from = o->arc[start].from;
    w->at[from] = 1;
    for (size_t arc = start; !w->done[arc]; arc = arc_after(w, arc, inner)) {
        w->done[arc] = 1;
        w->stack[w->depth++] = arc;
        if (inner)
            TRY(cut_ring(w, arc));
    }
    w->at[from] = 0;
    o->walk_count += (size_t)inner;
    if (inner)
        return w->depth == 0 ? GRAZE_OK
                             : context_fail(w->context, GRAZE_EINTERNAL,
                                            "a walk along the boundary does not close");
    size_t length = w->depth;
    w->depth = 0;
    return keep_ring(&o->around, &o->around_count, &o->around_capacity, w, w->stack, length,
                     o->around_count);
}

graze_status outline_walks(graze_outline *o, graze_context *context, const turn_order *turns) {
    FREED(size_t, of_piece, malloc((o->piece_count + 1) * sizeof *of_piece));
    FREED(size_t, stack, malloc((o->arc_count + 1) * sizeof *stack));
    FREED(size_t, at, calloc(o->point_count + 1, sizeof *at));
    FREED(unsigned char, done, calloc(o->arc_count + 1, 1));
    if (!of_piece || !stack || !at || !done)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    walker w = {o, context, turns, of_piece, stack, at, 0, 0, done};
    for (size_t k = 0; k < o->arc_count; k++)
        of_piece[o->arc_piece[o->arc[k].first]] = k;
    for (int inner = 1; inner >= 0; inner--) {
        memset(done, 0, o->arc_count);
        for (size_t k = 0; k < o->arc_count; k++)
            if (!done[k])
                TRY(follow_walk(&w, k, inner));
    }
    return GRAZE_OK;
}
