/* Forms, boxes and the tree of a solid's simplices, and the ray.
 * SPDX-License-Identifier: MIT
 */
#include "solid.h"

#include <math.h>
#include <stdlib.h>

/* The mantissas are cut off, which loses less than 2^-51 each; the margin is 2^-46. */
void ratio_bounds(double *low, double *high, const mpz_t x, const mpz_t w) {
    long ex, ew;
    double mx = mpz_get_d_2exp(&ex, x), mw = mpz_get_d_2exp(&ew, w), m = mx / mw;
    double margin = fabs(m) * 0x1p-46;
    long e = ex - ew;
    if (e > 900 || e < -900) {
        double large = e > 0 ? 0x1p890 : 0, beyond = e > 0 ? HUGE_VAL : 0x1p-890;
        *low = m < 0 ? -beyond : m > 0 ? large : 0;
        *high = m < 0 ? -large : m > 0 ? beyond : 0;
        return;
    }
    *low = ldexp(m - margin, (int)e);
    *high = ldexp(m + margin, (int)e);
}

static void box_add(box *a, const box *b, int first) {
    for (int i = 0; i < 3; i++) {
        a->low[i] = first || b->low[i] < a->low[i] ? b->low[i] : a->low[i];
        a->high[i] = first || b->high[i] > a->high[i] ? b->high[i] : a->high[i];
    }
}

static int boxes_meet(const box *a, const box *b) {
    for (int i = 0; i < 3; i++)
        if (!(a->low[i] <= b->high[i] && b->low[i] <= a->high[i]))
            return 0;
    return 1;
}

static const mpz_t *vertex(const solid *s, size_t v) {
    return (const mpz_t *)s->x + v * (size_t)s->d;
}

/* (q - p) x (r - p), or in the plane (q - p) turned to the right; then the constant. */
static void make_plane(simplex *f, const solid *s) {
    const mpz_t *p = vertex(s, f->v[0]), *q = vertex(s, f->v[1]);
    const mpz_t *r = s->d == 3 ? vertex(s, f->v[2]) : NULL;
    mpz_t a, b;
    mpz_inits(a, b, NULL);
    for (int i = 0; i < 4; i++)
        mpz_init(f->plane[i]);
    for (int i = 0; i < s->d; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        if (s->d == 2) {
            mpz_sub(f->plane[i], i == 0 ? q[1] : p[0], i == 0 ? p[1] : q[0]);
            continue;
        }
        mpz_sub(a, q[j], p[j]);
        mpz_sub(b, r[k], p[k]);
        mpz_addmul(f->plane[i], a, b);
        mpz_sub(a, q[k], p[k]);
        mpz_sub(b, r[j], p[j]);
        mpz_submul(f->plane[i], a, b);
    }
    for (int i = 0; i < s->d; i++)
        mpz_submul(f->plane[s->d], f->plane[i], p[i]);
    for (f->axis = 0; f->axis < s->d && mpz_sgn(f->plane[f->axis]) == 0;)
        f->axis++;
    if (f->axis == s->d)
        refute("solid: facet %zu has a piece without area or length", f->facet);
    mpz_clears(a, b, NULL);
}

void solid_side(mpz_t *out, const solid *s, const simplex *f, int k) {
    int d = s->d, sign = mpz_sgn(f->plane[f->axis]);
    const mpz_t *p = vertex(s, f->v[k]), *q = vertex(s, f->v[(k + 1) % d]);
    for (int i = 0; i <= d; i++)
        mpz_set_ui(out[i], 0);
    if (d == 2) {
        int b = 1 - f->axis;
        mpz_set_si(out[b], mpz_cmp(q[b], p[b]) > 0 ? 1 : -1);
        mpz_submul(out[2], out[b], p[b]);
        return;
    }
    int b = (f->axis + 1) % 3, c = (f->axis + 2) % 3;
    mpz_sub(out[b], p[c], q[c]);
    mpz_sub(out[c], q[b], p[b]);
    if (sign < 0) {
        mpz_neg(out[b], out[b]);
        mpz_neg(out[c], out[c]);
    }
    mpz_submul(out[3], out[b], p[b]);
    mpz_submul(out[3], out[c], p[c]);
}

int form_sign(const mpz_t *form, const mpz_t *x, int d) {
    mpz_t sum;
    mpz_init(sum);
    for (int i = 0; i <= d; i++)
        mpz_addmul(sum, form[i], x[i]);
    int sign = mpz_sgn(sum);
    mpz_clear(sum);
    return sign;
}

static void make_box(simplex *f, const solid *s) {
    mpz_t one;
    mpz_init_set_ui(one, 1);
    for (int k = 0; k < s->d; k++) {
        box at = {{0, 0, 0}, {0, 0, 0}};
        for (int i = 0; i < s->d; i++)
            ratio_bounds(&at.low[i], &at.high[i], vertex(s, f->v[k])[i], one);
        box_add(&f->box, &at, k == 0);
    }
    mpz_clear(one);
}

typedef struct keyed {
    double key;
    size_t simplex;
} keyed;

static int compare_keys(const void *a, const void *b) {
    double x = ((const keyed *)a)->key, y = ((const keyed *)b)->key;
    return (x > y) - (x < y);
}

/* Fill a node with n simplices; halves along the longest side. */
static void build(solid *s, size_t at, keyed *k, size_t n) {
    box all = {{0, 0, 0}, {0, 0, 0}};
    int axis = 0;
    for (size_t i = 0; i < n; i++)
        box_add(&all, &s->simplex[k[i].simplex].box, i == 0);
    s->node[at] = (node){all, 0, k[0].simplex};
    if (n == 1)
        return;
    for (int i = 1; i < s->d; i++)
        if (all.high[i] - all.low[i] > all.high[axis] - all.low[axis])
            axis = i;
    for (size_t i = 0; i < n; i++) {
        const box *b = &s->simplex[k[i].simplex].box;
        k[i].key = b->low[axis] / 2 + b->high[axis] / 2;
    }
    qsort(k, n, sizeof *k, compare_keys);
    size_t child = s->node_count;
    s->node[at].child = child;
    s->node_count += 2;
    build(s, child, k, n / 2);
    build(s, child + 1, k + n / 2, n - n / 2);
}

void solid_finish(solid *s) {
    if (s->count == 0)
        refute("solid: it has no facets");
    keyed *k = grow(NULL, s->count, sizeof *k);
    for (size_t i = 0; i < s->count; i++) {
        make_plane(&s->simplex[i], s);
        make_box(&s->simplex[i], s);
        k[i] = (keyed){0, i};
    }
    s->node = grow(NULL, 2 * s->count, sizeof *s->node);
    s->node_count = 1;
    build(s, 0, k, s->count);
    free(k);
}

static void near_below(list *out, const solid *s, const box *b, size_t at) {
    const node *n = &s->node[at];
    if (!boxes_meet(&n->box, b))
        return;
    if (n->child) {
        near_below(out, s, b, n->child);
        near_below(out, s, b, n->child + 1);
        return;
    }
    out->item = room_for(out->item, out->count, &out->room, sizeof *out->item);
    out->item[out->count++] = n->simplex;
}

void solid_near(list *out, const solid *s, const box *b) {
    out->count = 0;
    near_below(out, s, b, 0);
}

/* The sign of a form without coordinate `axis` at x displaced by (e, e^2). */
static int displaced_sign(const mpz_t *form, const mpz_t *x, int d, int axis) {
    int sign = form_sign(form, x, d);
    for (int k = 1; k < d && sign == 0; k++)
        sign = mpz_sgn(form[(axis + k) % d]);
    return sign;
}

/* 1 if x, on the plane of f, lies on f. */
static int holds(const solid *s, const simplex *f, const mpz_t *x, mpz_t *side) {
    for (int k = 0; k < s->d; k++) {
        solid_side(side, s, f, k);
        if (form_sign(side, x, s->d) < 0)
            return 0;
    }
    return 1;
}

/* Does the displaced line through x along axis cross f? Its sides are taken along that axis. */
static int line_crosses(const solid *s, const simplex *f, const mpz_t *x, int axis, mpz_t *side) {
    simplex seen = *f;
    seen.axis = axis;
    for (int k = 0; k < s->d; k++) {
        solid_side(side, s, &seen, k);
        if (displaced_sign(side, x, s->d, axis) <= 0)
            return 0;
    }
    return 1;
}

int solid_ray(long *sum, const solid *s, const mpz_t *x, int axis, const simplex *skip) {
    box b = {{0, 0, 0}, {0, 0, 0}};
    list found = {0, 0, NULL};
    mpz_t side[4];
    int off = 1;
    for (int i = 0; i < 4; i++)
        mpz_init(side[i]);
    for (int i = 0; i < s->d; i++)
        ratio_bounds(&b.low[i], &b.high[i], x[i], x[s->d]);
    b.high[axis] = HUGE_VAL;
    solid_near(&found, s, &b);
    *sum = 0;
    for (size_t k = 0; k < found.count && off; k++) {
        const simplex *f = &s->simplex[found.item[k]];
        int at = f == skip ? 0 : form_sign(f->plane, x, s->d);
        if (f == skip)
            continue;
        if (at == 0)
            off = !holds(s, f, x, side);
        else if (at == -mpz_sgn(f->plane[axis]) && line_crosses(s, f, x, axis, side))
            *sum += mpz_sgn(f->plane[axis]);
    }
    for (int i = 0; i < 4; i++)
        mpz_clear(side[i]);
    free(found.item);
    return off;
}
