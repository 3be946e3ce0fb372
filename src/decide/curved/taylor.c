/* Expansions of surfaces at a point of the trajectory.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/context/scope.h"
#include "decide/curved/arrangement.h"

static const fmpq_poly_t no_value = {{.den = {1}}}; /* zero */

void taylor_init(taylor *t, moment_field *f, int dimension) {
    *t = (taylor){.dimension = dimension, .coefficient = field_vector(f, TAYLOR_TERMS)};
}

void taylor_clear(taylor *t) {
    field_vector_clear(t->coefficient, TAYLOR_TERMS);
}

/* The coefficient of a power; if there is none yet, a zero is appended. */
static value *taylor_at(taylor *t, const int power[3]) {
    for (size_t k = 0; k < t->count; k++)
        if (t->power[k][0] == power[0] && t->power[k][1] == power[1] && t->power[k][2] == power[2])
            return t->coefficient + k;
    for (int i = 0; i < 3; i++)
        t->power[t->count][i] = (unsigned char)power[i];
    fmpq_poly_zero(t->coefficient + t->count);
    return t->coefficient + t->count++;
}

/* Drop the terms whose coefficients are zero. */
static void taylor_normalise(taylor *t) {
    size_t kept = 0;
    for (size_t k = 0; k < t->count; k++) {
        if (fmpq_poly_is_zero(t->coefficient + k))
            continue;
        fmpq_poly_swap(t->coefficient + kept, t->coefficient + k);
        memmove(t->power[kept], t->power[k], sizeof t->power[k]);
        kept++;
    }
    t->count = kept;
}

void taylor_point_init(taylor_point *p, moment_field *f, const trajectory *c, int degree) {
    int d = c->dimension;
    *p = (taylor_point){field_vector(f, (size_t)((d + 1) * (degree + 1))), d, degree};
    for (int i = 0; i <= d && p->power; i++) {
        value *x = p->power + i * (degree + 1);
        fmpq_poly_set_si(x, 1);
        field_set(x + 1, f, &c->x[i]);
        for (int k = 2; k <= degree; k++)
            field_mul(x + k, f, x + k - 1, x + 1);
    }
}

void taylor_point_clear(taylor_point *p) {
    field_vector_clear(p->power, (size_t)((p->dimension + 1) * (p->degree + 1)));
}

const value *taylor_power(const taylor_point *p, int i, int k) {
    return p->power + i * (p->degree + 1) + k;
}

static slong binomial(int n, int k) {
    slong value = 1;
    for (int i = 0; i < k; i++)
        value = value * (n - i) / (i + 1);
    return value;
}

/* Add one term of a surface: (X + v)^power W^(degree - |power|), times its coefficient. */
static void expand_term(taylor *out, moment_field *f, const taylor_point *p, const csg_surface *s,
                        size_t term) {
    const unsigned char *a = s->power[term];
    int d = p->dimension, rest = s->degree - a[0] - a[1] - a[2], k[3];
    LOCAL(fmpq_poly, product);
    for (k[0] = 0; k[0] <= a[0]; k[0]++)
        for (k[1] = 0; k[1] <= a[1]; k[1]++)
            for (k[2] = 0; k[2] <= a[2]; k[2]++) {
                if (k[0] + k[1] + k[2] == 0)
                    continue;
                fmpq_poly_set_fmpz(product, s->coefficient + term);
                field_mul(product, f, product, taylor_power(p, d, rest));
                for (int i = 0; i < d; i++) {
                    field_mul(product, f, product, taylor_power(p, i, a[i] - k[i]));
                    fmpq_poly_scalar_mul_si(product, product, binomial(a[i], k[i]));
                }
                value *at = taylor_at(out, k);
                fmpq_poly_add(at, at, product);
            }
}

void taylor_of_surface(taylor *out, moment_field *f, const taylor_point *p,
                       const csg_surface *surface) {
    out->count = 0;
    out->degree = surface->degree;
    for (size_t k = 0; k < surface->count; k++)
        expand_term(out, f, p, surface, k);
    taylor_normalise(out);
}

const value *taylor_gradient(const taylor *t, int i) {
    for (size_t k = 0; k < t->count; k++)
        if (t->power[k][0] + t->power[k][1] + t->power[k][2] == 1 && t->power[k][i] == 1)
            return t->coefficient + k;
    return no_value;
}

int taylor_order(const taylor *t) {
    int least = 0;
    for (size_t k = 0; k < t->count; k++) {
        int degree = t->power[k][0] + t->power[k][1] + t->power[k][2];
        least = least == 0 || degree < least ? degree : least;
    }
    return least;
}

/* out += sign da/di db/dj */
static void add_derivatives(taylor *out, moment_field *f, const taylor *a, int i, const taylor *b,
                            int j, int sign) {
    LOCAL(fmpq_poly, product);
    for (size_t k = 0; k < a->count; k++)
        for (size_t m = 0; m < b->count; m++) {
            int power[3], factor = sign * a->power[k][i] * b->power[m][j];
            if (factor == 0)
                continue;
            for (int n = 0; n < 3; n++)
                power[n] = a->power[k][n] + b->power[m][n] - (n == i) - (n == j);
            field_mul(product, f, a->coefficient + k, b->coefficient + m);
            fmpq_poly_scalar_mul_si(product, product, factor);
            value *at = taylor_at(out, power);
            fmpq_poly_add(at, at, product);
        }
}

void taylor_minor(taylor *out, moment_field *f, const taylor *a, const taylor *b, int i, int j) {
    out->count = 0;
    out->degree = a->degree + b->degree - 2;
    add_derivatives(out, f, a, i, b, j, 1);
    add_derivatives(out, f, a, j, b, i, -1);
    taylor_normalise(out);
}

/* out += factor a, or -= */
static void add_multiple(taylor *out, moment_field *f, const value *factor, const taylor *a,
                         int minus) {
    for (size_t k = 0; k < a->count; k++) {
        int power[3] = {a->power[k][0], a->power[k][1], a->power[k][2]};
        value *at = taylor_at(out, power);
        if (minus)
            field_submul(at, f, factor, a->coefficient + k);
        else
            field_addmul(at, f, factor, a->coefficient + k);
    }
}

void taylor_combine(taylor *out, moment_field *f, const value *factor, const taylor *a,
                    const value *other, const taylor *b) {
    out->count = 0;
    out->degree = a->degree > b->degree ? a->degree : b->degree;
    add_multiple(out, f, factor, a, 0);
    add_multiple(out, f, other, b, 1);
    taylor_normalise(out);
}
