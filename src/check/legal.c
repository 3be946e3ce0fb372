/* Is the boundary that of a legal solid? proofs/certificate.md, claims K1 to K4.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>
#include "solid.h"

enum { MOST_WEIGHTS = 40 };

typedef struct vec {
    mpz_t x[3];
} vec;

/* Scratch of one check. */
typedef struct work {
    const solid *s;
    vec a[3], b[3], ea[3], eb[3], na, nb, n;
    mpz_t low[2], high[2], value;
} work;

static void work_init(work *w, const solid *s) {
    vec *all[] = {w->a, w->b, w->ea, w->eb};
    w->s = s;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 12; k++)
            mpz_init(all[k / 3][k % 3].x[i]);
        mpz_inits(w->na.x[i], w->nb.x[i], w->n.x[i], NULL);
    }
    mpz_inits(w->low[0], w->low[1], w->high[0], w->high[1], w->value, NULL);
}

static void work_clear(work *w) {
    vec *all[] = {w->a, w->b, w->ea, w->eb};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 12; k++)
            mpz_clear(all[k / 3][k % 3].x[i]);
        mpz_clears(w->na.x[i], w->nb.x[i], w->n.x[i], NULL);
    }
    mpz_clears(w->low[0], w->low[1], w->high[0], w->high[1], w->value, NULL);
}

/* Vertices, edges and normal of a simplex. */
static void load(vec *p, vec *e, vec *n, const solid *s, const simplex *f) {
    for (int k = 0; k < s->d; k++)
        for (int i = 0; i < s->d; i++) {
            size_t from = f->v[k] * (size_t)s->d + (size_t)i;
            size_t to = f->v[(k + 1) % s->d] * (size_t)s->d + (size_t)i;
            mpz_set(p[k].x[i], s->x[from]);
            mpz_sub(e[k].x[i], s->x[to], s->x[from]);
        }
    for (int i = 0; i < s->d; i++)
        mpz_set(n->x[i], f->plane[i]);
}

static void cross(vec *out, const vec *a, const vec *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        mpz_mul(out->x[i], a->x[j], b->x[k]);
        mpz_submul(out->x[i], a->x[k], b->x[j]);
    }
}

static void range(mpz_t low, mpz_t high, work *w, const vec *n, const vec *p, int count) {
    for (int k = 0; k < count; k++) {
        mpz_set_ui(w->value, 0);
        for (int i = 0; i < w->s->d; i++)
            mpz_addmul(w->value, n->x[i], p[k].x[i]);
        if (k == 0 || mpz_cmp(w->value, low) < 0)
            mpz_set(low, w->value);
        if (k == 0 || mpz_cmp(w->value, high) > 0)
            mpz_set(high, w->value);
    }
}

/* Does n separate the relative interiors of the hulls of p and q? Not if n is constant, the same,
 * on both. */
static int separates(work *w, const vec *n, const vec *p, int p_count, const vec *q, int q_count) {
    range(w->low[0], w->high[0], w, n, p, p_count);
    range(w->low[1], w->high[1], w, n, q, q_count);
    if (mpz_cmp(w->low[0], w->high[1]) == 0 && mpz_cmp(w->low[1], w->high[0]) == 0)
        return 0;
    return mpz_cmp(w->high[0], w->low[1]) <= 0 || mpz_cmp(w->high[1], w->low[0]) <= 0;
}

/* The relative interiors of the two loaded simplices are disjoint. */
static int disjoint(work *w) {
    int d = w->s->d;
    if (separates(w, &w->na, w->a, d, w->b, d) || separates(w, &w->nb, w->a, d, w->b, d))
        return 1;
    if (d == 2)
        return separates(w, &w->ea[0], w->a, d, w->b, d);
    for (int k = 0; k < 9; k++) {
        cross(&w->n, &w->ea[k / 3], &w->eb[k % 3]);
        if (separates(w, &w->n, w->a, d, w->b, d))
            return 1;
    }
    for (int k = 0; k < 6; k++) {
        cross(&w->n, &w->na, k < 3 ? &w->ea[k] : &w->eb[k - 3]);
        if (separates(w, &w->n, w->a, d, w->b, d))
            return 1;
    }
    return 0;
}

/* The edge k of a (in the plane its vertex k), which lies in the plane of b: has it a point in the
 * relative interior of b? */
static int rests(work *w, int k) {
    if (w->s->d == 2)
        return !separates(w, &w->eb[0], &w->a[k], 1, w->b, 2);
    vec p[2] = {w->a[k], w->a[(k + 1) % 3]}; /* borrowed */
    for (int i = 0; i < 4; i++) {
        cross(&w->n, &w->nb, i < 3 ? &w->eb[i] : &w->ea[k]);
        if (separates(w, &w->n, p, 2, w->b, 3))
            return 0;
    }
    return 1;
}

/* On which side of b do simplices lie whose edges (vertices) rest in its relative interior? Bit 1:
 * outside, bit 2: inside. */
static int resting_sides(work *w) {
    int d = w->s->d, at[3], out = 0;
    range(w->low[1], w->high[1], w, &w->nb, w->b, 1);
    for (int k = 0; k < d; k++) {
        range(w->low[0], w->high[0], w, &w->nb, &w->a[k], 1);
        at[k] = mpz_cmp(w->low[0], w->low[1]);
    }
    for (int k = 0; k < d; k++) {
        int other = d == 2 ? at[1 - k] : at[(k + 2) % 3];
        if (at[k] == 0 && (d == 2 || at[(k + 1) % 3] == 0) && other != 0 && rests(w, k))
            out |= other > 0 ? 1 : 2;
    }
    return out;
}

/* Claims K1 and K3. */
static void check_pairs(const solid *s) {
    unsigned char *sides = grow(NULL, s->count, 1);
    list found = {0, 0, NULL};
    work w;
    work_init(&w, s);
    memset(sides, 0, s->count);
    for (size_t i = 0; i < s->count; i++) {
        load(w.b, w.eb, &w.nb, s, &s->simplex[i]);
        solid_near(&found, s, &s->simplex[i].box);
        for (size_t k = 0; k < found.count; k++) {
            if (found.item[k] == i)
                continue;
            const simplex *other = &s->simplex[found.item[k]];
            load(w.a, w.ea, &w.na, s, other);
            if (found.item[k] > i && !disjoint(&w))
                refute("solid: facets %zu and %zu have inner points in common", s->simplex[i].facet,
                       other->facet);
            sides[i] |= (unsigned char)resting_sides(&w);
        }
        if (sides[i] == 3)
            give_up("solid: edges (vertices) rest inside facet %zu on both of its sides",
                    s->simplex[i].facet);
    }
    work_clear(&w);
    free(found.item);
    free(sides);
}

/* A side of a simplex: an edge from a to b > a (in the plane a vertex), run through one way or the
 * other. */
typedef struct side {
    size_t a, b;
    int way;
} side;

static int compare_sides(const void *x, const void *y) {
    const side *p = x, *q = y;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    return p->b < q->b ? -1 : p->b > q->b;
}

/* Claim K2. */
static void check_closed(const solid *s) {
    size_t d = (size_t)s->d, n = d * s->count;
    side *all = grow(NULL, n, sizeof *all);
    for (size_t i = 0; i < s->count; i++)
        for (size_t k = 0; k < d; k++) {
            size_t a = s->simplex[i].v[k], b = d == 3 ? s->simplex[i].v[(k + 1) % 3] : a;
            all[d * i + k] =
                (side){a < b ? a : b, a < b ? b : a, (d == 3 ? a < b : k == 0) ? 1 : -1};
        }
    qsort(all, n, sizeof *all, compare_sides);
    long sum = 0;
    for (size_t k = 0; k < n; k++) {
        sum += all[k].way;
        if (k + 1 < n && compare_sides(&all[k], &all[k + 1]) == 0)
            continue;
        if (sum != 0)
            refute("solid: it is not closed at vertices %zu and %zu", all[k].a, all[k].b);
    }
    free(all);
}

/* Claim K4 for one simplex. */
static void check_sides(const solid *s, const simplex *f) {
    mpz_t x[4];
    long sum = 0;
    int off = 0;
    for (int i = 0; i < 4; i++)
        mpz_init(x[i]);
    for (unsigned long k = 1; k <= MOST_WEIGHTS && !off; k++) {
        unsigned long weight = 1;
        for (int i = 0; i <= s->d; i++)
            mpz_set_ui(x[i], 0);
        for (int v = 0; v < s->d; v++, weight *= k) {
            for (int i = 0; i < s->d; i++)
                mpz_addmul_ui(x[i], s->x[f->v[v] * (size_t)s->d + (size_t)i], weight);
            mpz_add_ui(x[s->d], x[s->d], weight);
        }
        off = solid_ray(&sum, s, x, f->axis, f);
    }
    if (!off)
        give_up("solid: no point of facet %zu was found that lies on no other", f->facet);
    if (sum != (mpz_sgn(f->plane[f->axis]) > 0 ? 0 : 1))
        refute("solid: facet %zu does not have the interior on its inner side", f->facet);
    for (int i = 0; i < 4; i++)
        mpz_clear(x[i]);
}

void solid_check(const solid *s) {
    check_closed(s);
    check_pairs(s);
    for (size_t k = 0; k < s->count; k++)
        check_sides(s, &s->simplex[k]);
}
