/* Rings in one another, components and holes (proofs/outline.md C141).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "questions/outline/arc_complex.h"

/* A ray from a point in the direction in which the coordinate `along` grows, and a box that holds
 * it. It meets no end of a boundary piece. */
typedef struct ray {
    graze_outline *o;
    graze_context *context;
    fmpq *at;
    int along;
    box around;
} ray;

/* Count the crossings of a piece with the ray. */
static graze_status cross_piece(int *out, const ray *r, const outline_piece *p) {
    graze_outline *o = r->o;
    outline_curve *c = &o->curve[p->curve];
    int axis = 1 - r->along;
    HELD(algebraic_list, places);
    if (box_meets(&p->box, &r->around))
        TRY(outline_crossings(&places, o, r->context, c, piece_end(o, p, 0), piece_end(o, p, 1),
                              axis, r->at + axis));
    for (size_t k = 0; k < places.count; k++) {
        int side;
        TRY(outline_side(&side, o, r->context, c, &places.item[k], r->along, r->at + r->along));
        *out += side > 0;
    }
    return GRAZE_OK;
}

static graze_status ring_holds(int *out, const ray *r, const outline_ring *ring) {
    const graze_outline *o = r->o;
    int crossings = 0;
    for (size_t k = ring->first; k < ring->first + ring->count; k++) {
        const outline_arc *arc = &o->arc[o->ring_arc[k]];
        for (size_t i = arc->first; i < arc->first + arc->count; i++)
            TRY(cross_piece(&crossings, r, &o->piece[o->arc_piece[i]]));
    }
    *out = crossings & 1;
    return GRAZE_OK;
}

/* Set a ray from a point beside a piece, in the set, on the piece's crossing segment, across which
 * the ray runs. The point is the segment's end or nearer to the piece, so that the ray meets no
 * point of the boundary at which pieces end. */
static graze_status set_ray(ray *r, const outline_piece *p) {
    graze_outline *o = r->o;
    LOCAL_VEC(fmpq, half, 2);
    HELD(bracket, level);
    vector_set(r->at, p->sample, 2);
    int axis = fmpq_equal(&p->sample[0], &p->sample[2]) ? 1 : 0;
    r->along = 1 - axis;
    fmpq_sub(half, &p->sample[2 + axis], r->at + axis);
    fmpq_div_2exp(half, half, 2); /* half of the way to the piece */
    for (slong n = 1;; n++) {
        int meets = 0;
        bracket_set_rational(&level, r->at + axis, POINT_PLACES);
        for (size_t k = 0; k < o->point_count && !meets; k++)
            meets = bracket_meets(&level, &o->point[k].place[axis]);
        if (!meets)
            break;
        if ((size_t)n > o->point_count + 1)
            return context_limit(r->context, GRAZE_LIMIT_BITS, "the places of a ray");
        fmpq_set_si(half + 1, n, (ulong)n + 1);
        fmpq_mul(half + 1, half + 1, half);
        fmpq_add(r->at + axis, &p->sample[axis], half + 1);
    }
    box_empty(&r->around);
    box_add_point(&r->around, r->at);
    r->around.high[r->along] = INFINITY;
    return GRAZE_OK;
}

/* Is the area of ring a less than that of ring b, which holds it or is held by it? */
static int is_less(const outline_ring *a, const outline_ring *b) {
    return a->area.is_exact && b->area.is_exact
               ? fmpq_cmp(a->area.exact, b->area.exact) < 0
               : fmpz_cmp(a->area.bounds.high, b->area.bounds.low) < 0;
}

/* The least ring around a ring of a walk that bounds a hole alone. */
static graze_status find_around(graze_outline *o, graze_context *context, outline_ring *hole) {
    LOCAL_VEC(fmpq, at, 2);
    ray r = {.o = o, .context = context, .at = at};
    TRY(set_ray(&r, &o->piece[o->arc_piece[o->arc[o->ring_arc[hole->first]].first]]));
    size_t found = OUTLINE_NONE;
    for (size_t k = 0; k < o->ring_count; k++) {
        int holds = 0;
        if (o->ring[k].hole)
            continue;
        TRY(ring_holds(&holds, &r, &o->ring[k]));
        if (holds && (found == OUTLINE_NONE || is_less(&o->ring[k], &o->ring[found])))
            found = k;
    }
    if (found == OUTLINE_NONE)
        return context_fail(context, GRAZE_EINTERNAL, "a hole of the outline is in no ring");
    hole->within = found;
    return GRAZE_OK;
}

/* Find the ring around each hole: the other ring of its walk, if that has one. */
static graze_status find_nesting(graze_outline *o, graze_context *context) {
    for (size_t k = 0; k < o->ring_count; k++) {
        outline_ring *ring = &o->ring[k];
        if (!ring->hole)
            continue;
        ring->within = OUTLINE_NONE;
        for (size_t i = 0; i < o->ring_count; i++)
            if (o->ring[i].walk == ring->walk && !o->ring[i].hole)
                ring->within = i;
        if (ring->within == OUTLINE_NONE)
            TRY(find_around(o, context, ring));
    }
    return GRAZE_OK;
}

/* The vertices of the complex of arcs. */
static graze_status count_vertices(graze_outline *o, graze_context *context) {
    FREED(unsigned char, seen, calloc(o->point_count + 1, 1));
    if (!seen)
        return context_fail(context, GRAZE_ESYSTEM, "out of memory for an outline");
    for (size_t k = 0; k < o->arc_count; k++) {
        seen[o->arc[k].from] = seen[o->arc[k].to] = 1;
    }
    for (size_t k = 0; k < o->point_count; k++)
        o->vertex_count += seen[k];
    return GRAZE_OK;
}

graze_status outline_nesting(graze_outline *o, graze_context *context) {
    for (size_t k = 0; k < o->ring_count; k++) {
        o->ring[k].hole = outline_sign(&o->ring[k].area) < 0;
        o->interior_components += !o->ring[k].hole;
    }
    for (size_t i = 0; i < o->ring_count; i++)
        for (size_t k = 0; k < i; k++)
            if (o->ring[i].walk == o->ring[k].walk && !o->ring[i].hole && !o->ring[k].hole)
                return context_fail(context, GRAZE_EINTERNAL, "a walk has two outer rings");
    for (size_t k = 0; k < o->around_count; k++)
        *(outline_sign(&o->around[k].area) > 0 ? &o->components : &o->holes) += 1;
    o->euler = (long)o->components - (long)o->holes;
    TRY(count_vertices(o, context));
    long faces = (long)o->interior_components, walks = (long)o->walk_count;
    if (o->euler != (long)o->vertex_count - (long)o->arc_count + 2 * faces - walks)
        return context_fail(context, GRAZE_EINTERNAL,
                            "two counts of the Euler characteristic differ");
    if (outline_sign(&o->area) < 0)
        return context_fail(context, GRAZE_EINTERNAL, "the area of an outline is negative");
    return find_nesting(o, context);
}
