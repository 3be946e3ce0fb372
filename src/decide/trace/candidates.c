/* Time and tree are subdivided together. Boxes only exclude pairs; exact tests answer for the pairs
 * that are left. Pieces of the curve are cut when first needed and kept for all branches of the
 * tree. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/trace/trace.h"

#include <math.h>
#include "base/context/array.h"
#include "base/context/scope.h"

/* The piece [start, start + 2^(WINDOW_LEVELS - level)] of the curve, in units of 2^-WINDOW_LEVELS.
 */
typedef struct exact_span {
    uint32_t start;
    int level;
    size_t child; /* the two halves stand at child and child + 1; 0: not cut yet */
    box box;
    int bounded; /* what trajectory_bound returned */
    int broad;   /* the distance between the curves, not their length, makes the box wide */
    bernstein_form *form; /* d + 1 polynomials for each curve, to its degree; NULL once cut */
} exact_span;

typedef struct searcher {
    const graze_solid *solid;
    const trajectory *c, *other; /* `other` may be NULL, else of the same degree */
    candidates *out;
    exact_span *spans;
    size_t count, capacity;
    fmpz *bernstein; /* room for the coefficients of one curve */
    graze_context *context;
    graze_status status; /* the first failure, which ends the search */
} searcher;

static int polynomial_count(const searcher *s) {
    return (s->c->dimension + 1) * (s->other ? 2 : 1);
}

static void lose_memory(searcher *s) {
    s->status =
        context_fail(s->context, GRAZE_ESYSTEM, "out of memory while a trajectory is searched");
}

/* Can cutting a piece make its box smaller? Not once it is broad, or rounding outward makes up most
 * of the box's width, or the box is beyond the range of doubles. Without this, solids that are far
 * from the origin, huge or tiny would be cut for ever. */
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
    if (!enough)
        lose_memory(s);
    return enough;
}

static int bound_curve(box *out, const searcher *s, const trajectory *c,
                       const bernstein_form *form) {
    for (int i = 0; i <= c->dimension; i++)
        for (slong j = 0; j <= c->degree; j++)
            wide_get_fmpz(s->bernstein + i * (c->degree + 1) + j, &form[i].c, j);
    return trajectory_bound(out, c, s->bernstein);
}

/* Enlarge a piece's box to the other curve's piece; it then holds all segments between both. */
static void bound_other(exact_span *piece, const searcher *s) {
    box b;
    const bernstein_form *form = piece->form + polynomial_count(s) / 2;
    piece->bounded = bound_curve(&b, s, s->other, form) && piece->bounded;
    double width = fmax(box_extent(&piece->box), box_extent(&b));
    for (int i = 0; i < 3; i++) {
        piece->box.low[i] = fmin(piece->box.low[i], b.low[i]);
        piece->box.high[i] = fmax(piece->box.high[i], b.high[i]);
    }
    piece->broad = piece->bounded && width < box_extent(&piece->box) / 2;
}

static void add_span(searcher *s, uint32_t start, int level, bernstein_form *form) {
    exact_span *added = &s->spans[s->count++];
    *added = (exact_span){.start = start, .level = level, .form = form};
    added->bounded = bound_curve(&added->box, s, s->c, form);
    if (s->other)
        bound_other(added, s);
}

/* Count the work of a cut: one sum of two integers for each place in de Casteljau's triangles. */
static graze_status cut_work(const searcher *s, const bernstein_form *form) {
    ulong work = 0;
    for (int i = 0; i < polynomial_count(s); i++)
        work += (ulong)(form[i].c.count * form[i].c.count * form[i].c.limbs);
    return context_work(s->context, work);
}

/* Cut a span in halves; 0 after a failure. The left half takes over its coefficients. */
static int cut_span(searcher *s, size_t index) {
    if (s->spans[index].child)
        return 1;
    if (!reserve_spans(s))
        return 0;
    exact_span *whole = &s->spans[index];
    bernstein_form *left = whole->form;
    s->status = cut_work(s, left);
    if (s->status != GRAZE_OK)
        return 0;
    bernstein_form *right = flint_malloc((size_t)polynomial_count(s) * sizeof *right);
    for (int i = 0; i < polynomial_count(s); i++)
        bernstein_form_split(&left[i], &right[i]);
    whole->child = s->count;
    whole->form = NULL;
    int level = whole->level + 1;
    uint32_t start = whole->start;
    add_span(s, start, level, left);
    add_span(s, start + (UINT32_C(1) << (WINDOW_LEVELS - level)), level, right);
    return 1;
}

static void descend_exactly(searcher *s, size_t node_index, size_t span_index) {
    const tree_node *node = &s->solid->boxes.node[node_index];
    const exact_span *piece = &s->spans[span_index];
    if (s->status || !box_meets(&node->box, &piece->box))
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
        uint32_t end = piece->start + (UINT32_C(1) << (WINDOW_LEVELS - piece->level));
        if (!candidates_append(s->out, (candidate){0, node->simplex, piece->start, end}))
            lose_memory(s);
    }
}

/* The Bernstein coefficients of a curve on its whole piece. */
static void expand_whole(bernstein_form *out, const trajectory *c) {
    HELD(dyadic_interval, unit);
    dyadic_interval_set_si(&unit, 0, 1);
    for (int i = 0; i <= c->dimension; i++)
        bernstein_form_init(&out[i], &c->x[i], c->degree, &unit);
}

static void clear_spans(searcher *s) {
    for (size_t k = 0; k < s->count; k++) {
        for (int i = 0; s->spans[k].form && i < polynomial_count(s); i++)
            bernstein_form_clear(&s->spans[k].form[i]);
        flint_free(s->spans[k].form);
    }
    free(s->spans);
}

static graze_status search_boxes(searcher *s) {
    slong length = (s->c->dimension + 1) * (s->c->degree + 1);
    s->out->count = 0;
    s->bernstein = _fmpz_vec_init(length);
    if (reserve_spans(s)) {
        bernstein_form *whole = flint_malloc((size_t)polynomial_count(s) * sizeof *whole);
        expand_whole(whole, s->c);
        if (s->other)
            expand_whole(whole + polynomial_count(s) / 2, s->other);
        add_span(s, 0, 0, whole);
        descend_exactly(s, 0, 0);
    }
    clear_spans(s);
    _fmpz_vec_clear(s->bernstein, length);
    if (s->status == GRAZE_OK)
        candidates_join(s->out);
    return s->status;
}

graze_status candidates_find(candidates *out, graze_context *context, const graze_solid *solid,
                             const trajectory *c) {
    searcher s = {.solid = solid, .c = c, .out = out, .context = context};
    return search_boxes(&s);
}

graze_status candidates_find_between(candidates *out, graze_context *context,
                                     const graze_solid *solid, trajectory *c, trajectory *other) {
    searcher s = {.solid = solid, .c = c, .other = other, .out = out, .context = context};
    c->degree = other->degree = c->degree > other->degree ? c->degree : other->degree;
    return search_boxes(&s);
}
