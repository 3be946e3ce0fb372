/* Cuts simplices of the boundary by the signs of g, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The cuts leave a convex polygon, which may be a segment or a point. Its point nearest to a given
 * point is the foot of the given point in the simplex's plane, if the foot lies in the polygon,
 * else a point of the polygon's border.
 */
#include "questions/contact/contact.h"

#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "input/solid/solid.h"
#include "input/validate/validate.h"
#include "questions/contact/nearby.h"

/* A triangle's three corners, and at most one more for each cut. */
enum { POLYGON_CORNERS = 8 };

/* The part of a simplex that the cuts leave; before them, `corner` has the simplex's corners.
 * `normal` is the simplex's outward normal. */
typedef struct polygon {
    int dimension, count;
    const speed *speed;
    const fmpq *simplex[3];
    fmpq *normal, *corner; /* d of each */
} polygon;

static fmpq *corner_of(const polygon *p, int k) {
    return p->corner + (size_t)k * (size_t)p->dimension;
}

static void find_normal(polygon *p) {
    int d = p->dimension;
    LOCAL_VEC(fmpq, a, 2 * d);
    fmpq *b = a + d;
    vector_sub(a, p->simplex[1], p->simplex[0], d);
    if (d == 2) {
        fmpq_set(p->normal, a + 1);
        fmpq_neg(p->normal + 1, a);
    } else {
        vector_sub(b, p->simplex[2], p->simplex[0], d);
        vector_cross(p->normal, a, b);
    }
}

/* out = g at y before the time (side 0), -g after it (side 1): >= 0 in the contact set. */
static void condition(fmpq_t out, const polygon *p, int side, const fmpq *y) {
    speed_along(out, p->speed, side, p->normal, y);
    if (side)
        fmpq_neg(out, out);
}

/* The point of the segment from a to b at which the condition, x at a and z at b, is 0. */
static void put_crossing(fmpq *out, const fmpq *a, const fmpq *b, const fmpq_t x, const fmpq_t z,
                         int d) {
    LOCAL_VEC(fmpq, part, 2);
    fmpq *step = part + 1;
    fmpq_sub(part, x, z);
    fmpq_div(part, x, part);
    for (int i = 0; i < d; i++) {
        fmpq_sub(step, b + i, a + i);
        fmpq_set(out + i, a + i);
        fmpq_addmul(out + i, part, step);
    }
}

/* Cut the polygon to the part with a condition that is not negative. */
static void cut_polygon(polygon *p, int side) {
    int d = p->dimension, kept = 0;
    LOCAL_VEC(fmpq, out, POLYGON_CORNERS * d);
    LOCAL_VEC(fmpq, here, 2);
    fmpq *next = here + 1;
    for (int k = 0; k < p->count; k++) {
        const fmpq *a = corner_of(p, k), *b = corner_of(p, (k + 1) % p->count);
        condition(here, p, side, a);
        condition(next, p, side, b);
        if (fmpq_sgn(here) >= 0) {
            for (int i = 0; i < d; i++)
                fmpq_set(out + kept * d + i, a + i);
            kept++;
        }
        if (fmpq_sgn(here) * fmpq_sgn(next) < 0)
            put_crossing(out + d * kept++, a, b, here, next, d);
    }
    for (int k = 0; k < kept * d; k++)
        fmpq_swap(p->corner + k, out + k);
    p->count = kept;
}

/* Is a point of the simplex's plane in the triangle? */
static int is_in_triangle(const polygon *p, const fmpq *y) {
    LOCAL_VEC(fmpq, along, 9);
    fmpq *way = along + 3, *across = way + 3;
    int inside = 1;
    LOCAL(fmpq, turn);
    for (int k = 0; k < 3 && inside; k++) {
        vector_sub(along, p->simplex[(k + 1) % 3], p->simplex[k], 3);
        vector_sub(way, y, p->simplex[k], 3);
        vector_cross(across, along, way);
        _fmpq_vec_dot(turn, across, p->normal, 3);
        inside = fmpq_sgn(turn) >= 0;
    }
    return inside;
}

static int holds_conditions(const polygon *p, const fmpq *y) {
    int holds = 1;
    LOCAL(fmpq, value);
    for (int side = 0; side < 2 && holds; side++)
        if (p->speed->present[side]) {
            condition(value, p, side, y);
            holds = fmpq_sgn(value) >= 0;
        }
    return holds;
}

/* Try the foot of n->from in the simplex's plane, if the foot lies in the contact set. */
static void try_foot(nearby *n, const polygon *p) {
    LOCAL_VEC(fmpq, foot, 3);
    LOCAL_VEC(fmpq, height, 2);
    fmpq *square = height + 1;
    vector_sub(foot, p->simplex[0], n->from, 3);
    _fmpq_vec_dot(height, foot, p->normal, 3);
    _fmpq_vec_dot(square, p->normal, p->normal, 3);
    fmpq_div(height, height, square);
    for (int i = 0; i < 3; i++) {
        fmpq_set(foot + i, n->from + i);
        fmpq_addmul(foot + i, height, p->normal + i);
    }
    if (is_in_triangle(p, foot) && holds_conditions(p, foot))
        nearby_try(n, foot);
}

void facet_slice_try(nearby *n, const graze_solid *solid, size_t simplex, const speed *s) {
    int d = s->dimension;
    LOCAL_VEC(fmpq, normal, d);
    LOCAL_VEC(fmpq, corner, POLYGON_CORNERS * d);
    polygon p = {.dimension = d, .count = d, .speed = s, .normal = normal, .corner = corner};
    for (int k = 0; k < d; k++) {
        p.simplex[k] = solid->input.coordinates + solid->cut.item[simplex].vertex[k] * (size_t)d;
        for (int i = 0; i < d; i++)
            fmpq_set(corner_of(&p, k) + i, p.simplex[k] + i);
    }
    find_normal(&p);
    for (int side = 0; side < 2; side++)
        if (s->present[side])
            cut_polygon(&p, side);
    for (int k = 0; k < p.count; k++)
        nearby_try_segment(n, corner_of(&p, k), corner_of(&p, (k + 1) % p.count));
    if (d == 3 && p.count)
        try_foot(n, &p);
}
