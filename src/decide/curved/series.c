/* Power series into surfaces.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The base is combined so that its linear part in the bound coordinates y is a y_i, a the minor of
 * its gradients. With x = a^2 x' and y = a y' each equation, divided by a^2, is y'_i + (terms with
 * x' or of degree two in y'), over the ring: nothing is divided. Iteration gains one order a step.
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

enum { POWERS = TAYLOR_DEGREE + 1, SCALES = 2 * TAYLOR_DEGREE };

/* Find coordinates in which the minor of the base's gradients is not zero, and make them the bound
 * ones; 0 if there are none. */
static int choose_axes(probe *p, moment_field *f, value *minor) {
    int d = p->dimension;
    for (int i = 0; i < d && p->base_count == 1; i++) {
        fmpq_poly_set(minor, taylor_gradient(p->base[0], i));
        p->bound_axis[0] = i;
        if (field_sign(f, minor) != 0)
            return 1;
    }
    for (int i = 0; i < d && p->base_count == 2; i++)
        for (int j = i + 1; j < d; j++) {
            field_mul(minor, f, taylor_gradient(p->base[0], i), taylor_gradient(p->base[1], j));
            field_submul(minor, f, taylor_gradient(p->base[0], j), taylor_gradient(p->base[1], i));
            p->bound_axis[0] = i;
            p->bound_axis[1] = j;
            if (field_sign(f, minor) != 0)
                return 1;
        }
    return p->base_count == 0;
}

int probe_init(probe *p, moment_field *f, int dimension, const taylor *const *base,
               int base_count) {
    *p = (probe){.dimension = dimension, .base_count = base_count, .order = -1};
    for (int i = 0; i < 3; i++)
        fmpq_poly_init(&p->direction[i]);
    for (int i = 0; i < base_count; i++)
        p->base[i] = base[i];
    LOCAL(fmpq_poly, minor);
    int independent = choose_axes(p, f, minor);
    for (int i = 0, open = 0; i < dimension; i++) {
        int bound = 0;
        for (int k = 0; k < base_count; k++)
            bound |= p->bound_axis[k] == i;
        if (!bound)
            p->open_axis[open++] = i;
    }
    return independent;
}

static void forget_series(probe *p) {
    field_vector_clear(p->series, (size_t)p->dimension * (size_t)(p->order + 1));
    p->series = NULL;
    p->order = -1;
}

void probe_clear(probe *p) {
    forget_series(p);
    for (int i = 0; i < 3; i++)
        fmpq_poly_clear(&p->direction[i]);
}

void probe_set_integers(probe *p, const slong *direction) {
    forget_series(p);
    for (int i = 0; i < p->dimension - p->base_count; i++)
        fmpq_poly_set_si(&p->direction[i], direction[i]);
}

/* out = a b, both of n terms */
static void multiply_series(value *out, moment_field *f, const value *a, const value *b, int n) {
    for (int k = 0; k < n; k++) {
        fmpq_poly_zero(out + k);
        for (int i = 0; i <= k; i++)
            field_addmul(out + k, f, a + i, b + k - i);
    }
}

/* The series of a polynomial at series of its d coordinates, each of n terms. `scale`, if any, has
 * the powers of a number: a term of degree x in the open and y in the bound coordinates is
 * multiplied by scale[2 x + y - 2], and terms linear in the bound ones are left out. Series begin
 * with s, so terms of degree n and more do not count. */
static void compose(value *out, moment_field *f, const taylor *of, const value *series, int n,
                    const value *scale, const probe *p) {
    size_t d = (size_t)of->dimension, length = (size_t)n;
    value *power = field_vector(f, (d * POWERS + 2) * length);
    for (size_t k = 0; k < length; k++)
        fmpq_poly_zero(out + k);
    if (!power)
        return;
    value *product = power + d * POWERS * length, *next = product + length;
    for (size_t i = 0; i < d; i++) {
        fmpq_poly_set_si(power + i * POWERS * length, 1);
        for (size_t k = 1; k <= (size_t)of->degree && k < length; k++)
            multiply_series(power + (i * POWERS + k) * length, f,
                            power + (i * POWERS + k - 1) * length, series + i * length, n);
    }
    for (size_t t = 0; t < of->count; t++) {
        int total = 0, bound = 0;
        for (size_t i = 0; i < d; i++)
            total += of->power[t][i];
        for (int k = 0; k < p->base_count; k++)
            bound += of->power[t][p->bound_axis[k]];
        if (total >= n || (scale && total == 1 && bound == 1))
            continue;
        for (size_t k = 0; k < length; k++)
            fmpq_poly_zero(product + k);
        fmpq_poly_set(product, of->coefficient + t);
        if (scale)
            field_mul(product, f, product, scale + 2 * total - bound - 2);
        for (size_t i = 0; i < d; i++) {
            if (of->power[t][i] == 0)
                continue;
            multiply_series(next, f, product, power + (i * POWERS + of->power[t][i]) * length, n);
            for (size_t k = 0; k < length; k++)
                fmpq_poly_swap(product + k, next + k);
        }
        for (size_t k = 0; k < length; k++)
            fmpq_poly_add(out + k, out + k, product + k);
    }
    field_vector_clear(power, (d * POWERS + 2) * length);
}

/* Combine the base to one equation for each bound coordinate, and find the minor of its gradients.
 */
static void combine_base(taylor *equation, value *minor, const probe *p, moment_field *f) {
    const taylor *a = p->base[0], *b = p->base[1];
    int i = p->bound_axis[0], j = p->bound_axis[1];
    LOCAL(fmpq_poly, zero);
    if (p->base_count == 1) {
        fmpq_poly_set_si(minor, 1);
        taylor_combine(&equation[0], f, minor, a, zero, a);
        fmpq_poly_set(minor, taylor_gradient(a, i));
    } else {
        taylor_combine(&equation[0], f, taylor_gradient(b, j), a, taylor_gradient(a, j), b);
        taylor_combine(&equation[1], f, taylor_gradient(a, i), b, taylor_gradient(b, i), a);
        field_mul(minor, f, taylor_gradient(a, i), taylor_gradient(b, j));
        field_submul(minor, f, taylor_gradient(a, j), taylor_gradient(b, i));
    }
}

/* Given the open coordinates of `series`, of n terms, find the bound ones, then multiply both by
 * the powers of the minor, so that they solve the base itself. */
static void solve_base(value *series, const probe *p, moment_field *f, int n) {
    taylor equation[2];
    value *scale = field_vector(f, SCALES);
    value *next = field_vector(f, 2 * (size_t)n);
    for (int k = 0; k < p->base_count; k++)
        taylor_init(&equation[k], f, p->dimension);
    if (f->status == GRAZE_OK) {
        combine_base(equation, scale + 1, p, f);
        fmpq_poly_set_si(scale, 1);
        for (int k = 2; k < SCALES && (k <= 2 || k <= 2 * n - 4); k++)
            field_mul(scale + k, f, scale + k - 1, scale + 1);
    }
    for (int step = 1; step < n && f->status == GRAZE_OK; step++) {
        for (int k = 0; k < p->base_count; k++)
            compose(next + k * n, f, &equation[k], series, n, scale, p);
        for (int k = 0; k < p->base_count; k++)
            for (int m = 0; m < n; m++)
                fmpq_poly_neg(series + p->bound_axis[k] * n + m, next + k * n + m);
    }
    for (int i = 0; i < p->dimension && f->status == GRAZE_OK; i++)
        for (int m = 0; m < n; m++) {
            int bound = 0;
            for (int k = 0; k < p->base_count; k++)
                bound |= p->bound_axis[k] == i;
            field_mul(series + i * n + m, f, series + i * n + m, scale + (bound ? 1 : 2));
        }
    for (int k = 0; k < p->base_count; k++)
        taylor_clear(&equation[k]);
    field_vector_clear(scale, SCALES);
    field_vector_clear(next, 2 * (size_t)n);
}

/* Make the series known up to an order. */
static void extend_series(probe *p, moment_field *f, int order) {
    if (p->order >= order)
        return;
    forget_series(p);
    int n = order + 1;
    p->series = field_vector(f, (size_t)(p->dimension * n));
    if (!p->series)
        return;
    p->order = order;
    for (int i = 0; i < p->dimension - p->base_count; i++)
        fmpq_poly_set(p->series + p->open_axis[i] * n + 1, &p->direction[i]);
    if (p->base_count > 0)
        solve_base(p->series, p, f, n);
}

/* The coefficients of a polynomial along the probe, up to an order; NULL after a failure. */
static value *coefficients(probe *p, moment_field *f, const taylor *of, int order) {
    extend_series(p, f, order);
    if (f->status)
        return NULL;
    value *out = field_vector(f, (size_t)p->order + 1);
    if (out)
        compose(out, f, of, p->series, p->order + 1, NULL, p);
    return out;
}

int probe_first(int *order, probe *p, moment_field *f, const taylor *of, int most) {
    int sign = 0;
    *order = most + 1;
    for (int known = 1, tried = 2; known <= most && sign == 0 && f->status == GRAZE_OK;) {
        int upto = tried < most ? tried : most;
        f->status = context_work(f->context, 100 * (unsigned long)upto);
        value *c = coefficients(p, f, of, upto);
        for (int k = known; c && k <= upto && sign == 0; k++) {
            sign = field_sign(f, c + k);
            *order = sign ? k : *order;
        }
        field_vector_clear(c, (size_t)p->order + 1);
        known = upto + 1;
        tried = 2 * upto;
    }
    return sign;
}

void probe_second(value *out, probe *p, moment_field *f, const taylor *of) {
    value *c = coefficients(p, f, of, 2);
    if (c)
        fmpq_poly_set(out, c + 2);
    field_vector_clear(c, (size_t)p->order + 1);
}
