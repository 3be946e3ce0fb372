/* Tests whether the boundary is that of a legal solid: proofs/certificate.md, claims K1 to K4.
 * SPDX-License-Identifier: MIT
 */
#include "solid.h"

enum { MOST_WEIGHTS = 40 };

/* A simplex: its vertices, its edges from each vertex to the next, its normal. */
typedef struct shape {
    mpz_t *vertex[3], *edge[3], *normal;
} shape;

/* Two simplices, and scratch. */
typedef struct work {
    int d;
    shape a, b;
    mpz_t *n, *value; /* 3; 6 */
} work;

static void load(shape *a, const solid *s, const simplex *f) {
    int d = s->d;
    a->normal = f->plane;
    for (int k = 0; k < d; k++)
        a->vertex[k] = solid_vertex(s, f->v[k]);
    for (int k = 0; k < d * d; k++)
        mpz_sub(a->edge[k / d][k % d], a->vertex[(k / d + 1) % d][k % d], a->vertex[k / d][k % d]);
}

/* Does n separate the relative interiors of b and of the hull of `count` points p? It does if its
 * values at p are all at most, or all at least, those on b, unless all values are equal. */
static int separates(work *w, mpz_t *n, mpz_t *const *p, int count) {
    int below = 1, above = 1, d = w->d;
    for (int k = 0; k < d; k++)
        form_value(w->value[k], n, w->b.vertex[k], d);
    for (int k = 0; k < count; k++)
        form_value(w->value[d + k], n, p[k], d);
    for (int k = 0; k < count * d && (below || above); k++) {
        int order = mpz_cmp(w->value[d + k / d], w->value[k % d]);
        below = below && order <= 0;
        above = above && order >= 0;
    }
    return below != above;
}

static int crossed_separates(work *w, mpz_t *u, mpz_t *v, mpz_t *const *p, int count) {
    cross(w->n, u, v);
    return separates(w, w->n, p, count);
}

/* Does a normal within the plane of b, orthogonal to an edge of a or b, separate b from points p of
 * this plane? */
static int separated_within(work *w, mpz_t *const *p, int count) {
    if (w->d == 2)
        return separates(w, w->b.edge[0], p, count);
    int found = 0;
    for (int k = 0; k < 3; k++)
        found = found || crossed_separates(w, w->b.normal, w->b.edge[k], p, count) ||
                crossed_separates(w, w->b.normal, w->a.edge[k], p, count);
    return found;
}

/* Are the relative interiors of the simplices a and b disjoint? Claim K1. */
static int disjoint(work *w) {
    int d = w->d;
    mpz_t **p = w->a.vertex;
    int found = separates(w, w->a.normal, p, d) || separates(w, w->b.normal, p, d);
    for (int k = 0; k < 9 && d == 3; k++)
        found = found || crossed_separates(w, w->a.edge[k / 3], w->b.edge[k % 3], p, d);
    return found || separated_within(w, p, d);
}

/* If an edge of a (d = 2: a vertex) lies in the plane of b and meets b's relative interior: on
 * which side of b is a? 1: outside, 2: inside, 3: both, by different edges, 0: no such edge. */
static int resting_sides(work *w) {
    int d = w->d, at[3], out = 0;
    for (int k = 0; k < d; k++)
        at[k] = form_value(w->value[0], w->b.normal, w->a.vertex[k], d + 1);
    for (int k = 0; k < d; k++) {
        mpz_t *end[2] = {w->a.vertex[k], w->a.vertex[(k + 1) % d]};
        int other = at[(k + d - 1) % d], lies = at[k] == 0 && (d == 2 || at[(k + 1) % d] == 0);
        if (lies && other != 0 && !separated_within(w, end, d - 1))
            out |= other > 0 ? 1 : 2;
    }
    return out;
}

/* Add to sum[i], for each side i of b, 1 if a side of a runs along it in the same direction, -1 if
 * in the opposite one. In the plane sides are vertices: two at one position count 1 if both are the
 * first or both the last of their segments, else -1. */
static void add_sides(long *sum, const work *w) {
    int d = w->d, same[3][3]; /* same[i][k]: vertices i of b and k of a have one position */
    for (int i = 0; i < d; i++)
        for (int k = 0; k < d; k++) {
            same[i][k] = 1;
            for (int c = 0; c < d && same[i][k]; c++)
                same[i][k] = mpz_cmp(w->b.vertex[i][c], w->a.vertex[k][c]) == 0;
        }
    for (int i = 0; i < d; i++)
        for (int k = 0; k < d; k++) {
            int next = (i + 1) % 3, beyond = (k + 1) % 3;
            if (d == 2)
                sum[i] += i == k ? same[i][k] : -same[i][k];
            else
                sum[i] += (same[i][k] && same[next][beyond]) - (same[i][beyond] && same[next][k]);
        }
}

/* Test claims K1 to K3 for one simplex and the simplices near it. */
static void check_near(work *w, const solid *s, size_t number, const list *near) {
    const simplex *f = &s->simplex[number];
    long sum[3] = {0, 0, 0};
    int sides = 0;
    load(&w->b, s, f);
    for (size_t k = 0; k < near->count; k++) {
        work_allow(SOLID_WORK);
        load(&w->a, s, &s->simplex[near->item[k]]);
        add_sides(sum, w);
        if (near->item[k] > number && !disjoint(w))
            refute("solid: facets %zu and %zu have inner points in common", f->facet,
                   s->simplex[near->item[k]].facet);
        sides |= resting_sides(w);
    }
    for (int k = 0; k < s->d; k++)
        if (sum[k] != 0)
            refute("solid: it is not closed at a side of facet %zu", f->facet);
    if (sides == 3)
        give_up("solid: edges (vertices) rest inside facet %zu on both of its sides", f->facet);
}

/* Test claim K4 for one simplex by a ray from a point of it that lies on no other, one with the
 * weights 1 : k : k^2. */
static void check_sides(const solid *s, const simplex *f) {
    mpz_t *x = integers(4);
    long sum = 0;
    int off = 0;
    for (unsigned long k = 1; k <= MOST_WEIGHTS && !off; k++) {
        unsigned long weight[3] = {1, k, k * k};
        for (int i = 0; i <= s->d; i++) {
            mpz_set_ui(x[i], 0);
            for (int v = 0; v < s->d; v++)
                mpz_addmul_ui(x[i], solid_vertex(s, f->v[v])[i], weight[v]);
        }
        off = solid_ray(&sum, s, x, f->axis, f);
    }
    if (!off)
        give_up("solid: no point of facet %zu was found that lies on no other", f->facet);
    if (sum != (mpz_sgn(f->plane[f->axis]) > 0 ? 0 : 1))
        refute("solid: facet %zu does not have the interior on its inner side", f->facet);
    integers_free(x, 4);
}

void solid_check(const solid *s) {
    work w = {.d = s->d, .n = integers(3), .value = integers(6)};
    list near = {0, 0, NULL};
    for (int k = 0; k < 3; k++) {
        w.a.edge[k] = integers(3);
        w.b.edge[k] = integers(3);
    }
    for (size_t k = 0; k < s->count; k++) {
        solid_near(&near, s, &s->simplex[k].box);
        check_near(&w, s, k, &near);
    }
    for (size_t k = 0; k < s->count; k++)
        check_sides(s, &s->simplex[k]);
}
