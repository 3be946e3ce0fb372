/* Products of Bernstein coefficients are convolutions when each is multiplied by its binomial.
 * Bounds are those of proofs/surfaces.md (C105). SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "decide/surfaces/surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/context/array.h"

#define U UNIT_ROUNDING
#define SLACK FILTER_SLACK

/* Larger coordinates are left to the exact path, so that products stay in the range of doubles; and
 * a bound of all that underflow can add to a pullback. */
#define COORDINATE_REACH 0x1p60
#define PULLBACK_FLOOR 0x1p-700

void surface_curve_begin(surface_curve *m, const surface_filter *filter, const curve *curve) {
    m->filter = filter;
    m->curve = curve;
    m->stride = (size_t)(filter->degree * filter->course.degree + 1);
    m->known = m->count = 0;
}

void surface_curve_clear(surface_curve *m) {
    free(m->of_span);
    free(m->products);
    free(m->at);
}

/* The index of a span's products, new ones if it has none yet; SIZE_MAX if memory runs out. */
static size_t products_of(surface_curve *m, uint32_t span_index) {
    if (!array_reserve(&m->of_span, &m->known_room, span_index + 1, sizeof *m->of_span))
        return SIZE_MAX;
    while (m->known <= span_index)
        m->of_span[m->known++] = 0;
    if (!m->of_span[span_index]) {
        size_t each = (size_t)m->filter->product_count * m->stride;
        if (!array_reserve(&m->products, &m->count_room, m->count + 1, sizeof *m->products) ||
            !array_reserve(&m->at, &m->room, (m->count + 1) * each, sizeof *m->at))
            return SIZE_MAX;
        memset(m->products[m->count].made, 0, PRODUCT_MOST);
        m->of_span[span_index] = (uint32_t)++m->count;
    }
    return m->of_span[span_index] - 1;
}

/* The products of one span. */
typedef struct maker {
    const surface_curve *m;
    const span *piece;
    span_products *products;
    double *at;
} maker;

static double *product_coefficients(const maker *make, int k) {
    return make->at + (size_t)k * make->m->stride;
}

static void make_coordinate(const maker *make, int k, int i) {
    const span *piece = make->piece;
    int n = piece->degree;
    const double *x = curve_coefficients(make->m->curve, piece, i);
    const double *binomial = make->m->filter->binomial[n];
    double *to = product_coefficients(make, k);
    for (int j = 0; j <= n; j++)
        to[j] = binomial[j] * x[j];
    make->products->size[k] = piece->size[i];
    make->products->error[k] = piece->error[i] + U * piece->size[i];
}

static void make_product(const maker *make, int k) {
    const product *p = &make->m->filter->product[k];
    span_products *all = make->products;
    if (all->made[k])
        return;
    all->made[k] = 1;
    if (p->degree == 1) {
        make_coordinate(make, k, p->coordinate);
        return;
    }
    make_product(make, p->parent);
    make_product(make, p->coordinate);
    int n = make->piece->degree, m = (p->degree - 1) * n;
    const double *a = product_coefficients(make, p->parent),
                 *b = product_coefficients(make, p->coordinate);
    double *to = product_coefficients(make, k);
    memset(to, 0, (size_t)(m + n + 1) * sizeof *to);
    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++)
            to[i + j] += a[i] * b[j];
    double size = all->size[p->parent], other = all->size[p->coordinate];
    all->size[k] = size * other;
    all->error[k] = all->error[p->parent] * other + size * all->error[p->coordinate] +
                    (n + 2) * U * size * other;
}

/* Bounds of a product's values. */
typedef struct range {
    double low, high;
} range;

static range multiply_ranges(range a, range b) {
    double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return (range){smaller(smaller(p, q), smaller(r, s)), larger(larger(p, q), larger(r, s))};
}

int surface_sign_on(const surface_filter *filter, size_t surface, const span *piece) {
    const surface_form *form = &filter->surface[surface];
    range of[4];
    int d = filter->course.dimension;
    double low = 0, high = 0, most = 0;
    for (int i = 0; i < d; i++) {
        double end = piece->from[i] + piece->along[i];
        double far = piece->thick[i] + 0x1p-50 * (fabs(piece->from[i]) + fabs(end));
        of[i] = (range){smaller(piece->from[i], end) - far, larger(piece->from[i], end) + far};
        most = larger(most, larger(-of[i].low, of[i].high));
    }
    if (!(most <= COORDINATE_REACH))
        return 0;
    of[d] = (range){1, 1};
    most = 0;
    for (int t = 0; t < form->count; t++) {
        double a = form->coefficient[t];
        range value = {a, a};
        int k = form->product[t];
        for (int degree = filter->product[k].degree; degree > 0; degree--) {
            value = multiply_ranges(value, of[filter->product[k].coordinate]);
            k = filter->product[k].parent;
        }
        low += value.low;
        high += value.high;
        most += larger(fabs(value.low), fabs(value.high));
    }
    double error = 0x1p-40 * most + PULLBACK_FLOOR;
    return low > error ? 1 : high < -error ? -1 : 0;
}

static int within_reach(const span *piece) {
    for (int i = 0; i < 4; i++)
        if (!(piece->size[i] <= COORDINATE_REACH))
            return 0;
    return 1;
}

int surface_curve_pull_back(pullback *out, double *at, surface_curve *m, uint32_t span_index,
                            size_t surface) {
    const surface_form *form = &m->filter->surface[surface];
    const span *piece = &m->curve->spans[span_index];
    size_t which = within_reach(piece) ? products_of(m, span_index) : SIZE_MAX;
    if (which == SIZE_MAX)
        return 0;
    maker make = {m, piece, &m->products[which],
                  m->at + which * (size_t)m->filter->product_count * m->stride};
    int n = form->degree * piece->degree;
    *out = (pullback){.degree = n, .at = at};
    memset(at, 0, (size_t)(n + 1) * sizeof *at);
    for (int t = 0; t < form->count; t++) {
        int k = form->product[t];
        double a = form->coefficient[t];
        make_product(&make, k);
        const double *from = product_coefficients(&make, k);
        for (int j = 0; j <= n; j++)
            at[j] += a * from[j];
        out->error +=
            fabs(a) * (make.products->error[k] + (form->count + 5) * U * make.products->size[k]);
    }
    const double *inverse = m->filter->inverse[n];
    for (int j = 0; j <= n; j++)
        at[j] *= inverse[j];
    out->error = SLACK * out->error + PULLBACK_FLOOR;
    pullback_measure(out);
    return 1;
}
