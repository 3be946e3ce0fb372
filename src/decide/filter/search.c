/* Time and tree are subdivided together: a span that is thick beside the box it meets is cut before
 * the descent goes on. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/filter/search.h"

/* The deepest levels of spans: against boxes; against a simplex by chord, by Bernstein forms. */
enum { BOX_LEVELS = 20, CHORD_LEVELS = 4, SIMPLEX_LEVELS = 8 };

typedef struct searcher {
    findings *out;
    curve *curve;
    const graze_solid *solid;
    early_end *early; /* NULL: all is to be found */
    int failed;       /* memory ran out, or there are too many spans */
    uint32_t piece;   /* the piece of motion of the latest candidate */
    size_t asked;     /* candidates of this piece; above `most`, it is given up */
    size_t most;
} searcher;

static time_part part_of(const span *piece) {
    return (time_part){piece->piece, piece->start, piece->level};
}

/* The squared distance of a chord's middle from the middle of the solid's box. */
static double distance_of(const searcher *s, const span *piece) {
    const box *all = &s->solid->boxes.node[0].box;
    double sum = 0;
    for (int i = 0; i < s->curve->dimension; i++) {
        double off = piece->from[i] + 0.5 * piece->along[i] - 0.5 * (all->low[i] + all->high[i]);
        sum += off * off;
    }
    return sum;
}

/* The half to be searched first, 0 or 1: the half nearer to the solid if one crossing may end the
 * search, else the earlier one.
 */
static uint32_t first_half(const searcher *s, uint32_t child) {
    const span *half = &s->curve->spans[child];
    return s->early && distance_of(s, half + 1) < distance_of(s, half);
}

/* End the search if at the parameter `at` of a span the curve is certainly in the state that ends
 * it. */
static void sample(const searcher *s, const span *piece, double at) {
    double place[4], off[4];
    box around;
    if (piece->lost)
        return;
    curve_at(place, off, s->curve, piece, at);
    if (place_bound(&around, place, off, s->curve->dimension))
        s->early->met |=
            flip(FLIP_INTERIOR, interior_state(s->early->bricks, &around) == s->early->state);
}

/* Sample places along the part of a span that can be in the solid's box. */
static void sample_along(const searcher *s, const span *piece) {
    static const double share[] = {0.5, 0.25, 0.75};
    double from, to;
    if (!span_window(&from, &to, piece, &s->solid->boxes.node[0].box))
        return;
    for (int k = 0; k < 3 && !s->early->met; k++)
        sample(s, piece, from + share[k] * (to - from));
}

/* Is it certain that the slab of a node misses a span? Not if the span has no bound. */
static int span_misses_slab(const searcher *s, const span *piece, const tree_node *node) {
    return node->child && piece->bounded &&
           !chord_meets_slab(piece, piece->wide, slab_below(&s->solid->slabs, node));
}

/* Are bricks asked for the states of places of a span? */
static int samples(const searcher *s, uint32_t span_index) {
    return s->early && s->early->bricks && s->curve->spans[span_index].degree;
}

static void descend_curve(searcher *s, uint32_t node, uint32_t span_index);

static int cut_and_descend(searcher *s, uint32_t node, uint32_t span_index) {
    if (!curve_cut(s->curve, span_index)) {
        s->failed = 1;
        return 0;
    }
    uint32_t half = s->curve->spans[span_index].child, first = first_half(s, half);
    if (samples(s, half + 1))
        sample(s, &s->curve->spans[half + 1], 0);
    descend_curve(s, node, half + first);
    descend_curve(s, node, half + 1 - first);
    return 1;
}

/* End the search with a certain crossing that is alone, if an early end is allowed, or keep the
 * crossing; 0 if memory runs out. */
static int take_crossing(searcher *s, const span *piece, uint32_t simplex, const meet_window *at) {
    if (s->early)
        s->early->met = crossing_is_alone(s->curve, piece, s->solid, simplex, at);
    return (s->early && s->early->met) ||
           findings_add_crossing(s->out, crossing_in(part_of(piece), simplex, at));
}

/* Keep a candidate. Where a piece has far more of them than the solid has simplices, as where
 * rounding hides the solid, bounds tell nothing: all simplices are asked once instead. */
static int take_candidate(searcher *s, candidate item) {
    s->asked = item.piece == s->piece ? s->asked + 1 : 1;
    s->piece = item.piece;
    return s->asked > s->most ? findings_lose(s->out, item.piece)
                              : candidates_append(&s->out->asked, item);
}

static void meet_leaf(searcher *s, uint32_t node, uint32_t span_index) {
    const span *piece = &s->curve->spans[span_index];
    uint32_t simplex = s->solid->boxes.node[node].simplex;
    const corners *corners = &s->solid->corners;
    size_t d = (size_t)s->solid->input.dimension;
    const double *corner = corners->at + simplex * d * d;
    chord_meeting chord = chord_meets(s->curve, piece, corner, corners->error);
    if (chord == CHORD_MISSES)
        return;
    if (!piece->degree || (chord == CHORD_NEAR && piece->bend > 0 && piece->level < CHORD_LEVELS)) {
        cut_and_descend(s, node, span_index);
        return;
    }
    meet_window window;
    meeting found = meet_simplex(&window, s->curve, piece, corner, corners->error);
    int kept = 1;
    if (found == MEET_CUT && piece->level < SIMPLEX_LEVELS)
        cut_and_descend(s, node, span_index);
    else if (found == MEET_CROSSING)
        kept = take_crossing(s, piece, simplex, &window);
    else if (found != MEET_NONE)
        kept = take_candidate(s, candidate_in(part_of(piece), simplex, &window));
    s->failed |= !kept;
}

static void descend_curve(searcher *s, uint32_t node, uint32_t span_index) {
    if (!node && samples(s, span_index))
        sample_along(s, &s->curve->spans[span_index]);
    for (;;) {
        const span *piece = &s->curve->spans[span_index];
        const tree_node *here = &s->solid->boxes.node[node];
        if (piece->lost)
            s->failed |= !findings_lose(s->out, piece->piece);
        if (s->failed || (s->early && s->early->met) || piece->lost ||
            (s->asked > s->most && piece->piece == s->piece) ||
            flip(FLIP_BOX, !span_meets(piece, &here->box)) || span_misses_slab(s, piece, here))
            return;
        /* For a single simplex, meet_leaf decides whether to cut. */
        if (!piece->bounded || (here->child && span_is_thick(s->curve, piece, &here->box))) {
            if (piece->level < BOX_LEVELS) {
                cut_and_descend(s, node, span_index);
                return;
            }
            if (!piece->bounded) {
                /* The weight's sign is not certain. */
                s->failed |= !findings_lose(s->out, piece->piece);
                return;
            }
        }
        if (!here->child) {
            meet_leaf(s, node, span_index);
            return;
        }
        descend_curve(s, here->child, span_index);
        node = here->child + 1;
    }
}

int search_curve(findings *out, early_end *early, curve *c, const graze_solid *solid) {
    searcher s = {out, c, solid, early, 0, 0, 0, solid->boxes.node_count + 64};
    if (early)
        early->met = 0;
    out->crossing_count = out->asked.count = out->window_count = out->lost_count = 0;
    descend_curve(&s, 0, 0);
    return !s.failed;
}
