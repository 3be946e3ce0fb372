/* Boxes of quadrics by the inverse of their matrix. SPDX-License-Identifier: GPL-3.0-or-later */
#include "decide/surfaces/surfaces.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"

/* 2 f = x^T A x + 2 b^T x + 2 c. */
typedef struct quadric {
    int dimension;
    fmpz_mat_t form, linear; /* A; b as a column */
    fmpz_t twice;            /* 2 c */
} quadric;

static void quadric_init(quadric *q, const csg_surface *s, int d) {
    q->dimension = d;
    fmpz_mat_init(q->form, d, d);
    fmpz_mat_init(q->linear, d, 1);
    fmpz_init(q->twice);
    for (size_t k = 0; k < s->count; k++) {
        int of[2], n = 0;
        for (int i = 0; i < d; i++)
            for (int p = 0; p < s->power[k][i]; p++)
                of[n++] = i;
        fmpz *to = n == 2   ? fmpz_mat_entry(q->form, of[0], of[1])
                   : n == 1 ? fmpz_mat_entry(q->linear, of[0], 0)
                            : q->twice;
        fmpz_mul_ui(to, s->coefficient + k, n == 1 || (n == 2 && of[0] != of[1]) ? 1 : 2);
        if (n == 2)
            fmpz_set(fmpz_mat_entry(q->form, of[1], of[0]), to);
    }
}

static void quadric_clear(quadric *q) {
    fmpz_mat_clear(q->form);
    fmpz_mat_clear(q->linear);
    fmpz_clear(q->twice);
}

/* The centre is -A^-1 b; half the side along i is the root of (b^T A^-1 b - 2 c) (A^-1)_ii. */
static void bound_quadric(box *out, const quadric *q, const fmpz_mat_t inverse,
                          const fmpz_t denominator) {
    double low, high, below, above;
    LOCAL(fmpz_mat, centre, q->dimension, 1);
    LOCAL(fmpz, size);
    LOCAL(fmpq, value);
    fmpz_mat_mul(centre, inverse, q->linear);
    for (int i = 0; i < q->dimension; i++)
        fmpz_addmul(size, fmpz_mat_entry(centre, i, 0), fmpz_mat_entry(q->linear, i, 0));
    fmpz_submul(size, q->twice, denominator);
    *out = (box){{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < q->dimension; i++) {
        fmpq_set_fmpz_frac(value, fmpz_mat_entry(centre, i, 0), denominator);
        rational_bounds(&low, &high, value);
        fmpz_mul(fmpq_numref(value), size, fmpz_mat_entry(inverse, i, i));
        fmpz_mul(fmpq_denref(value), denominator, denominator);
        fmpq_canonicalise(value);
        rational_bounds(&below, &above, value);
        /* If the quadric has no real point, any box will do. */
        double half = above > 0 ? sqrt(above) * (1 + 0x1p-50) : 0;
        out->low[i] = nextafter(-high - half, -INFINITY);
        out->high[i] = nextafter(-low + half, INFINITY);
    }
}

/* Set A^-1 = inverse / denominator with a positive denominator; 0 unless A is positive definite. */
static int invert_form(fmpz_mat_t inverse, fmpz_t denominator, const quadric *q) {
    fmpz_mat_det(denominator, q->form);
    if (fmpz_sgn(denominator) <= 0 || !fmpz_mat_inv(inverse, denominator, q->form))
        return 0;
    /* Sylvester's rule: the leading minor of size d - 1 and the inverse's last entry have one sign.
     */
    int last = q->dimension - 1;
    return fmpz_sgn(denominator) > 0 && fmpz_sgn(fmpz_mat_entry(q->form, 0, 0)) > 0 &&
           fmpz_sgn(fmpz_mat_entry(inverse, last, last)) > 0;
}

int surface_box(box *out, const csg_surface *surface, int dimension) {
    if (surface->degree != 2)
        return 0;
    LOCAL(fmpz, denominator);
    LOCAL(fmpz_mat, inverse, dimension, dimension);
    HELD(quadric, q, surface, dimension);
    int bounded = invert_form(inverse, denominator, &q);
    if (bounded)
        bound_quadric(out, &q, inverse, denominator);
    return bounded;
}
