/* Forms, boxes and the tree of a solid's simplices, and crossings of a ray.
 * SPDX-License-Identifier: MIT
 */
#include "solid.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Bounds of x / w, w > 0. Truncation of the mantissas changes each by less than 2^-51 of itself;
 * the margin is 2^-46 of the quotient and 2^-1000, more than is lost near 0. Beyond the range of
 * doubles the largest double is a bound. */
static void ratio_bounds(double *low, double *high, const mpz_t x, const mpz_t w) {
    long ex, ew;
    double mx = mpz_get_d_2exp(&ex, x), mw = mpz_get_d_2exp(&ew, w), m = mx / mw;
    double margin = fabs(m) * 0x1p-46;
    *low = fmin(scalbln(m - margin, ex - ew) - 0x1p-1000, DBL_MAX);
    *high = fmax(scalbln(m + margin, ex - ew) + 0x1p-1000, -DBL_MAX);
}

const box box_empty = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

static void box_add(box *a, const box *b) {
    for (int i = 0; i < 3; i++) {
        a->low[i] = b->low[i] < a->low[i] ? b->low[i] : a->low[i];
        a->high[i] = b->high[i] > a->high[i] ? b->high[i] : a->high[i];
    }
}

void box_take(box *b, mpz_t *x, int d) {
    box at = {{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < d; i++)
        ratio_bounds(&at.low[i], &at.high[i], x[i], x[d]);
    box_add(b, &at);
}

static int boxes_meet(const box *a, const box *b) {
    for (int i = 0; i < 3; i++)
        if (!(a->low[i] <= b->high[i] && b->low[i] <= a->high[i]))
            return 0;
    return 1;
}

mpz_t *solid_vertex(const solid *s, size_t v) {
    return s->x + v * ((size_t)s->d + 1);
}

void cross(mpz_t *out, mpz_t *a, mpz_t *b) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        work_on(a[j], b[k]);
        work_on(a[k], b[j]);
        mpz_mul(out[i], a[j], b[k]);
        mpz_submul(out[i], a[k], b[j]);
    }
}

int form_value(mpz_t out, mpz_t *form, mpz_t *x, int n) {
    mpz_set_ui(out, 0);
    for (int i = 0; i < n; i++) {
        work_on(form[i], x[i]);
        mpz_addmul(out, form[i], x[i]);
    }
    return mpz_sgn(out);
}

/* Make the plane form: the normal (q - p) x (r - p), in the plane (q - p) x e_3, then the constant.
 */
static void make_plane(simplex *f, const solid *s) {
    int d = s->d;
    mpz_t *p = solid_vertex(s, f->v[0]), *q = solid_vertex(s, f->v[1]),
          *r = solid_vertex(s, f->v[2]);
    mpz_t *a = integers(3), *b = integers(3);
    f->plane = integers(4);
    mpz_set_ui(b[2], 1);
    for (int i = 0; i < d; i++) {
        mpz_sub(a[i], q[i], p[i]);
        if (d == 3)
            mpz_sub(b[i], r[i], p[i]);
    }
    cross(f->plane, a, b);
    form_value(a[0], f->plane, p, d);
    mpz_neg(f->plane[d], a[0]);
    integers_free(a, 3);
    integers_free(b, 3);
    while (f->axis < d && mpz_sgn(f->plane[f->axis]) == 0)
        f->axis++;
    if (f->axis == d)
        give_up("solid: facet %zu has no area, or its fan has a piece that has none; expected what "
                "graze convert writes",
                f->facet);
}

void solid_side(mpz_t *out, const solid *s, const simplex *f, int axis, int k) {
    int d = s->d, next = (k + 1) % d, ahead = d == 2 || mpz_sgn(f->plane[axis]) > 0;
    int b = (axis + 1) % d, c = (axis + d - 1) % d; /* b equals c in the plane */
    mpz_t *p = solid_vertex(s, f->v[ahead ? k : next]),
          *q = solid_vertex(s, f->v[ahead ? next : k]);
    mpz_set_ui(out[axis], 0);
    mpz_set_ui(out[d], 0);
    mpz_sub(out[b], p[c], q[c]);
    mpz_sub(out[c], q[b], p[b]);
    work_on(out[b], p[b]);
    mpz_submul(out[d], out[b], p[b]);
    if (d == 3)
        mpz_submul(out[d], out[c], p[c]);
}

void solid_make_forms(solid *s) {
    if (s->count == 0)
        refute("solid: it has no facets");
    for (size_t i = 0; i < s->count; i++) {
        simplex *f = &s->simplex[i];
        work_allow(SOLID_WORK);
        make_plane(f, s);
        f->box = box_empty;
        for (int v = 0; v < s->d; v++)
            box_take(&f->box, solid_vertex(s, f->v[v]), s->d);
    }
}

static int compare_keys(const void *a, const void *b) {
    double x = ((const simplex *)a)->key, y = ((const simplex *)b)->key;
    return (x > y) - (x < y);
}

/* Build the subtree of n simplices at node `at`; they are split in halves along the box's longest
 * side. */
static void build(solid *s, size_t at, simplex *f, size_t n) {
    box all = box_empty;
    int axis = 0;
    for (size_t i = 0; i < n; i++)
        box_add(&all, &f[i].box);
    s->node[at] = all;
    if (n == 1)
        return;
    for (int i = 1; i < s->d; i++)
        if (all.high[i] - all.low[i] > all.high[axis] - all.low[axis])
            axis = i;
    for (size_t i = 0; i < n; i++)
        f[i].key = f[i].box.low[axis] / 2 + f[i].box.high[axis] / 2;
    qsort(f, n, sizeof *f, compare_keys);
    build(s, at + 1, f, n / 2);
    build(s, at + n / 2 * 2, f + n / 2, n - n / 2);
}

void solid_make_tree(solid *s) {
    s->node = grow(NULL, 2 * s->count, sizeof *s->node);
    build(s, 0, s->simplex, s->count);
}

void list_add(list *l, size_t item) {
    l->item = room_for(l->item, l->count, &l->room, sizeof *l->item);
    l->item[l->count++] = item;
}

/* List the simplices whose boxes meet b, among the n simplices of node `at`, which begin at
 * `first`. */
static void near_below(list *out, const solid *s, const box *b, size_t at, size_t first, size_t n) {
    if (!boxes_meet(&s->node[at], b))
        return;
    if (n == 1) {
        list_add(out, first);
        return;
    }
    near_below(out, s, b, at + 1, first, n / 2);
    near_below(out, s, b, at + n / 2 * 2, first + n / 2, n - n / 2);
}

void solid_near(list *out, const solid *s, const box *b) {
    out->count = 0;
    near_below(out, s, b, 0, 0, s->count);
}

/* Is x on the inner side of all side forms? If `displaced`, x stands for the line through x along
 * the axis, displaced by the infinitesimals (e, e^2). `side` is scratch, d + 2. */
static int is_within(const solid *s, const simplex *f, mpz_t *x, int axis, int displaced,
                     mpz_t *side) {
    int d = s->d, within = 1;
    for (int k = 0; k < d; k++) {
        solid_side(side, s, f, axis, k);
        int sign = form_value(side[d + 1], side, x, d + 1);
        for (int i = 1; i < d && sign == 0 && displaced; i++)
            sign = mpz_sgn(side[(axis + i) % d]);
        within = within && sign >= 0;
    }
    return within;
}

int solid_ray(long *sum, const solid *s, mpz_t *x, int axis, const simplex *skip) {
    mpz_t *side = integers(5);
    box b = box_empty;
    list found = {0, 0, NULL};
    int d = s->d, off = 1;
    box_take(&b, x, d);
    b.high[axis] = HUGE_VAL;
    solid_near(&found, s, &b);
    *sum = 0;
    for (size_t k = 0; k < found.count; k++) {
        const simplex *f = &s->simplex[found.item[k]];
        if (f == skip || !off)
            continue;
        work_allow(SOLID_WORK);
        int sign = form_value(side[d + 1], f->plane, x, d + 1), way = mpz_sgn(f->plane[axis]);
        if (sign == 0)
            off = !is_within(s, f, x, f->axis, 0, side);
        else if (sign == -way && is_within(s, f, x, axis, 1, side))
            *sum += way;
    }
    free(found.item);
    integers_free(side, 5);
    return off;
}
