/* Integer polynomials, and their Bernstein coefficients.
 * SPDX-License-Identifier: MIT
 */
#include "poly.h"

void poly_clear(poly *p) {
    integers_free(p->c, p->room);
    *p = (poly){0, 0, NULL};
}

void poly_extend(poly *p, size_t n) {
    if (n > p->room) {
        p->c = grow(p->c, n, sizeof *p->c);
        for (; p->room < n; p->room++)
            mpz_init(p->c[p->room]);
    }
    for (; p->n < n; p->n++)
        mpz_set_ui(p->c[p->n], 0);
}

void poly_trim(poly *p) {
    while (p->n > 0 && mpz_sgn(p->c[p->n - 1]) == 0)
        p->n--;
}

void poly_set(poly *out, const poly *p) {
    poly_extend(out, p->n);
    for (size_t k = 0; k < p->n; k++)
        mpz_set(out->c[k], p->c[k]);
    out->n = p->n;
}

void poly_add_product(poly *out, const poly *a, const poly *b, int sign) {
    poly_extend(out, a->n + b->n);
    for (size_t i = 0; i < a->n; i++)
        for (size_t j = 0; j < b->n; j++) {
            work_on(a->c[i], b->c[j]);
            (sign < 0 ? mpz_submul : mpz_addmul)(out->c[i + j], a->c[i], b->c[j]);
        }
    poly_trim(out);
}

void poly_add_scaled(poly *out, const poly *a, const mpz_t z) {
    poly_extend(out, a->n);
    for (size_t k = 0; k < a->n; k++) {
        work_on(a->c[k], z);
        mpz_addmul(out->c[k], a->c[k], z);
    }
    poly_trim(out);
}

void poly_scale(poly *p, const mpz_t z) {
    for (size_t k = 0; k < p->n; k++) {
        work_on(p->c[k], z);
        mpz_mul(p->c[k], p->c[k], z);
    }
    poly_trim(p);
}

static void content(mpz_t out, const poly *p) {
    for (size_t k = 0; k < p->n; k++) {
        work_on(out, p->c[k]);
        mpz_gcd(out, out, p->c[k]);
    }
}

void poly_make_primitive(poly *p) {
    mpz_t g;
    mpz_init(g);
    content(g, p);
    for (size_t k = 0; k < p->n; k++) {
        work_on(p->c[k], g);
        mpz_divexact(p->c[k], p->c[k], g);
    }
    mpz_clear(g);
}

/* a -= z t^(a->n - b->n) b, with z such that a's leading coefficient becomes 0. */
static void cancel_lead(poly *a, const poly *b, const mpz_t z) {
    size_t at = a->n - b->n;
    for (size_t k = 0; k < b->n; k++) {
        work_on(z, b->c[k]);
        mpz_submul(a->c[at + k], z, b->c[k]);
    }
    poly_trim(a);
}

int poly_divide(poly *a, const poly *b) {
    poly rest = {0}, quotient = {0};
    poly_set(&rest, a);
    poly_extend(&quotient, a->n);
    while (rest.n >= b->n && mpz_divisible_p(rest.c[rest.n - 1], b->c[b->n - 1])) {
        mpz_t *q = &quotient.c[rest.n - b->n];
        work_on(rest.c[rest.n - 1], b->c[b->n - 1]);
        mpz_divexact(*q, rest.c[rest.n - 1], b->c[b->n - 1]);
        cancel_lead(&rest, b, *q);
    }
    int exact = rest.n == 0;
    poly_trim(&quotient);
    if (exact)
        poly_set(a, &quotient);
    poly_clear(&rest);
    poly_clear(&quotient);
    return exact;
}

void poly_common(poly *out, const poly *a, const poly *b) {
    poly x = {0}, y = {0};
    mpz_t common, lead;
    mpz_inits(common, lead, NULL);
    content(common, a);
    content(common, b);
    poly_set(&x, a);
    poly_set(&y, b);
    while (y.n > 0) { /* x is replaced by the primitive part of its remainder by y; then x and y are
                         swapped */
        while (x.n >= y.n) {
            mpz_set(lead, x.c[x.n - 1]);
            poly_scale(&x, y.c[y.n - 1]);
            cancel_lead(&x, &y, lead);
        }
        poly_make_primitive(&x);
        poly keep = x;
        x = y;
        y = keep;
    }
    poly_make_primitive(&x);
    poly_scale(&x, common);
    poly_set(out, &x);
    poly_clear(&x);
    poly_clear(&y);
    mpz_clears(common, lead, NULL);
}

/* With a = A/D, b = B/D and u = (A + B y) / (D (1 + y)), y from 0 to infinity: D^n (1+y)^n p(u) is
 * the sum of C(n, k) b_k D^n y^k. Horner's scheme computes this polynomial in y: r_n = p_n, r_i =
 * r_(i+1) (A + B y) + p_i (D (1+y))^(n-i). */
void bernstein(mpz_t *out, const poly *p, size_t n, const mpq_t a, const mpq_t b) {
    mpz_t *binomial = integers(n + 1), *end = integers(5); /* A, B, D, D^step, p_i D^step */
    integers_of(end, (mpq_srcptr[]){a, b}, 2);
    mpz_set_ui(end[3], 1);
    mpz_set_ui(binomial[0], 1);
    for (size_t step = 0; step <= n; step++) {
        size_t i = n - step;
        mpz_set_ui(out[step], 0);
        for (size_t k = step; k > 0; k--) {
            work_on(out[k], end[0]);
            work_on(out[k - 1], end[1]);
            mpz_mul(out[k], out[k], end[0]);
            mpz_addmul(out[k], out[k - 1], end[1]);
            mpz_add(binomial[k], binomial[k], binomial[k - 1]);
        }
        work_on(end[3], end[2]);
        mpz_mul(out[0], out[0], end[0]);
        if (i < p->n) {
            work_on(end[3], p->c[i]);
            mpz_mul(end[4], end[3], p->c[i]);
        }
        for (size_t k = 0; i < p->n && k <= step; k++) {
            work_on(binomial[k], end[4]);
            mpz_addmul(out[k], binomial[k], end[4]);
        }
        mpz_mul(end[3], end[3], end[2]);
    }
    integers_free(binomial, n + 1);
    integers_free(end, 5);
}

signs signs_of(mpz_t *c, size_t count) {
    signs out = {mpz_sgn(c[0]), mpz_sgn(c[count - 1]), 1, -1, 0};
    int before = 0;
    for (size_t k = 0; k < count; k++) {
        int sign = mpz_sgn(c[k]);
        out.least = sign < out.least ? sign : out.least;
        out.most = sign > out.most ? sign : out.most;
        out.changes += sign * before < 0;
        before = sign != 0 ? sign : before;
    }
    return out;
}

signs poly_signs(const poly *p, const mpq_t a, const mpq_t b) {
    mpz_t *c = integers(p->n);
    bernstein(c, p, p->n - 1, a, b);
    signs out = signs_of(c, p->n);
    integers_free(c, p->n);
    return out;
}

int strict_sign(signs s) {
    return s.least == s.most ? s.least : 0;
}
