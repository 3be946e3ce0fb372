/* Is the boundary that of a legal solid? proofs/certificate.md, claims K1 to K4.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include "solid.h"

enum { MOST_WEIGHTS = 40 };

/* A simplex: its vertices, its edges from each to the next, its normal. */
typedef struct shape {
    mpz_t *vertex[3], *edge[3], *normal;
} shape;

/* Two simplices, and scratch. */
typedef struct work {
    const solid *s;
    shape a, b;
    mpz_t *n, *low, *high, *value; /* low and high: 2 each */
} work;

static void load(shape *a, const solid *s, const simplex *f) {
    int d = s->d;
    a->normal = f->plane;
    for (int k = 0; k < d; k++)
        a->vertex[k] = solid_vertex(s, f->v[k]);
    for (int k = 0; k < d * d; k++)
        mpz_sub(a->edge[k / d][k % d], a->vertex[(k / d + 1) % d][k % d], a->vertex[k / d][k % d]);
}

/* The least and the greatest value of n on `count` points. */
static void range(work *w, int which, mpz_t *n, mpz_t *const *p, int count) {
    for (int k = 0; k < count; k++) {
        form_value(w->value[0], n, p[k], w->s->d);
        if (k == 0 || mpz_cmp(w->value[0], w->low[which]) < 0)
            mpz_set(w->low[which], w->value[0]);
        if (k == 0 || mpz_cmp(w->value[0], w->high[which]) > 0)
            mpz_set(w->high[which], w->value[0]);
    }
}

/* Does n separate the relative interiors of the hulls of b and of `count` points p? Not if n is
 * constant, the same, on both. */
static int separates(work *w, mpz_t *n, mpz_t *const *p, int count) {
    range(w, 0, n, p, count);
    range(w, 1, n, w->b.vertex, w->s->d);
    if (mpz_cmp(w->low[0], w->high[1]) == 0 && mpz_cmp(w->low[1], w->high[0]) == 0)
        return 0;
    return mpz_cmp(w->high[0], w->low[1]) <= 0 || mpz_cmp(w->high[1], w->low[0]) <= 0;
}

static int crossed_separates(work *w, mpz_t *u, mpz_t *v, mpz_t *const *p, int count) {
    cross(w->n, u, v);
    return separates(w, w->n, p, count);
}

/* The relative interiors of the two loaded simplices are disjoint. */
static int disjoint(work *w) {
    int d = w->s->d, found = separates(w, w->a.normal, w->a.vertex, d) ||
                             separates(w, w->b.normal, w->a.vertex, d);
    if (d == 2)
        return found || separates(w, w->a.edge[0], w->a.vertex, d);
    for (int k = 0; k < 9; k++)
        found = found || crossed_separates(w, w->a.edge[k / 3], w->b.edge[k % 3], w->a.vertex, d);
    for (int k = 0; k < 3; k++)
        found = found || crossed_separates(w, w->a.normal, w->a.edge[k], w->a.vertex, d) ||
                crossed_separates(w, w->a.normal, w->b.edge[k], w->a.vertex, d);
    return found;
}

/* The edge k of a (in the plane its vertex k), which lies in the plane of b: has it a point in the
 * relative interior of b? */
static int rests(work *w, int k) {
    mpz_t *p[2] = {w->a.vertex[k], w->a.vertex[(k + 1) % 3]};
    if (w->s->d == 2)
        return !separates(w, w->b.edge[0], p, 1);
    int separated = crossed_separates(w, w->b.normal, w->a.edge[k], p, 2);
    for (int i = 0; i < 3; i++)
        separated = separated || crossed_separates(w, w->b.normal, w->b.edge[i], p, 2);
    return !separated;
}

/* On which side of b do simplices lie whose edges (vertices) rest in its relative interior? Bit 1:
 * outside, bit 2: inside. */
static int resting_sides(work *w) {
    int d = w->s->d, at[3], out = 0;
    range(w, 1, w->b.normal, w->b.vertex, 1);
    for (int k = 0; k < d; k++) {
        range(w, 0, w->b.normal, w->a.vertex + k, 1);
        at[k] = mpz_cmp(w->low[0], w->low[1]);
    }
    for (int k = 0; k < d; k++) {
        int other = at[(k + d - 1) % d], lies = at[k] == 0 && (d == 2 || at[(k + 1) % 3] == 0);
        if (lies && other != 0 && rests(w, k))
            out |= other > 0 ? 1 : 2;
    }
    return out;
}

/* Claims K1 and K3. */
static void check_pairs(const solid *s) {
    list found = {0, 0, NULL};
    work w = {
        .s = s, .n = integers(3), .low = integers(2), .high = integers(2), .value = integers(1)};
    for (int k = 0; k < 3; k++) {
        w.a.edge[k] = integers(3);
        w.b.edge[k] = integers(3);
    }
    for (size_t i = 0; i < s->count; i++) {
        int sides = 0;
        load(&w.b, s, &s->simplex[i]);
        solid_near(&found, s, &s->simplex[i].box);
        for (size_t k = 0; k < found.count; k++) {
            if (found.item[k] == i)
                continue;
            const simplex *other = &s->simplex[found.item[k]];
            load(&w.a, s, other);
            if (found.item[k] > i && !disjoint(&w))
                refute("solid: facets %zu and %zu have inner points in common", s->simplex[i].facet,
                       other->facet);
            sides |= resting_sides(&w);
        }
        if (sides == 3)
            give_up("solid: edges (vertices) rest inside facet %zu on both of its sides",
                    s->simplex[i].facet);
    }
}

/* A side of a simplex: an edge between positions a <= b (in the plane a vertex, a = b), run through
 * one way or the other. */
typedef struct side {
    mpz_t *a, *b;
    size_t facet;
    int d, way;
} side;

/* The order of two positions. */
static int compare(mpz_t *p, mpz_t *q, int d) {
    int order = 0;
    for (int i = 0; i < d; i++)
        order = order != 0 ? order : mpz_cmp(p[i], q[i]);
    return order;
}

static int compare_sides(const void *x, const void *y) {
    const side *p = x, *q = y;
    int order = compare(p->a, q->a, p->d);
    return order != 0 ? order : compare(p->b, q->b, p->d);
}

/* Claim K2. */
static void check_closed(const solid *s) {
    size_t d = (size_t)s->d, n = d * s->count;
    side *all = grow(NULL, n, sizeof *all);
    for (size_t i = 0; i < n; i++) {
        const simplex *f = &s->simplex[i / d];
        mpz_t *a = solid_vertex(s, f->v[i % d]);
        mpz_t *b = d == 3 ? solid_vertex(s, f->v[(i + 1) % d]) : a;
        int ahead = d == 3 ? compare(a, b, 3) < 0 : i % d == 0;
        all[i] = (side){ahead ? a : b, ahead ? b : a, f->facet, s->d, ahead ? 1 : -1};
    }
    qsort(all, n, sizeof *all, compare_sides);
    long sum = 0;
    for (size_t k = 0; k < n; k++) {
        sum += all[k].way;
        if ((k + 1 == n || compare_sides(&all[k], &all[k + 1]) != 0) && sum != 0)
            refute("solid: it is not closed at a side of facet %zu", all[k].facet);
    }
    free(all);
}

/* Claim K4 for one simplex, from its points with the weights 1 : k : k^2. */
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
    check_closed(s);
    check_pairs(s);
    for (size_t k = 0; k < s->count; k++)
        check_sides(s, &s->simplex[k]);
}
