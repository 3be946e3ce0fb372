/* Time and tree are subdivided together. Boxes only ever leave a pair out: what they leave is for
 * the exact tests to answer. Pieces of the curve are cut when first needed and kept for all
 * branches of the tree. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "trace/candidates.h"

#include <flint/fmpz_vec.h>
#include <math.h>
#include <stdlib.h>
#include "context/array.h"
#include "filter/curve.h"

/* The piece [start, start + 2^(LEVELS - level)] of the curve. */
typedef struct exact_span {
    uint32_t start;
    int level;
    size_t child; /* the two halves stand at child and child + 1; 0: not cut yet */
    box box;
    int bounded;     /* what trajectory_bound returned */
    int broad;       /* the box is less wide by the curves than by the way between them */
    fmpz *bernstein; /* of each curve d + 1 polynomials to its degree */
} exact_span;

typedef struct searcher {
    const graze_solid *solid;
    const trajectory *c, *other; /* `other` may be NULL, else of the same degree */
    candidates *out;
    exact_span *spans;
    size_t count, capacity;
    int out_of_memory;
} searcher;

static slong polynomial_count(const searcher *s) {
    return (s->c->dimension + 1) * (s->other ? 2 : 1);
}

static slong span_length(const searcher *s) {
    return polynomial_count(s) * (s->c->degree + 1);
}

/* Whether cutting a piece can still make its box smaller: not once it is broad, or the box is
 * hardly wider than what rounding outwards adds to it, or past the range of doubles. Without this,
 * solids that are far from the origin, huge or tiny would be cut for ever. */
static int can_shrink(const exact_span *piece) {
    double reach = 0;
    if (piece->broad)
        return 0;
    for (int i = 0; i < 3; i++)
        reach = fmax(reach, fmax(fabs(piece->box.low[i]), fabs(piece->box.high[i])));
    return !piece->bounded ||
           (isfinite(reach) && box_extent(&piece->box) > reach * 0x1p-44 + 0x1p-880);
}

/* Room for two more spans; 0 if there is no memory. */
static int reserve_spans(searcher *s) {
    int enough = array_reserve(&s->spans, &s->capacity, s->count + 2, sizeof *s->spans);
    s->out_of_memory = s->out_of_memory || !enough;
    return enough;
}

/* A box that holds both pieces of curves, and so all segments between them. */
static void bound_other(exact_span *piece, const searcher *s) {
    box b;
    const fmpz *bernstein = piece->bernstein + span_length(s) / 2;
    piece->bounded = trajectory_bound(&b, s->other, bernstein) && piece->bounded;
    double width = fmax(box_extent(&piece->box), box_extent(&b));
    for (int i = 0; i < 3; i++) {
        piece->box.low[i] = fmin(piece->box.low[i], b.low[i]);
        piece->box.high[i] = fmax(piece->box.high[i], b.high[i]);
    }
    piece->broad = piece->bounded && width < box_extent(&piece->box) / 2;
}

static void add_span(searcher *s, uint32_t start, int level, fmpz *bernstein) {
    exact_span *added = &s->spans[s->count++];
    *added = (exact_span){.start = start, .level = level, .bernstein = bernstein};
    added->bounded = trajectory_bound(&added->box, s->c, bernstein);
    if (s->other)
        bound_other(added, s);
}

/* Cut a span in halves; 0 if there is no memory. */
static int cut_span(searcher *s, size_t index) {
    if (s->spans[index].child)
        return 1;
    if (!reserve_spans(s))
        return 0;
    exact_span *whole = &s->spans[index];
    fmpz *left = _fmpz_vec_init(span_length(s)), *right = _fmpz_vec_init(span_length(s));
    for (slong i = 0; i < polynomial_count(s); i++) {
        slong at = i * (s->c->degree + 1);
        bernstein_split(left + at, right + at, whole->bernstein + at, s->c->degree);
    }
    whole->child = s->count;
    int level = whole->level + 1;
    uint32_t start = whole->start;
    add_span(s, start, level, left);
    add_span(s, start + (UINT32_C(1) << (WINDOW_LEVELS - level)), level, right);
    return 1;
}

static void record(searcher *s, uint32_t simplex, const exact_span *when) {
    uint32_t length = UINT32_C(1) << (WINDOW_LEVELS - when->level);
    if (!candidates_append(s->out, (candidate){0, simplex, when->start, when->start + length}))
        s->out_of_memory = 1;
}

static void descend_exactly(searcher *s, size_t node_index, size_t span_index) {
    const tree_node *node = &s->solid->boxes.node[node_index];
    const exact_span *piece = &s->spans[span_index];
    if (s->out_of_memory || !box_meets(&node->box, &piece->box))
        return;
    if (piece->level < WINDOW_LEVELS && !(box_extent(&piece->box) <= box_extent(&node->box)) &&
        can_shrink(piece)) {
        if (!cut_span(s, span_index))
            return;
        size_t half = s->spans[span_index].child;
        descend_exactly(s, node_index, half);
        descend_exactly(s, node_index, half + 1);
    } else if (node->child) {
        descend_exactly(s, node->child, span_index);
        descend_exactly(s, node->child + 1, span_index);
    } else {
        record(s, node->simplex, piece);
    }
}

/* The Bernstein coefficients of a curve on its whole piece. */
static void expand_whole(fmpz *out, const trajectory *c) {
    dyadic_interval unit;
    dyadic_interval_init(&unit);
    dyadic_interval_set_si(&unit, 0, 1);
    for (int i = 0; i <= c->dimension; i++)
        bernstein_from_poly(out + i * (c->degree + 1), &c->x[i], c->degree, &unit);
    dyadic_interval_clear(&unit);
}

static graze_status search_boxes(searcher *s, graze_context *context) {
    s->out->count = 0;
    if (reserve_spans(s)) {
        fmpz *whole = _fmpz_vec_init(span_length(s));
        expand_whole(whole, s->c);
        if (s->other)
            expand_whole(whole + span_length(s) / 2, s->other);
        add_span(s, 0, 0, whole);
        descend_exactly(s, 0, 0);
    }
    for (size_t k = 0; k < s->count; k++)
        _fmpz_vec_clear(s->spans[k].bernstein, span_length(s));
    free(s->spans);
    if (s->out_of_memory)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory while a trajectory is searched");
    candidates_join(s->out);
    return GRAZE_OK;
}

graze_status candidates_find(candidates *out, graze_context *context, const graze_solid *solid,
                             const trajectory *c) {
    searcher s = {.solid = solid, .c = c, .out = out};
    return search_boxes(&s, context);
}

graze_status candidates_find_between(candidates *out, graze_context *context,
                                     const graze_solid *solid, trajectory *c, trajectory *other) {
    searcher s = {.solid = solid, .c = c, .other = other, .out = out};
    c->degree = other->degree = c->degree > other->degree ? c->degree : other->degree;
    return search_boxes(&s, context);
}
