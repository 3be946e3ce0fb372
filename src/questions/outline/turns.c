/* The order of boundary pieces about a point, by their crossings with the border of a box
 * (proofs/outline.md C140).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/outline/arc_complex.h"

/* One end of a boundary piece at its point. It leaves the box through side `side`: 0 bottom, 1
 * right, 2 top, 3 left. */
typedef struct turn_end {
    size_t point, number; /* number: 2 piece + end */
    int side;
    algebraic *at; /* the parameter there */
} turn_end;

/* A box about a point, whose places are compared with `places` binary places. `unclear`: something
 * on the border is not told apart, and another box is to be tried. */
typedef struct border {
    graze_outline *o;
    graze_context *context;
    fmpq *end; /* low x, low y, high x, high y */
    ulong places;
    int unclear, crossings, side;
    algebraic *at; /* the parameter of the last crossing, which is on `side` */
} border;

/* The coordinate that is constant on each side, and its entry of `end`. */
static const int side_axis[] = {1, 0, 1, 0}, side_end[] = {1, 2, 3, 0};

/* Is a number in the box's range on an axis? */
static int is_in_range(border *b, const bracket *x, int axis) {
    HELD(bracket, low);
    HELD(bracket, high);
    bracket_set_rational(&low, b->end + axis, b->places);
    bracket_set_rational(&high, b->end + 2 + axis, b->places);
    b->unclear = b->unclear || bracket_meets(x, &low) || bracket_meets(x, &high);
    return fmpz_cmp(x->low, low.low) > 0 && fmpz_cmp(x->high, high.high) < 0;
}

/* Count a crossing of a side's line, at a parameter, if it lies on the side. */
static graze_status count_crossing(border *b, outline_curve *c, algebraic *at, int side) {
    int axis = 1 - side_axis[side];
    HELD(point_place, here);
    TRY(outline_curve_place(here.xy, b->context, c, at, b->places));
    if (!is_in_range(b, &here.xy[axis], axis) || b->unclear)
        return GRAZE_OK;
    b->crossings++;
    b->side = side;
    algebraic_set(b->at, at);
    return GRAZE_OK;
}

/* Count an end of a part of a curve if it is inside. */
static graze_status count_end(int *inside, border *b, outline_curve *c, algebraic *s) {
    HELD(point_place, here);
    TRY(outline_curve_place(here.xy, b->context, c, s, b->places));
    /* Both ranges are looked at: either may be unclear. */
    *inside += is_in_range(b, &here.xy[0], 0) & is_in_range(b, &here.xy[1], 1);
    return GRAZE_OK;
}

/* Find the crossings of the part of a curve between two parameters with the box's border, and how
 * many of its ends are inside. */
static graze_status find_crossings(int *inside, border *b, outline_curve *c, algebraic *from,
                                   algebraic *to) {
    *inside = b->crossings = 0;
    TRY(count_end(inside, b, c, from));
    TRY(count_end(inside, b, c, to));
    for (int side = 0; side < 4 && !b->unclear; side++) {
        HELD(algebraic_list, at);
        TRY(outline_crossings(&at, b->o, b->context, c, from, to, side_axis[side],
                              b->end + side_end[side]));
        for (size_t k = 0; k < at.count && !b->unclear; k++)
            TRY(count_crossing(b, c, &at.item[k], side));
    }
    return GRAZE_OK;
}

/* The part of a piece that leaves its point at an end: all of it, or half of a loop. */
static graze_status cross_at_end(border *b, turn_end *e) {
    const outline_piece *p = &b->o->piece[e->number / 2];
    int inside = 0;
    HELD(algebraic, middle);
    algebraic *from = piece_end(b->o, p, 0), *to = piece_end(b->o, p, 1);
    if (p->end[0] == p->end[1]) {
        TRY(piece_middle(middle.value, b->context, b->o, p));
        if (e->number % 2)
            from = &middle;
        else
            to = &middle;
    }
    TRY(find_crossings(&inside, b, &b->o->curve[p->curve], from, to));
    e->side = b->side;
    algebraic_set(e->at, b->at);
    b->unclear = b->unclear || b->crossings != 1 || inside != 1;
    return GRAZE_OK;
}

/* Set a box of about 2^-m around the point; its shape depends on m, so that no curve leaves all
 * boxes through a corner. */
static graze_status set_border(border *b, size_t point, ulong m) {
    const outline_point *p = &b->o->point[point];
    outline_curve *c = &b->o->curve[p->curve];
    LOCAL(fmpq, half);
    TRY(outline_curve_corners(b->end, b->context, c, c->cut[p->cut], m + 8));
    vector_middle(b->end, b->end, b->end + 2, 2);
    for (int k = 0; k < 2; k++) {
        fmpq_set_si(half, k ? 64 : 33 + (slong)(7 * m % 31), 64);
        fmpq_div_2exp(half, half, m);
        fmpq_add(b->end + 2 + k, b->end + k, half);
        fmpq_sub(b->end + k, b->end + k, half);
    }
    b->places = m + 64;
    b->unclear = 0;
    return GRAZE_OK;
}

/* *before becomes 1 if end x leaves the box earlier than y, counter-clockwise from the lower left
 * corner. */
static graze_status leaves_before(int *before, const border *b, turn_end *x, turn_end *y) {
    *before = x->side < y->side;
    if (x->side != y->side)
        return GRAZE_OK;
    HELD(algebraic, at_x);
    HELD(algebraic, at_y);
    graze_outline *o = b->o;
    int order = 0, along = 1 - side_axis[x->side];
    TRY(outline_coordinate(&at_x, o, b->context, &o->curve[o->piece[x->number / 2].curve], x->at,
                           along));
    TRY(outline_coordinate(&at_y, o, b->context, &o->curve[o->piece[y->number / 2].curve], y->at,
                           along));
    TRY(algebraic_compare(&order, b->context, &at_x, &at_y));
    *before = (order < 0) == (x->side < 2);
    return GRAZE_OK;
}

static graze_status sort_ends(const border *b, turn_end *end, size_t count) {
    for (size_t i = 1; i < count; i++)
        for (size_t k = i; k > 0; k--) {
            int before = 0;
            TRY(leaves_before(&before, b, &end[k], &end[k - 1]));
            if (!before)
                break;
            turn_end swap = end[k];
            end[k] = end[k - 1];
            end[k - 1] = swap;
        }
    return GRAZE_OK;
}

/* Sort the ends at a point of more than two. */
static graze_status order_turns(graze_outline *o, graze_context *context, turn_end *end,
                                size_t count) {
    LOCAL_VEC(fmpq, ends, 4);
    HELD(algebraic_list, at);
    border b = {.o = o, .context = context, .end = ends, .unclear = 1};
    double size = INFINITY;
    (void)algebraic_list_append(&at);
    for (size_t k = 0; k < count; k++) {
        size = fmin(size, box_extent(&o->piece[end[k].number / 2].box));
        (void)algebraic_list_append(&at);
    }
    b.at = &at.item[count];
    for (size_t k = 0; k < count; k++)
        end[k].at = &at.item[k];
    for (ulong m = first_places(size); b.unclear; m += 3) {
        if (m > context->limits[GRAZE_LIMIT_BITS])
            return context_limit(context, GRAZE_LIMIT_BITS, "the places of a box about a point");
        TRY(set_border(&b, end->point, m));
        for (size_t k = 0; k < count && !b.unclear; k++)
            TRY(cross_at_end(&b, &end[k]));
    }
    return sort_ends(&b, end, count);
}

/* Does the set's boundary, with the set on the left, arrive at the point along this end? */
static int is_incoming(const graze_outline *o, const turn_end *e) {
    return (o->piece[e->number / 2].turn > 0) == (e->number % 2 == 1);
}

/* Link the sorted ends of one point. Around it they arrive and leave by turns. */
static graze_status link_turns(turn_order *out, const graze_outline *o, graze_context *context,
                               const turn_end *end, size_t count) {
    for (size_t k = 0; k < count; k++) {
        const turn_end *next = &end[(k + 1) % count];
        if (is_incoming(o, &end[k]) == is_incoming(o, next))
            return context_fail(context, GRAZE_EINTERNAL,
                                "the boundary's pieces do not alternate about a point");
        out->next[end[k].number] = next->number;
        out->previous[next->number] = end[k].number;
    }
    return GRAZE_OK;
}

static int compare_turn_ends(const void *left, const void *right) {
    const turn_end *a = left, *b = right;
    return a->point < b->point ? -1 : a->point > b->point;
}

graze_status outline_turns(turn_order *out, graze_outline *o, graze_context *context) {
    size_t count = 0;
    FREED(turn_end, end, malloc((2 * o->piece_count + 1) * sizeof *end));
    out->next = malloc((2 * o->piece_count + 1) * sizeof *out->next);
    out->previous = malloc((2 * o->piece_count + 1) * sizeof *out->previous);
    if (!end || !out->next || !out->previous)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->piece_count; k++)
        for (size_t i = 0; i < 2 && o->piece[k].turn; i++)
            end[count++] = (turn_end){.point = o->piece[k].end[i], .number = 2 * k + i};
    qsort(end, count, sizeof *end, compare_turn_ends);
    for (size_t first = 0, next; first < count; first = next) {
        for (next = first; next < count && end[next].point == end[first].point;)
            next++;
        if (next - first > 2)
            TRY(order_turns(o, context, end + first, next - first));
        TRY(link_turns(out, o, context, end + first, next - first));
    }
    return GRAZE_OK;
}
