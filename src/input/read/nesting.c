/* Gathers rings of a plane into polygons with holes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Rings of a legal solid meet in finitely many points, so a ring lies inside another iff some point
 * of its first edge that is not on the other ring lies inside that ring. Such a point is found
 * among the points at 1/2, 1/3, 1/4, ... of the edge, since each edge of the other ring holds at
 * most one of them.
 */
#include "input/read/read.h"

#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/validate/validate.h"

typedef struct ring {
    const size_t *vertex;
    size_t count;
    int ccw;
    fmpq *box; /* low x, low y, high x, high y */
    size_t depth;
    size_t parent;   /* of a hole, the innermost ring around it; else its own number */
    const int *axis; /* the two coordinates in which it is seen */
} ring;

static const fmpq *at(const soup *s, const ring *r, size_t k) {
    return s->coordinates + (size_t)s->dimension * r->vertex[k % r->count];
}

/* Set `out` to the cross product (b - a) x (p - a) and return its sign. */
static int ring_turn(fmpq_t out, const ring *r, const fmpq *a, const fmpq *b, const fmpq *p) {
    cross_rationals(out, a, b, p, r->axis[0], r->axis[1]);
    return fmpq_sgn(out);
}

/* Sign of the ring's area. */
static int ring_orientation(const soup *s, const ring *r) {
    LOCAL_VEC(fmpq, sum, 2);
    fmpq *part = sum + 1;
    for (size_t k = 1; k + 1 < r->count; k++) {
        ring_turn(part, r, at(s, r, 0), at(s, r, k), at(s, r, k + 1));
        fmpq_add(sum, sum, part);
    }
    return fmpq_sgn(sum);
}

static void bound(const soup *s, ring *r) {
    for (size_t k = 0; k < r->count; k++)
        for (int i = 0; i < 2; i++) {
            const fmpq *x = at(s, r, k) + r->axis[i];
            if (k == 0 || fmpq_cmp(x, r->box + i) < 0)
                fmpq_set(r->box + i, x);
            if (k == 0 || fmpq_cmp(x, r->box + 2 + i) > 0)
                fmpq_set(r->box + 2 + i, x);
        }
}

static int between(const fmpq *x, const fmpq *a, const fmpq *b) {
    return fmpq_cmp(x, a) * fmpq_cmp(x, b) <= 0;
}

/* Locate a point: 1 inside the ring, 0 outside, -1 on it. */
static int locate(const soup *s, const ring *r, const fmpq *p) {
    int inside = 0, x = r->axis[0], y = r->axis[1];
    LOCAL(fmpq, cross);
    for (size_t k = 0; k < r->count && inside >= 0; k++) {
        const fmpq *a = at(s, r, k), *b = at(s, r, k + 1);
        int above_a = fmpq_cmp(p + y, a + y) >= 0, above_b = fmpq_cmp(p + y, b + y) >= 0;
        if (!between(p + y, a + y, b + y))
            continue;
        int side = ring_turn(cross, r, a, b, p);
        if (side == 0 && between(p + x, a + x, b + x))
            inside = -1;
        else if (above_a != above_b && (side > 0) == above_a)
            inside = !inside;
    }
    return inside;
}

static int box_within(const ring *inner, const ring *outer) {
    return fmpq_cmp(inner->box, outer->box) >= 0 && fmpq_cmp(inner->box + 1, outer->box + 1) >= 0 &&
           fmpq_cmp(inner->box + 2, outer->box + 2) <= 0 &&
           fmpq_cmp(inner->box + 3, outer->box + 3) <= 0;
}

static int within(const soup *s, const ring *inner, const ring *outer) {
    if (!box_within(inner, outer))
        return 0;
    const fmpq *a = at(s, inner, 0), *b = a;
    for (size_t k = 1; k < inner->count && vector_compare(a, b, s->dimension) == 0; k++)
        b = at(s, inner, k);
    LOCAL_VEC(fmpq, p, 3);
    LOCAL(fmpq, share);
    int where = -1;
    for (size_t part = 2; part < outer->count + 3 && where < 0; part++) {
        fmpq_set_si(share, 1, part);
        for (int i = 0; i < s->dimension; i++) {
            fmpq_sub(p + i, b + i, a + i);
            fmpq_mul(p + i, p + i, share);
            fmpq_add(p + i, p + i, a + i);
        }
        where = locate(s, outer, p);
    }
    return where == 1;
}

static graze_status find_depths(ring *rings, size_t count, graze_context *context, const soup *s) {
    for (size_t r = 0; r < count; r++) {
        TRY(context_poll(context));
        for (size_t q = 0; q < count; q++)
            rings[r].depth += q != r && within(s, &rings[r], &rings[q]);
    }
    /* The innermost ring around a hole is the deepest of the rings around it. */
    for (size_t r = 0; r < count; r++)
        for (size_t q = 0; rings[r].depth % 2 && q < count; q++)
            if (q != r && rings[q].depth + 1 == rings[r].depth && within(s, &rings[r], &rings[q]))
                rings[r].parent = q;
    return GRAZE_OK;
}

static graze_status add_ring(soup *s, graze_context *context, const ring *r) {
    int hole = r->depth % 2 == 1, turned = r->ccw == hole;
    TRY(soup_add_cycle(s, context, NULL, 0));
    for (size_t k = 0; k < r->count; k++)
        TRY(soup_add_index(s, context, r->vertex[turned ? r->count - 1 - k : k]));
    return GRAZE_OK;
}

/* Add polygons, by outer rings in the order given, each followed by its holes. A hole without an
 * outer ring, which only crossing rings can bring about, stands as a polygon of its own. */
static graze_status add_polygons(soup *s, graze_context *context, const ring *rings, size_t count) {
    for (size_t r = 0; r < count; r++) {
        if (rings[r].parent != r)
            continue;
        TRY(soup_add_facet(s, context));
        TRY(add_ring(s, context, &rings[r]));
        for (size_t q = 0; q < count; q++)
            if (q != r && rings[q].parent == r)
                TRY(add_ring(s, context, &rings[q]));
    }
    return GRAZE_OK;
}

/* Refuse a ring of area zero, and name the edges in which it crosses itself, if any. The soup
 * cannot be used afterwards. */
static graze_status refuse_flat(soup *s, graze_context *context, const ring *r, size_t number) {
    graze_status status = soup_add_facet(s, context);
    if (!status)
        status = add_ring(s, context, r);
    if (!status)
        status = validate_crossing(context, s, s->cycle_count - 1);
    if (!status)
        status = context_fail(context, GRAZE_EILLEGAL,
                              "the ring's area is zero; expected a ring around an area");
    return context_item(context, status, "facet", number, NULL);
}

graze_status nesting_add_rings(soup *s, graze_context *context, const size_t *size,
                               size_t ring_count, const size_t *index, const int axis[2]) {
    FREED(ring, rings, calloc(ring_count + 1, sizeof *rings));
    if (!rings)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory");
    LOCAL_VEC(fmpq, boxes, (slong)(4 * ring_count));
    for (size_t r = 0; r < ring_count; r++) {
        rings[r] = (ring){index, size[r], 0, boxes + 4 * r, 0, r, axis};
        index += size[r];
        bound(s, &rings[r]);
        int sign = ring_orientation(s, &rings[r]);
        rings[r].ccw = sign >= 0;
        if (sign == 0)
            return refuse_flat(s, context, &rings[r], r);
    }
    TRY(find_depths(rings, ring_count, context, s));
    return add_polygons(s, context, rings, ring_count);
}
