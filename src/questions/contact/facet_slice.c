/* Nearest points, and cuts of simplices of the boundary by the signs of g, exactly.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The cuts leave a convex polygon, which may be a segment or a point. Its point nearest to a given
 * point is the foot of the given point in the simplex's plane, if the foot lies in the polygon,
 * else a point of the polygon's border.
 */
#include "questions/contact/nearby.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

void nearby_init(nearby *n, const fmpq *from, int dimension) {
    n->dimension = dimension;
    n->found = 0;
    n->from = from;
    n->point = _fmpq_vec_init(dimension);
    fmpq_init(n->square);
}

void nearby_clear(nearby *n) {
    _fmpq_vec_clear(n->point, n->dimension);
    fmpq_clear(n->square);
}

void nearby_try(nearby *n, const fmpq *point) {
    int d = n->dimension;
    LOCAL_VEC(fmpq, way, d);
    LOCAL(fmpq, square);
    vector_sub(way, point, n->from, d);
    _fmpq_vec_dot(square, way, way, d);
    int order = n->found ? fmpq_cmp(square, n->square) : -1;
    if (order < 0 || (order == 0 && vector_compare(point, n->point, d) < 0)) {
        fmpq_swap(n->square, square);
        vector_set(n->point, point, d);
        n->found = 1;
    }
}

/* The foot is at a + s (b - a), s = (from - a)(b - a) / |b - a|^2, held to [0, 1]. */
void nearby_try_segment(nearby *n, const fmpq *a, const fmpq *b) {
    int d = n->dimension;
    LOCAL_VEC(fmpq, along, 3 * d);
    fmpq *way = along + d, *foot = way + d;
    LOCAL_VEC(fmpq, s, 2);
    fmpq *length = s + 1;
    vector_sub(along, b, a, d);
    vector_sub(way, n->from, a, d);
    _fmpq_vec_dot(length, along, along, d);
    _fmpq_vec_dot(s, way, along, d);
    if (fmpq_sgn(s) <= 0) {
        nearby_try(n, a);
    } else if (fmpq_cmp(s, length) >= 0) {
        nearby_try(n, b);
    } else {
        fmpq_div(s, s, length);
        vector_between(foot, a, b, s, d);
        nearby_try(n, foot);
    }
}

/* A triangle's three corners, and at most one more for each cut. */
enum { POLYGON_CORNERS = 8 };

/* The part of a simplex that the cuts leave; before them, `corner` has the simplex's corners. */
typedef struct polygon {
    const graze_solid *solid;
    size_t simplex;
    const site_side *side;
    int dimension, count;
    const fmpz *plane, *normal; /* the simplex's plane form; d integers, outward */
    fmpq *corner;               /* d coordinates each */
} polygon;

static fmpq *corner_of(const polygon *p, int k) {
    return p->corner + (size_t)k * (size_t)p->dimension;
}

/* out = g at y before the time (side 0), -g after it (side 1): >= 0 in the contact set. */
static void condition(fmpq_t out, const polygon *p, int side, const fmpq *y) {
    sides_speed(out, p->side, side, p->normal, y);
    if (side)
        fmpq_neg(out, out);
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
        if (fmpq_sgn(here) >= 0)
            vector_set(out + d * kept++, a, d);
        if (fmpq_sgn(here) * fmpq_sgn(next) < 0)
            vector_zero(out + d * kept++, a, b, here, next, d);
    }
    vector_set(p->corner, out, kept * d);
    p->count = kept;
}

/* Is a point of the simplex's plane in the contact set? */
static int is_in_slice(const polygon *p, const fmpq *y) {
    unsigned zero = 0;
    LOCAL_VEC(fmpz, x, 4);
    LOCAL(fmpq, value);
    _fmpq_vec_get_fmpz_vec_fmpz(x, x + 3, y, 3);
    int holds = solid_holds(&zero, p->solid, p->simplex, p->plane, x);
    for (int side = 0; side < 2 && holds; side++)
        if (p->side[side].present) {
            condition(value, p, side, y);
            holds = fmpq_sgn(value) >= 0;
        }
    return holds;
}

/* Try the foot of n->from in the simplex's plane, if the foot lies in the contact set. */
static void try_foot(nearby *n, const polygon *p) {
    LOCAL_VEC(fmpq, foot, 4);
    fmpq *height = foot + 3;
    LOCAL(fmpz, square);
    vector_sub(foot, solid_corner(p->solid, p->simplex, 0), n->from, 3);
    vector_dot_integers(height, p->normal, foot, 3);
    _fmpz_vec_dot(square, p->normal, p->normal, 3);
    fmpq_div_fmpz(height, height, square);
    for (int i = 0; i < 3; i++) {
        fmpq_mul_fmpz(foot + i, height, p->normal + i);
        fmpq_add(foot + i, foot + i, n->from + i);
    }
    if (is_in_slice(p, foot))
        nearby_try(n, foot);
}

void facet_slice_try(nearby *n, const graze_solid *solid, size_t simplex, const site_side side[2]) {
    int d = solid->input.dimension;
    LOCAL_VEC(fmpz, plane, d + 1);
    LOCAL_VEC(fmpz, normal, d);
    LOCAL_VEC(fmpq, corner, POLYGON_CORNERS * d);
    polygon p = {solid, simplex, side, d, d, plane, normal, corner};
    int facing = solid_plane(plane, solid, simplex);
    _fmpz_vec_scalar_mul_si(normal, plane, d, facing);
    for (int k = 0; k < d; k++)
        vector_set(corner_of(&p, k), solid_corner(solid, simplex, k), d);
    for (int k = 0; k < 2; k++)
        if (side[k].present)
            cut_polygon(&p, k);
    for (int k = 0; k < p.count; k++)
        nearby_try_segment(n, corner_of(&p, k), corner_of(&p, (k + 1) % p.count));
    if (d == 3 && p.count)
        try_foot(n, &p);
}
