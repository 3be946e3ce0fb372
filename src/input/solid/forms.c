/* Plane and side forms from rational vertices.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The vertices are multiplied by one common denominator w, so that all products are of integers; a
 * form c . X + m W through the scaled point w p becomes (w c) . X + m W through p.
 */
#include "input/solid/solid.h"

#include "base/context/scope.h"
#include "base/number/vector.h"

/* The vertices of a simplex times a common denominator, which is positive. */
typedef struct scaled_simplex {
    int dimension;
    fmpz_t common;
    fmpz at[9]; /* coordinate i of vertex k at k * dimension + i */
} scaled_simplex;

/* Scale the vertices, with coordinate `dropped` set to 0; -1 drops none. */
static void scale(scaled_simplex *s, const fmpq *const *vertex, int dimension, int dropped) {
    fmpq borrowed[9]; /* the coordinates, 0 for those left out */
    for (int k = 0; k < dimension; k++)
        for (int i = 0; i < dimension; i++)
            borrowed[k * dimension + i] = i == dropped ? (fmpq){0, 1} : vertex[k][i];
    s->dimension = dimension;
    fmpz_init(s->common);
    for (int k = 0; k < dimension * dimension; k++)
        fmpz_init(s->at + k);
    _fmpq_vec_get_fmpz_vec_fmpz(s->at, s->common, borrowed, dimension * dimension);
}

static void scaled_clear(scaled_simplex *s) {
    fmpz_clear(s->common);
    for (int k = 0; k < s->dimension * s->dimension; k++)
        fmpz_clear(s->at + k);
}

/* Complete coefficients c of the scaled coordinates to coprime integers of a form that vanishes at
 * the vertex p. Once c is coprime, every common divisor of the form's coefficients divides
 * `common`. */
static void finish_forms(fmpz *c, const scaled_simplex *s, const fmpz *p) {
    int d = s->dimension;
    LOCAL(fmpz, g);
    _fmpz_vec_content(g, c, d);
    if (!fmpz_is_one(g))
        _fmpz_vec_scalar_divexact_fmpz(c, c, d, g);
    _fmpz_vec_dot(c + d, c, p, d);
    fmpz_neg(c + d, c + d);
    if (!fmpz_is_one(s->common)) {
        fmpz_gcd(g, s->common, c + d);
        fmpz_divexact(c + d, c + d, g);
        fmpz_divexact(g, s->common, g);
        _fmpz_vec_scalar_mul_fmpz(c, c, d, g);
    }
}

static int first_nonzero(const fmpz *form) {
    int i = 0;
    while (fmpz_is_zero(form + i))
        i++;
    return i;
}

int form_of_plane(fmpz *out, const fmpq *const *vertex, int dimension) {
    scaled_simplex s;
    scale(&s, vertex, dimension, -1);
    const fmpz *p = s.at, *q = p + dimension, *r = q + dimension;
    if (dimension == 3) {
        for (int i = 0; i < 3; i++)
            cross_integers(out + i, p, q, r, (i + 1) % 3, (i + 2) % 3);
    } else {
        fmpz_sub(out, q + 1, p + 1);
        fmpz_sub(out + 1, p, q);
    }
    int facing = fmpz_sgn(out + first_nonzero(out));
    if (facing < 0)
        _fmpz_vec_neg(out, out, dimension);
    finish_forms(out, &s, p);
    scaled_clear(&s);
    return facing;
}

void form_of_side(fmpz *out, const fmpq *const *vertex, const fmpz *plane, int k, int dimension) {
    scaled_simplex s;
    int dropped = first_nonzero(plane);
    int i = (dropped + 1) % dimension, j = (dropped + 2) % dimension;
    scale(&s, vertex, dimension, dropped);
    const fmpz *p = s.at + k * dimension, *q = s.at + (k + 1) % dimension * dimension;
    fmpz_zero(out + dropped);
    if (dimension == 3) {
        LOCAL(fmpz, opposite);
        cross_integers(opposite, p, q, s.at + (k + 2) % 3 * 3, i, j);
        int left = fmpz_sgn(opposite) > 0;
        fmpz_sub(out + i, left ? p + j : q + j, left ? q + j : p + j);
        fmpz_sub(out + j, left ? q + i : p + i, left ? p + i : q + i);
    } else {
        fmpz_sub(out + i, q + i, p + i);
    }
    finish_forms(out, &s, p);
    scaled_clear(&s);
}

int form_sign(const fmpz *form, const fmpz *x, int dimension) {
    LOCAL(fmpz, value);
    _fmpz_vec_dot(value, form, x, dimension + 1);
    return fmpz_sgn(value);
}

int form_compare(const fmpz *a, const fmpz *b, int dimension) {
    for (int i = 0; i <= dimension; i++) {
        int c = fmpz_cmp(a + i, b + i);
        if (c != 0)
            return c;
    }
    return 0;
}
