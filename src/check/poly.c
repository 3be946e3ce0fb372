/* Integer polynomials, and quotients of them.
 * SPDX-License-Identifier: MIT
 */
#include "poly.h"

#include <stdlib.h>

void poly_init(poly *p) {
    *p = (poly){0, 0, NULL};
}

void poly_clear(poly *p) {
    for (size_t k = 0; k < p->room; k++)
        mpz_clear(p->c[k]);
    free(p->c);
    poly_init(p);
}

static void fit(poly *p, size_t n) {
    if (n <= p->room)
        return;
    p->c = grow(p->c, n, sizeof *p->c);
    for (; p->room < n; p->room++)
        mpz_init(p->c[p->room]);
}

void poly_zeros(poly *p, size_t n) {
    fit(p, n);
    for (size_t k = 0; k < n; k++)
        mpz_set_ui(p->c[k], 0);
    p->n = n;
}

void poly_trim(poly *p) {
    while (p->n > 0 && mpz_sgn(p->c[p->n - 1]) == 0)
        p->n--;
}

void poly_set(poly *out, const poly *p) {
    if (out == p)
        return;
    fit(out, p->n);
    for (size_t k = 0; k < p->n; k++)
        mpz_set(out->c[k], p->c[k]);
    out->n = p->n;
}

void poly_set_z(poly *out, const mpz_t value) {
    poly_zeros(out, 1);
    mpz_set(out->c[0], value);
    poly_trim(out);
}

static void extend(poly *p, size_t n) {
    fit(p, n);
    for (; p->n < n; p->n++)
        mpz_set_ui(p->c[p->n], 0);
}

mpz_t *poly_next(poly *p) {
    extend(p, p->n + 1);
    return &p->c[p->n - 1];
}

static void combine(poly *out, const poly *a, const poly *b,
                    void (*op)(mpz_ptr, mpz_srcptr, mpz_srcptr)) {
    poly other;
    poly_init(&other);
    poly_set(&other, b);
    poly_set(out, a);
    extend(out, other.n);
    for (size_t k = 0; k < other.n; k++)
        op(out->c[k], out->c[k], other.c[k]);
    poly_trim(out);
    poly_clear(&other);
}

void poly_add(poly *out, const poly *a, const poly *b) {
    combine(out, a, b, mpz_add);
}

void poly_sub(poly *out, const poly *a, const poly *b) {
    combine(out, a, b, mpz_sub);
}

void poly_mul(poly *out, const poly *a, const poly *b) {
    poly product;
    poly_init(&product);
    if (a->n > 0 && b->n > 0)
        poly_zeros(&product, a->n + b->n - 1);
    for (size_t i = 0; i < a->n; i++)
        for (size_t j = 0; j < b->n; j++)
            mpz_addmul(product.c[i + j], a->c[i], b->c[j]);
    poly_clear(out);
    *out = product;
}

void poly_add_scaled(poly *out, const poly *a, const mpz_t z) {
    extend(out, a->n);
    for (size_t k = 0; k < a->n; k++)
        mpz_addmul(out->c[k], a->c[k], z);
    poly_trim(out);
}

void poly_scale(poly *p, const mpz_t z) {
    for (size_t k = 0; k < p->n; k++)
        mpz_mul(p->c[k], p->c[k], z);
    poly_trim(p);
}

void poly_make_primitive(poly *p) {
    mpz_t g;
    mpz_init(g);
    for (size_t k = 0; k < p->n; k++)
        mpz_gcd(g, g, p->c[k]);
    for (size_t k = 0; k < p->n; k++)
        mpz_divexact(p->c[k], p->c[k], g);
    mpz_clear(g);
}

int poly_divide(poly *out, const poly *a, const poly *b) {
    poly rest, quotient;
    if (b->n == 0)
        return 0;
    poly_init(&rest);
    poly_init(&quotient);
    poly_set(&rest, a);
    if (a->n >= b->n)
        poly_zeros(&quotient, a->n - b->n + 1);
    const mpz_t *lead = (const mpz_t *)&b->c[b->n - 1];
    int exact = 1;
    while (exact && rest.n >= b->n) {
        size_t at = rest.n - b->n;
        exact = mpz_divisible_p(rest.c[rest.n - 1], *lead) != 0;
        if (!exact)
            break;
        mpz_divexact(quotient.c[at], rest.c[rest.n - 1], *lead);
        for (size_t k = 0; k < b->n; k++)
            mpz_submul(rest.c[at + k], quotient.c[at], b->c[k]);
        poly_trim(&rest);
    }
    exact = exact && rest.n == 0;
    if (exact)
        poly_set(out, &quotient);
    poly_clear(&rest);
    poly_clear(&quotient);
    return exact;
}

/* a becomes a primitive multiple of the remainder of a by b. */
static void reduce(poly *a, const poly *b) {
    mpz_t lead;
    mpz_init(lead);
    while (a->n >= b->n) {
        size_t at = a->n - b->n;
        mpz_set(lead, a->c[a->n - 1]);
        poly_scale(a, b->c[b->n - 1]);
        for (size_t k = 0; k < b->n; k++)
            mpz_submul(a->c[at + k], lead, b->c[k]);
        poly_trim(a);
    }
    poly_make_primitive(a);
    mpz_clear(lead);
}

void poly_common(poly *out, const poly *a, const poly *b) {
    poly x, y;
    mpz_t content;
    mpz_init(content);
    for (size_t k = 0; k < a->n; k++)
        mpz_gcd(content, content, a->c[k]);
    for (size_t k = 0; k < b->n; k++)
        mpz_gcd(content, content, b->c[k]);
    poly_init(&x);
    poly_init(&y);
    poly_set(&x, a);
    poly_set(&y, b);
    poly_make_primitive(&x);
    poly_make_primitive(&y);
    while (y.n > 0) {
        reduce(&x, &y);
        poly keep = x;
        x = y;
        y = keep;
    }
    poly_scale(&x, content);
    poly_set(out, &x);
    poly_clear(&x);
    poly_clear(&y);
    mpz_clear(content);
}

void poly_value(mpq_t out, const poly *p, const mpq_t x) {
    mpq_t term;
    mpq_init(term);
    mpq_set_ui(out, 0, 1);
    for (size_t k = p->n; k-- > 0;) {
        mpq_mul(out, out, x);
        mpq_set_z(term, p->c[k]);
        mpq_add(out, out, term);
    }
    mpq_clear(term);
}

void fraction_init(fraction *f) {
    poly_init(&f->num);
    poly_init(&f->den);
    poly_zeros(&f->den, 1);
    mpz_set_ui(f->den.c[0], 1);
}

void fraction_clear(fraction *f) {
    poly_clear(&f->num);
    poly_clear(&f->den);
}

void fraction_set(fraction *out, const fraction *f) {
    poly_set(&out->num, &f->num);
    poly_set(&out->den, &f->den);
}

void fraction_set_q(fraction *out, const mpq_t value) {
    poly_set_z(&out->num, mpq_numref(value));
    poly_set_z(&out->den, mpq_denref(value));
}

static void check_size(const poly *p) {
    if (p->n > MOST_DEGREE + 1)
        give_up("the motion has a polynomial of degree above %d", MOST_DEGREE);
    for (size_t k = 0; k < p->n; k++)
        if (mpz_sizeinbase(p->c[k], 2) > MOST_BITS)
            give_up("the motion has a coefficient of more than %d bits", MOST_BITS);
}

static void shorten(fraction *f) {
    poly g;
    check_size(&f->num);
    check_size(&f->den);
    poly_init(&g);
    poly_common(&g, &f->num, &f->den);
    if (!poly_divide(&f->num, &f->num, &g) || !poly_divide(&f->den, &f->den, &g))
        give_up("a common divisor does not divide");
    poly_clear(&g);
}

void fraction_apply(fraction *out, char op, const fraction *a, const fraction *b) {
    fraction r;
    poly other;
    fraction_init(&r);
    poly_init(&other);
    if (op == '/' && b->num.n == 0)
        give_up("the motion divides by zero");
    if (op == '*' || op == '/') {
        poly_mul(&r.num, &a->num, op == '*' ? &b->num : &b->den);
        poly_mul(&r.den, &a->den, op == '*' ? &b->den : &b->num);
    } else {
        poly_mul(&r.num, &a->num, &b->den);
        poly_mul(&other, &b->num, &a->den);
        (op == '+' ? poly_add : poly_sub)(&r.num, &r.num, &other);
        poly_mul(&r.den, &a->den, &b->den);
    }
    shorten(&r);
    fraction_set(out, &r);
    fraction_clear(&r);
    poly_clear(&other);
}

/* The value of a polynomial at a fraction, by Horner. */
static void poly_at_fraction(fraction *out, const poly *p, const fraction *x) {
    fraction term, sum;
    mpq_t c;
    fraction_init(&term);
    fraction_init(&sum);
    mpq_init(c);
    for (size_t k = p->n; k-- > 0;) {
        fraction_apply(&sum, '*', &sum, x);
        mpq_set_z(c, p->c[k]);
        fraction_set_q(&term, c);
        fraction_apply(&sum, '+', &sum, &term);
    }
    fraction_set(out, &sum);
    fraction_clear(&term);
    fraction_clear(&sum);
    mpq_clear(c);
}

void fraction_shift(fraction *out, const fraction *f, const mpq_t a, const mpq_t b) {
    fraction x, num, den, t;
    fraction_init(&x);
    fraction_init(&num);
    fraction_init(&den);
    fraction_init(&t);
    poly_zeros(&t.num, 2);
    mpz_set_ui(t.num.c[1], 1);
    fraction_set_q(&x, b);
    fraction_apply(&x, '*', &x, &t);
    fraction_set_q(&t, a);
    fraction_apply(&x, '+', &x, &t);
    poly_at_fraction(&num, &f->num, &x);
    poly_at_fraction(&den, &f->den, &x);
    fraction_apply(out, '/', &num, &den);
    fraction_clear(&x);
    fraction_clear(&num);
    fraction_clear(&den);
    fraction_clear(&t);
}

int fraction_value(mpq_t out, const fraction *f, const mpq_t x) {
    mpq_t den;
    mpq_init(den);
    poly_value(den, &f->den, x);
    int defined = mpq_sgn(den) != 0;
    poly_value(out, &f->num, x);
    if (defined)
        mpq_div(out, out, den);
    mpq_clear(den);
    return defined;
}

int fraction_constant(mpq_t out, const fraction *f) {
    mpq_t zero;
    mpq_init(zero);
    int constant = f->num.n <= 1 && f->den.n == 1 && fraction_value(out, f, zero);
    mpq_clear(zero);
    return constant;
}
