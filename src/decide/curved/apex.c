/* The signs of a quadratic form on the cells of an arrangement of planes.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * In a cell, closed, polyhedral and with an interior, a form takes a sign iff it does on one of the
 * cell's rays, in the plane cone of two of them, or, where only one eigenvalue has the sign, at a
 * vector known to have it or its opposite, should that lie in the cell (C99).
 */
#include "decide/curved/apex.h"

#include "decide/curved/arrangement.h"

/* Vectors among which each sign that a form of three variables takes is taken. */
enum { WITNESSES = 18 };

typedef struct cone {
    sign_germ *g;
    int dimension, member; /* the singular one */
    value *form;           /* twice its terms of degree two, a symmetric matrix of size d */
    int rising, falling;   /* eigenvalues above and below 0 */
    value *witness;        /* d each */
    int taken[WITNESSES];  /* the form's sign at each */
} cone;

static value *entry(const cone *q, int i, int j) {
    return q->form + i * q->dimension + j;
}

static void read_apex_form(cone *q) {
    const taylor *t = &q->g->member[q->member];
    for (size_t k = 0; k < t->count; k++) {
        const unsigned char *p = t->power[k];
        for (int i = 0; i < q->dimension && p[0] + p[1] + p[2] == 2; i++)
            for (int j = 0; j < q->dimension; j++)
                if (p[i] && p[j] && (i != j || p[i] == 2))
                    fmpq_poly_scalar_mul_si(entry(q, i, j), t->coefficient + k, i == j ? 2 : 1);
    }
}

/* out = a' H b */
static void form_between(value *out, const cone *q, const value *a, const value *b) {
    value *row = field_vector(q->g->f, (size_t)q->dimension);
    for (int i = 0; i < q->dimension && row; i++)
        field_dot(row + i, q->g->f, entry(q, i, 0), b, q->dimension);
    if (row)
        field_dot(out, q->g->f, row, a, q->dimension);
    field_vector_clear(row, (size_t)q->dimension);
}

/* The minor of rows i, j. */
static void principal_minor(value *out, const cone *q, int i, int j) {
    field_mul(out, q->g->f, entry(q, i, i), entry(q, j, j));
    field_submul(out, q->g->f, entry(q, i, j), entry(q, i, j));
}

/* Eigenvalues by Descartes' rule on the characteristic polynomial, whose roots are real: with the
 * sums e of the principal minors, l^3 - e1 l^2 + e2 l - e3. */
static void count_eigenvalues(cone *q, const value *adjoint) {
    moment_field *f = q->g->f;
    value *e = field_vector(f, 4);
    int d = q->dimension, up[4] = {1}, down[4] = {1};
    if (!e)
        return;
    for (int i = 0; i < d; i++)
        fmpq_poly_add(e + 1, e + 1, entry(q, i, i));
    for (int i = 0; i < d; i++)
        for (int j = 0; j < i; j++) {
            principal_minor(e, q, i, j);
            fmpq_poly_add(e + 2, e + 2, e);
        }
    if (d == 3)
        field_dot(e + 3, f, entry(q, 0, 0), adjoint, 3);
    for (int k = 1; k <= d; k++) {
        down[k] = field_sign(f, e + k);
        up[k] = k % 2 ? -down[k] : down[k];
    }
    for (int k = 1, a = 1, b = 1; k <= d; k++) {
        q->rising += up[k] && up[k] != a;
        q->falling += down[k] && down[k] != b;
        a = up[k] ? up[k] : a;
        b = down[k] ? down[k] : b;
    }
    field_vector_clear(e, 4);
}

/* Axes; sums and differences of two; -h_ij e_i + h_ii e_j; columns of the adjoint matrix. Which
 * sign each takes is asked, so none need be there. */
static void make_witnesses(cone *q, const value *adjoint) {
    int d = q->dimension, next = 0;
    value *w = q->witness;
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d; j++, next++) {
            fmpq_poly_set_si(w + next * d + i, 1);
            if (i != j)
                fmpq_poly_set_si(w + next * d + j, i < j ? 1 : -1);
        }
    for (int i = 0; i < d; i++)
        for (int j = 0; j < d; j++) {
            if (i == j)
                continue;
            fmpq_poly_neg(w + next * d + i, entry(q, i, j));
            fmpq_poly_set(w + next++ * d + j, entry(q, i, i));
        }
    for (int i = 0; i < d && d == 3; i++, next++)
        for (int j = 0; j < d; j++)
            fmpq_poly_set(w + next * d + j, adjoint + i * d + j);
}

static int sign_of_form(const cone *q, const value *v) {
    fmpq_poly_t at;
    fmpq_poly_init(at);
    form_between(at, q, v, v);
    int sign = field_sign(q->g->f, at);
    fmpq_poly_clear(at);
    return sign;
}

/* 1 if the form takes the sign within the cone of two vectors at which it does not. */
static int takes_between(const cone *q, const value *a, const value *b, int sign) {
    value *e = field_vector(q->g->f, 3);
    int takes = 0;
    if (e) {
        form_between(e, q, a, b);
        takes = field_sign(q->g->f, e) == sign;
    }
    if (takes) {
        form_between(e + 1, q, a, a);
        form_between(e + 2, q, b, b);
        field_mul(e, q->g->f, e, e);
        field_submul(e, q->g->f, e + 1, e + 2);
        takes = field_sign(q->g->f, e) > 0;
    }
    field_vector_clear(e, 3);
    return takes;
}

/* Does a witness of the sign, or its opposite, lie in the closed cell? */
static int holds_witness(const cone *q, const arrangement *a, uint32_t smooth, unsigned pattern,
                         int sign) {
    int d = q->dimension;
    value *dot = field_vector(q->g->f, 1);
    int holds = 0;
    for (int w = 0; w < WITNESSES && dot && !holds; w++) {
        uint32_t positive = 0, negative = 0;
        if (q->taken[w] != sign)
            continue;
        for (int k = 0; k < a->count; k++) {
            if (!(smooth >> k & 1))
                continue;
            fmpq_poly_zero(dot);
            for (int i = 0; i < d; i++)
                field_addmul(dot, q->g->f, taylor_gradient(&q->g->member[k], i),
                             q->witness + w * d + i);
            int at = field_sign(q->g->f, dot);
            positive |= (uint32_t)(at > 0) << k;
            negative |= (uint32_t)(at < 0) << k;
        }
        holds = (!(positive & pattern) && !(negative & ~pattern)) ||
                (!(negative & pattern) && !(positive & ~pattern));
    }
    field_vector_clear(dot, 1);
    return holds;
}

/* 1 if the form is seen to take a sign in a cell. */
static int takes_in_cell(const cone *q, const arrangement *a, uint32_t smooth, unsigned pattern,
                         int sign) {
    int d = q->dimension;
    for (int r = 0; r < a->ray_count; r++) {
        if (!arrangement_in_cell(a, r, smooth, pattern))
            continue;
        if (sign_of_form(q, a->ray + r * d) == sign)
            return 1;
        for (int o = 0; o < r; o++)
            if (arrangement_in_cell(a, o, smooth, pattern) &&
                takes_between(q, a->ray + r * d, a->ray + o * d, sign))
                return 1;
    }
    return holds_witness(q, a, smooth, pattern, sign);
}

static int has_witness(const cone *q, int sign) {
    for (int w = 0; w < WITNESSES; w++)
        if (q->taken[w] == sign)
            return 1;
    return 0;
}

static void ask_cell(const cone *q, const arrangement *a, uint32_t smooth, unsigned pattern,
                     int exact) {
    sign_germ *g = q->g;
    unsigned bit = 1u << q->member;
    for (int sign = -1; sign <= 1; sign += 2) {
        unsigned whole = pattern | (sign < 0 ? bit : 0);
        int of_sign = sign > 0 ? q->rising : q->falling;
        if (of_sign == 0)
            continue;
        if (takes_in_cell(q, a, smooth, pattern, sign))
            pattern_add(&g->seen, whole);
        else if (exact && (of_sign > 1 || has_witness(q, sign)))
            germ_exclude(g, smooth | bit, whole);
    }
}

/* A sign that no eigenvalue has is not taken, by a quadric or where the form is definite. */
static void exclude_signs(const cone *q, int quadric) {
    unsigned bit = 1u << q->member;
    if (q->falling == 0 && (quadric || q->rising == q->dimension))
        germ_exclude(q->g, bit, bit);
    if (q->rising == 0 && (quadric || q->falling == q->dimension))
        germ_exclude(q->g, bit, 0);
}

static void ask_cells(cone *q, unsigned smooth) {
    sign_germ *g = q->g;
    arrangement a;
    int quadric = g->member[q->member].degree == 2, planes = 1;
    for (int k = 0; k < g->count; k++)
        planes &= k == q->member || g->member[k].degree == 1;
    exclude_signs(q, quadric);
    arrangement_init(&a, g->f, g->member, g->count, smooth);
    for (unsigned s = 0; s < germ_patterns(g) && g->f->status == GRAZE_OK; s++)
        if (!(s & ~smooth) && arrangement_has(&a, smooth, s))
            ask_cell(q, &a, smooth, s, quadric && planes);
    arrangement_clear(&a);
}

void apex_ask(sign_germ *g, unsigned smooth, int singular) {
    int d = g->dimension;
    size_t size = (size_t)(d * d), room = (size_t)(WITNESSES * d);
    cone q = {.g = g, .dimension = d, .member = singular};
    value *adjoint = field_vector(g->f, 9);
    q.form = field_vector(g->f, size);
    q.witness = field_vector(g->f, room);
    if (adjoint && q.form && q.witness) {
        read_apex_form(&q);
        for (int i = 0; i < 3 && d == 3; i++)
            field_cross(adjoint + 3 * i, g->f, entry(&q, (i + 1) % 3, 0),
                        entry(&q, (i + 2) % 3, 0));
        count_eigenvalues(&q, adjoint);
        make_witnesses(&q, adjoint);
        for (int w = 0; w < WITNESSES; w++)
            q.taken[w] = sign_of_form(&q, q.witness + w * d);
        if (g->f->status == GRAZE_OK)
            ask_cells(&q, smooth);
    }
    field_vector_clear(adjoint, 9);
    field_vector_clear(q.form, size);
    field_vector_clear(q.witness, room);
}
