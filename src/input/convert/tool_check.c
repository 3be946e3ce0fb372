/* Decides whether two polyhedra hold a body of revolution between them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Let Q be the polyhedron inside, K the body, R the one outside. At each height the section of Q is
 * rho(z) times a polygon within the unit disc, that of K a disc, that of R rho'(z) times a polygon
 * around the unit disc, with concave rho, so Q and R are convex. Q's profile points lie in the
 * convex profile of K, hence Q in K. Each edge of R's profile has K's profile on its inner side,
 * hence K in R. Every corner of R is within E of a corner of Q; the distance to the convex Q is a
 * convex function, largest on R at a corner: R, and K with it, is within E of Q, and R, which is
 * within E of Q, within E of K.
 */
#include "input/convert/angle.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* The sign of (b - a) x (c - b), which is (b - a) x (c - a). */
static int turn_sign(const fmpq *a, const fmpq *b, const fmpq *c) {
    LOCAL(fmpq, cross);
    cross_rationals(cross, a, b, c, 0, 1);
    return fmpq_sgn(cross);
}

/* 1 if the profile turns left at each inner point, r > 0 at inner points and r >= 0 at both ends,
 * and z increases. */
static int profile_is_convex(const profile *p) {
    int good = p->count > 1;
    for (size_t k = 0; k < p->count; k++) {
        const fmpq *at = p->point + 2 * k;
        int end = k == 0 || k + 1 == p->count;
        good &= fmpq_sgn(at) >= !end;
        good &= end || turn_sign(at - 2, at, at + 2) > 0;
        good &= k == 0 || fmpq_cmp(at - 1, at + 1) < 0;
    }
    return good;
}

/* 1 if the polygon is convex about 0 and in the unit disc, and `stretch` times the polygon contains
 * the disc: the line through each side a b is at least 1 / stretch from 0, that is |a x b| stretch
 * >= |a
 * - b|. */
static int polygon_holds(const tool_pair *p) {
    LOCAL_VEC(fmpq, v, 4);
    int good = 1;
    for (size_t k = 0; k < p->sides && good; k++) {
        const fmpq *a = p->corner + 2 * k, *b = p->corner + 2 * ((k + 1) % p->sides),
                   *c = p->corner + 2 * ((k + 2) % p->sides);
        _fmpq_vec_dot(v, a, a, 2);
        fmpq_one(v + 1);
        good &= fmpq_cmp(v, v + 1) <= 0 && turn_sign(a, b, c) > 0;
        fmpq_mul(v, a, b + 1);
        fmpq_submul(v, a + 1, b);
        good &= fmpq_sgn(v) > 0;
        fmpq_mul(v, v, p->stretch);
        fmpq_mul(v, v, v);
        vector_sub(v + 1, a, b, 2);
        _fmpq_vec_dot(v + 3, v + 1, v + 1, 2);
        good &= fmpq_cmp(v, v + 3) >= 0;
    }
    return good;
}

/* Is the point in the profile of the smallest body? The line of the side bounds the profile, unless
 * it is a ball's, and up to the arc's end the disc of the arc bounds it where r > flat. */
static int in_profile(const fmpq *at, const tool *s) {
    LOCAL_VEC(fmpq, v, 4);
    fmpq_sub(v, at, s->flat);
    fmpq_sub(v + 1, at + 1, s->corner);
    _fmpq_vec_dot(v + 2, v, v, 2);
    fmpq_mul(v + 3, s->corner, s->corner);
    int in_disc = fmpq_cmp(v + 2, v + 3) <= 0, good = fmpq_sgn(at + 1) >= 0;
    fmpq_mul(v + 2, s->corner, s->low + 1);
    int on_arc = s->ball || fmpq_cmp(v + 1, v + 2) <= 0;
    good &= fmpq_cmp(at + 1, s->height) <= 0;
    if (on_arc)
        good &= fmpq_sgn(v) <= 0 || in_disc;
    if (!s->ball) {
        _fmpq_vec_dot(v + 2, v, s->low, 2);
        good &= fmpq_cmp(v + 2, s->corner) <= 0;
    }
    return good;
}

/* Is n (v - a) <= 0? */
static int is_behind(const fmpq *n, const fmpq *a, const fmpq *v) {
    LOCAL_VEC(fmpq, d, 2);
    LOCAL(fmpq, product);
    vector_sub(d, v, a, 2);
    _fmpq_vec_dot(product, n, d, 2);
    return fmpq_sgn(product) <= 0;
}

/* Is the largest body's profile on the inner side of the line from a to b? The profile is the hull
 * of the bottom's and the top's end points and the arc; the arc's disc about c is on the inner side
 * if n (a - c) >= corner |n|. */
static int edge_holds(const fmpq *a, const fmpq *b, const tool *s, const fmpq *top) {
    LOCAL_VEC(fmpq, v, 8);
    fmpq *n = v, *centre = v + 2, *bottom = v + 4;
    fmpq_sub(n, b + 1, a + 1);
    fmpq_sub(n + 1, a, b);
    fmpq_set(centre, s->flat);
    fmpq_set(centre + 1, s->corner);
    fmpq_set(bottom, s->flat);
    int good = is_behind(n, a, bottom) && is_behind(n, a, top) && is_behind(n, a, centre);
    if (!fmpq_is_zero(s->corner)) {
        vector_sub(v + 4, a, centre, 2);
        _fmpq_vec_dot(v + 6, n, v + 4, 2);
        fmpq_mul(v + 6, v + 6, v + 6);
        _fmpq_vec_dot(v + 7, n, n, 2);
        fmpq_mul(v + 7, v + 7, s->corner);
        fmpq_mul(v + 7, v + 7, s->corner);
        good &= fmpq_cmp(v + 6, v + 7) >= 0;
    }
    return good;
}

static int profile_contains(const profile *p, const tool *s) {
    LOCAL_VEC(fmpq, top, 2);
    fmpq *last = p->point + 2 * (p->count - 1);
    LOCAL(fmpq, v);
    fmpq_set(top + 1, s->height);
    if (!s->ball) { /* (corner - (height - corner) n_z) / n_r + flat */
        fmpq_sub(v, s->height, s->corner);
        fmpq_mul(v, v, s->high + 1);
        fmpq_sub(v, s->corner, v);
        fmpq_div(v, v, s->high);
        fmpq_add(top, s->flat, v);
    }
    int good = fmpq_sgn(p->point + 1) <= 0 && fmpq_cmp(p->point, s->flat) >= 0;
    good &= fmpq_cmp(last + 1, s->height) >= 0 && fmpq_cmp(last, top) >= 0;
    for (size_t k = 0; k + 1 < p->count && good; k++)
        good = edge_holds(p->point + 2 * k, p->point + 2 * k + 2, s, top);
    return good;
}

/* The squared distance of two corners, |stretch u R - u r|^2 + (Z - z)^2, is at most (stretch R -
 * r)^2 + (Z - z)^2, as |u| <= 1. */
static void partner_distance(fmpq_t most, const tool_pair *p) {
    LOCAL_VEC(fmpq, d, 2);
    fmpq *e = d + 1;
    fmpq_zero(most);
    for (size_t k = 0; k < p->in.count; k++) {
        fmpq_mul(d, p->stretch, p->out.point + 2 * k);
        fmpq_sub(d, d, p->in.point + 2 * k);
        fmpq_mul(d, d, d);
        fmpq_sub(e, p->out.point + 2 * k + 1, p->in.point + 2 * k + 1);
        fmpq_addmul(d, e, e);
        if (fmpq_cmp(d, most) > 0)
            fmpq_set(most, d);
    }
}

int tool_pair_holds(fmpq_t square, const tool_pair *p, const tool *s, const fmpq_t tolerance) {
    LOCAL(fmpq, most);
    fmpq_mul(most, tolerance, tolerance);
    partner_distance(square, p);
    int good = fmpq_cmp(square, most) <= 0 && polygon_holds(p) && profile_is_convex(&p->in) &&
               profile_is_convex(&p->out) && profile_contains(&p->out, s);
    for (size_t k = 0; k < p->in.count && good; k++)
        good = in_profile(p->in.point + 2 * k, s);
    return good;
}
