/* Surfaces with a box are found by a descent of their tree, time and tree cut together; all others
 * are searched one by one. The signs of Bernstein coefficients on a span or on its halves decide.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/filter/search.h"

/* The deepest levels to which time is cut: against boxes, and for the roots of one surface. */
enum { BOX_LEVELS = 6, SURFACE_LEVELS = 10 };

typedef struct surface_search {
    const surface_filter *filter;
    filter_workspace *w;
    int failed;
} surface_search;

/* Keep the sign of a surface on a part that begins with the motion, if it is certain (not 0). */
static void keep_start(surface_search *s, time_part part, size_t surface, int sign) {
    truths *m = &s->w->truths;
    if (part.piece == 0 && part.start == 0 && sign && sign != m->sign[surface])
        truths_flip(m, &s->filter->expression, surface);
}

static void find_roots(surface_search *s, const pullback *p, time_part part, uint32_t surface);

static void find_in_halves(surface_search *s, const pullback *p, time_part part, uint32_t surface) {
    double low[PULLBACK_DEGREE + 1], high[PULLBACK_DEGREE + 1];
    pullback half = {.degree = p->degree, .at = low};
    half.error = FILTER_SLACK * (p->error + (p->degree + 1) * UNIT_ROUNDING * p->size);
    pullback_halve(low, high, p->at, p->degree);
    part.level++;
    pullback_measure(&half);
    find_roots(s, &half, part, surface);
    half.at = high;
    part.start += UINT32_C(1) << (WINDOW_LEVELS - part.level);
    pullback_measure(&half);
    find_roots(s, &half, part, surface);
}

static void find_roots(surface_search *s, const pullback *p, time_part part, uint32_t surface) {
    findings *found = &s->w->found;
    meet_window window = {0, 1, 0};
    pullback_signs signs = pullback_read(p);
    if (flip(FLIP_SURFACE_SIGN, signs.one)) {
        keep_start(s, part, surface, signs.first);
        return;
    }
    if (flip(FLIP_SURFACE_ROOT, signs.single) && pullback_window(&window, p)) {
        keep_start(s, part, surface, signs.first);
        window.enters = flip(FLIP_DIRECTION, signs.first > 0);
        s->failed |= !findings_add_crossing(found, crossing_in(part, surface, &window));
        return;
    }
    /* Where errors are not far below the values, halves would be as uncertain. */
    if (part.level < SURFACE_LEVELS && p->size > 0x1p20 * p->error) {
        find_in_halves(s, p, part, surface);
        return;
    }
    window = (meet_window){0, 1, 0};
    s->failed |= !candidates_append(&found->asked, candidate_in(part, surface, &window));
}

static void meet_surface(surface_search *s, uint32_t span_index, uint32_t surface) {
    const span *piece = &s->w->curve.spans[span_index];
    time_part part = {piece->piece, piece->start, piece->level};
    double at[PULLBACK_DEGREE + 1];
    pullback p;
    if (surface_curve_pull_back(&p, at, &s->w->along, span_index, surface))
        find_roots(s, &p, part, surface);
    else
        s->failed = 1;
}

static void descend_boxes(surface_search *s, uint32_t node, uint32_t span_index) {
    curve *c = &s->w->curve;
    const tree_node *here = &s->filter->boxes.node[node];
    const span *piece = &c->spans[span_index];
    s->failed |= piece->lost;
    if (s->failed || flip(FLIP_SURFACE_BOX, !span_meets(piece, &here->box)))
        return;
    int cuts =
        !piece->bounded || (here->child ? span_is_thick(c, piece, &here->box) : !piece->degree);
    if (cuts && piece->level < BOX_LEVELS) {
        s->failed |= !curve_cut(c, span_index);
        if (s->failed)
            return;
        uint32_t half = c->spans[span_index].child;
        descend_boxes(s, node, half);
        descend_boxes(s, node, half + 1);
    } else if (here->child) {
        descend_boxes(s, here->child, span_index);
        descend_boxes(s, here->child + 1, span_index);
    } else {
        meet_surface(s, span_index, s->filter->boxed[here->simplex]);
    }
}

/* Find the roots of a surface without a box; a group of pieces with a certain sign has none. */
static void meet_open(surface_search *s, uint32_t span_index, uint32_t surface) {
    curve *c = &s->w->curve;
    const span *piece = &c->spans[span_index];
    s->failed |= piece->lost;
    if (s->failed)
        return;
    if (piece->degree) {
        meet_surface(s, span_index, surface);
        return;
    }
    int sign = piece->bounded ? surface_sign_on(s->filter, surface, piece) : 0;
    if (flip(FLIP_SURFACE_SIGN, sign != 0)) {
        keep_start(s, (time_part){piece->piece, 0, 0}, surface, sign);
    } else if (curve_cut(c, span_index)) {
        uint32_t half = c->spans[span_index].child;
        meet_open(s, half, surface);
        meet_open(s, half + 1, surface);
    } else {
        s->failed = 1;
    }
}

static int begin_search(surface_search *s, const filter_point *point) {
    findings *found = &s->w->found;
    found->crossing_count = found->asked.count = found->window_count = found->lost_count = 0;
    s->w->set = curve_set(&s->w->curve, &s->filter->course, point, &s->filter->reach);
    if (!s->w->set || !truths_begin(&s->w->truths, &s->filter->expression))
        return 0;
    surface_curve_begin(&s->w->along, s->filter, &s->w->curve);
    return 1;
}

/* Make candidates of all findings, with whole pieces as windows. */
static int ask_all(findings *found) {
    for (size_t k = 0; k < found->asked.count; k++) {
        found->asked.item[k].from = 0;
        found->asked.item[k].to = WINDOW_WHOLE;
    }
    for (size_t k = 0; k < found->crossing_count; k++) {
        const crossing *c = &found->crossing[k];
        if (!candidates_append(&found->asked, (candidate){c->piece, c->simplex, 0, WINDOW_WHOLE}))
            return 0;
    }
    found->crossing_count = 0;
    return 1;
}

int surfaces_search(filter_workspace *w, const surface_filter *f, const filter_point *point,
                    int exactly) {
    surface_search s = {f, w, 0};
    if (!begin_search(&s, point))
        return 0;
    for (size_t k = 0; k < f->open_count && !s.failed; k++)
        meet_open(&s, 0, f->open[k]);
    if (f->boxed_count && !s.failed)
        descend_boxes(&s, 0, 0);
    return !s.failed && (!exactly || ask_all(&w->found)) && findings_settle(&w->found);
}
