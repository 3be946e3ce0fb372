/* Forms, boxes and the tree of a solid's simplices, and the ray.
 * SPDX-License-Identifier: MIT
 */
#include "solid.h"

#include <math.h>
#include <stdlib.h>

/* Bounds of x / w, w > 0. The mantissas are cut off, which loses less than 2^-51 each; the margin
 * is 2^-46. */
static void ratio_bounds(double *low, double *high, const mpz_t x, const mpz_t w) {
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

void box_take(box *b, mpz_t *const *x, size_t k, int d, int first) {
    box at = {{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < d; i++)
        ratio_bounds(&at.low[i], &at.high[i], x[i][k], x[d][k]);
    box_add(b, &at, first);
}

static int boxes_meet(const box *a, const box *b) {
    for (int i = 0; i < 3; i++)
        if (!(a->low[i] <= b->high[i] && b->low[i] <= a->high[i]))
            return 0;
    return 1;
}

/* --------------------------------------------------------------------------------------- forms */

static mpz_t *vertex(const solid *s, size_t v) {
    return s->x + v * (size_t)s->d;
}

/* out += sign (q - p) (s - r) */
static void add_product(mpz_t out, int sign, const mpz_t p, const mpz_t q, const mpz_t r,
                        const mpz_t s) {
    mpz_t a, b;
    mpz_inits(a, b, NULL);
    mpz_sub(a, q, p);
    mpz_sub(b, s, r);
    (sign < 0 ? mpz_submul : mpz_addmul)(out, a, b);
    mpz_clears(a, b, NULL);
}

/* (q - p) x (r - p), or in the plane (q - p) turned to the right; then the constant. */
static void make_plane(simplex *f, const solid *s) {
    int d = s->d;
    mpz_t *p = vertex(s, f->v[0]), *q = vertex(s, f->v[1]), *r = vertex(s, f->v[d - 1]);
    f->plane = integers((size_t)d + 1);
    for (int i = 0; i < d; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        if (d == 2) {
            mpz_sub(f->plane[i], i == 0 ? q[1] : p[0], i == 0 ? p[1] : q[0]);
            continue;
        }
        add_product(f->plane[i], 1, p[j], q[j], p[k], r[k]);
        add_product(f->plane[i], -1, p[k], q[k], p[j], r[j]);
    }
    for (int i = 0; i < d; i++)
        mpz_submul(f->plane[d], f->plane[i], p[i]);
    while (f->axis < d && mpz_sgn(f->plane[f->axis]) == 0)
        f->axis++;
    if (f->axis == d)
        give_up("solid: facet %zu has no area, or its fan has a piece that has none; expected what "
                "graze convert writes",
                f->facet);
}

/* One more piece of the fan of a facet: in the plane of the one before, and turned the same way. */
static void check_fan(const solid *s, const simplex *before, const simplex *f) {
    mpz_t *x = vertex(s, f->v[2]), *p = vertex(s, before->v[0]), sum;
    mpz_init(sum);
    for (int i = 0; i < 3; i++)
        mpz_addmul(sum, before->plane[i], x[i]);
    for (int i = 0; i < 3; i++)
        mpz_submul(sum, before->plane[i], p[i]);
    if (mpz_sgn(sum) != 0)
        refute("solid: facet %zu is not planar", f->facet);
    if (mpz_sgn(before->plane[before->axis]) != mpz_sgn(f->plane[before->axis]))
        give_up("solid: facet %zu is not the fan of its first corner; expected what graze convert "
                "writes",
                f->facet);
    mpz_clear(sum);
}

void solid_side(mpz_t *out, const solid *s, const simplex *f, int axis, int k) {
    int d = s->d;
    mpz_t *p = vertex(s, f->v[k]), *q = vertex(s, f->v[(k + 1) % d]);
    for (int i = 0; i <= d; i++)
        mpz_set_ui(out[i], 0);
    if (d == 2) {
        int b = 1 - axis;
        mpz_set_si(out[b], mpz_cmp(q[b], p[b]) > 0 ? 1 : -1);
        mpz_submul(out[2], out[b], p[b]);
        return;
    }
    int b = (axis + 1) % 3, c = (axis + 2) % 3, ahead = mpz_sgn(f->plane[axis]) > 0;
    mpz_sub(out[b], ahead ? p[c] : q[c], ahead ? q[c] : p[c]);
    mpz_sub(out[c], ahead ? q[b] : p[b], ahead ? p[b] : q[b]);
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

/* ---------------------------------------------------------------------------------------- tree */

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
    mpz_t *one = integers(1);
    if (s->count == 0)
        refute("solid: it has no facets");
    keyed *k = grow(NULL, s->count, sizeof *k);
    mpz_set_ui(one[0], 1);
    for (size_t i = 0; i < s->count; i++) {
        simplex *f = &s->simplex[i];
        make_plane(f, s);
        if (s->d == 3 && i > 0 && f->facet == f[-1].facet)
            check_fan(s, f - 1, f);
        for (int v = 0; v < s->d; v++) {
            mpz_t *p = vertex(s, f->v[v]), *x[] = {p, p + 1, s->d == 3 ? p + 2 : one, one};
            box_take(&f->box, x, 0, s->d, v == 0);
        }
        k[i] = (keyed){0, i};
    }
    s->node = grow(NULL, 2 * s->count, sizeof *s->node);
    s->node_count = 1;
    build(s, 0, k, s->count);
    free(k);
    integers_free(one, 1);
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

/* ----------------------------------------------------------------------------------------- ray */

/* The sign of a form without coordinate `axis` at x displaced by (e, e^2). */
static int displaced_sign(const mpz_t *form, const mpz_t *x, int d, int axis) {
    int sign = form_sign(form, x, d);
    for (int k = 1; k < d && sign == 0; k++)
        sign = mpz_sgn(form[(axis + k) % d]);
    return sign;
}

/* Is x, or the line through it along the axis displaced, on the inner side of all side forms? */
static int is_within(const solid *s, const simplex *f, const mpz_t *x, int axis, int displaced) {
    mpz_t *side = integers((size_t)s->d + 1);
    int within = 1;
    for (int k = 0; k < s->d && within; k++) {
        solid_side(side, s, f, axis, k);
        const mpz_t *g = (const mpz_t *)side;
        within = displaced ? displaced_sign(g, x, s->d, axis) > 0 : form_sign(g, x, s->d) >= 0;
    }
    integers_free(side, (size_t)s->d + 1);
    return within;
}

int solid_ray(long *sum, const solid *s, const mpz_t *x, int axis, const simplex *skip) {
    mpz_t *at[4];
    box b;
    list found = {0, 0, NULL};
    int off = 1;
    for (int i = 0; i <= s->d; i++)
        at[i] = (mpz_t *)(x + i);
    box_take(&b, at, 0, s->d, 1);
    b.high[axis] = HUGE_VAL;
    solid_near(&found, s, &b);
    *sum = 0;
    for (size_t k = 0; k < found.count && off; k++) {
        const simplex *f = &s->simplex[found.item[k]];
        if (f == skip)
            continue;
        int sign = form_sign((const mpz_t *)f->plane, x, s->d), way = mpz_sgn(f->plane[axis]);
        if (sign == 0)
            off = !is_within(s, f, x, f->axis, 0);
        else if (sign == -way && is_within(s, f, x, axis, 1))
            *sum += way;
    }
    free(found.item);
    return off;
}
