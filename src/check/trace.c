/* The tests of a row's intervals: proofs/certificate.md, section 4.
 * SPDX-License-Identifier: MIT
 */
#include "trace.h"

#include <stdlib.h>
#include <string.h>

/* Before, at and after the root. */
enum { LEFT, MID, RIGHT, PLACES };
/* The sign of a polynomial there, if it is not known; 0 before or after says that it is the zero
 * polynomial. */
enum { UNKNOWN = 2 };

/* The interval at hand. */
typedef struct claim {
    mpq_srcptr a, b;
    char letter[PLACES]; /* O, I or B; 0: the interval has no such side, or no root */
    const poly *q;
    int q_sign[PLACES]; /* of q on the sides */
    int held[PLACES];   /* some simplex holds the trajectory there, for certain */
} claim;

static _Noreturn void fail(const trace *r, const char *what) {
    refute("line %zu, row %zu: %s", r->line, r->row, what);
}

static _Noreturn void fail_at(const trace *r, const simplex *f, const char *what) {
    refute("line %zu, row %zu: facet %zu %s", r->line, r->row, f->facet, what);
}

void trace_init(trace *r, const solid *s, const motion *m, int unsweep, int with_cells) {
    *r = (trace){.s = s, .m = m, .unsweep = unsweep, .with_cells = with_cells};
    mpq_inits(r->from, r->at, r->point[0], r->point[1], r->point[2], NULL);
    r->beta = integers(4 * (MOST_DEGREE + 1));
    r->root = integers(MOST_DEGREE + 1);
    r->form = integers(5);
    r->p = integers(4);
    r->is_met = grow(NULL, s->count, 1);
    memset(r->is_met, 0, s->count);
}

void trace_forget_cells(trace *r) {
    while (r->met.count > 0)
        r->is_met[r->met.item[--r->met.count] / 8] = 0;
}

static void keep_cell(trace *r, const simplex *f, unsigned zero) {
    size_t simplex = (size_t)(f - r->s->simplex);
    if (r->is_met[simplex] >> zero & 1)
        return;
    r->is_met[simplex] |= (unsigned char)(1u << zero);
    list_add(&r->met, 8 * simplex + zero);
}

/* X_i = scale (N_i0 P_0 + ... + N_id P_d), W = weight P_d. */
static void make_trajectory(trace *r) {
    const piece *m = &r->m->piece[r->piece];
    const poly *map = r->unsweep ? m->forward : m->inverse;
    int d = r->m->d;
    r->n = 0;
    for (int i = 0; i <= d; i++) {
        r->x[i].n = 0;
        if (i == d)
            poly_add_scaled(&r->x[i], &map[WEIGHT], r->p[d]);
        for (int j = 0; j <= d && i < d; j++)
            poly_add_scaled(&r->x[i], &map[4 * i + j], r->p[j]);
        if (i < d)
            poly_scale(&r->x[i], r->s->scale);
        r->n = r->x[i].n > r->n + 1 ? r->x[i].n - 1 : r->n;
    }
}

void trace_start(trace *r, word claimed) {
    r->word = grow(r->word, claimed.length + 1, 1);
    memcpy(r->word, claimed.at, claimed.length);
    r->word[claimed.length] = '\0';
    if (strspn(r->word, "IBO") != claimed.length)
        fail(r, "the word is not of the letters I, B and O");
    integers_of(r->p, (mpq_srcptr[]){r->point[0], r->point[1], r->point[2]}, (size_t)r->m->d);
    r->length = 0;
    r->piece = 0;
    mpq_set(r->at, r->m->piece[0].lo);
    make_trajectory(r);
}

/* The d + 1 coefficients number k of the trajectory. */
static mpz_t *control_point(const trace *r, size_t k) {
    return r->beta + k * ((size_t)r->m->d + 1);
}

/* The interval lies in one piece; its coefficients, and the simplices near it: test L1. */
static void enclose(trace *r, const claim *c) {
    int d = r->m->d;
    box b;
    while (r->piece + 1 < r->m->count && mpq_cmp(c->a, r->m->piece[r->piece].hi) >= 0) {
        r->piece++;
        make_trajectory(r);
    }
    if (mpq_cmp(c->b, r->m->piece[r->piece].hi) > 0)
        fail(r, "the interval does not lie in one piece of the motion");
    for (int i = 0; i <= d; i++) {
        bernstein(r->root, &r->x[i], r->n, c->a, c->b);
        if (i == d && strict_sign(r->root, r->n + 1) != 1)
            fail(r, "the weight's coefficients do not have one sign on the interval");
        for (size_t k = 0; k <= r->n; k++)
            mpz_swap(control_point(r, k)[i], r->root[k]);
    }
    for (size_t k = 0; k <= r->n; k++)
        box_take(&b, control_point(r, k), d, k == 0);
    solid_near(&r->near, r->s, &b);
}

/* The sign of coefficient k of a form's pullback. */
static int form_sign(trace *r, mpz_t *form, size_t k) {
    return form_value(r->form[4], form, control_point(r, k), r->m->d + 1);
}

static int form_is(trace *r, mpz_t *form, int sign) {
    for (size_t k = 0; k <= r->n; k++)
        if (form_sign(r, form, k) != sign)
            return 0;
    return 1;
}

/* The one strict sign of all of them, or 0. */
static int form_strict(trace *r, mpz_t *form) {
    return form_is(r, form, 1) - form_is(r, form, -1);
}

static mpz_t *side_form(trace *r, const simplex *f, int k) {
    solid_side(r->form, r->s, f, f->axis, k);
    return r->form;
}

/* Tests L2 and L3. */
static int cleared(trace *r, const simplex *f) {
    int clear = form_strict(r, f->plane) != 0;
    for (int k = 0; k < r->s->d; k++)
        clear = clear || form_is(r, side_form(r, f, k), -1);
    return clear;
}

/* On an interval that has no root: the signs at its beginning, within, and at its end. */
static void slide_signs(int *out, trace *r, mpz_t *form) {
    int least = 1, most = -1;
    for (size_t k = 0; k <= r->n; k++) {
        int sign = form_sign(r, form, k);
        least = sign < least ? sign : least;
        most = sign > most ? sign : most;
        out[LEFT] = k == 0 ? sign : out[LEFT];
        out[RIGHT] = sign;
    }
    out[MID] = least >= 0 ? most : most <= 0 ? least : UNKNOWN;
}

/* f = q^e g, e as large as can be: the signs of g and of q give those of f. */
static void form_signs(int *out, trace *r, const claim *c, mpz_t *form) {
    if (!c->q) {
        slide_signs(out, r, form);
        return;
    }
    int sign = form_strict(r, form);
    size_t power = 0;
    poly f = {0};
    for (int i = 0; i <= r->m->d; i++)
        if (sign == 0)
            poly_add_scaled(&f, &r->x[i], form[i]);
    for (int p = 0; p < PLACES; p++)
        out[p] = sign;
    if (f.n > 0) {
        while (poly_divide(&f, c->q))
            power++;
        bernstein(r->root, &f, f.n - 1, c->a, c->b);
        sign = strict_sign(r->root, f.n);
        for (int p = LEFT; p <= RIGHT; p += 2)
            out[p] = sign == 0 ? UNKNOWN : power % 2 == 1 ? sign * c->q_sign[p] : sign;
        out[MID] = power > 0 ? 0 : UNKNOWN;
    }
    poly_clear(&f);
}

/* A simplex that is not cleared: tests L4 and L5 on the sides that must be free of it; and where
 * does it hold the trajectory, in which of its cells? */
static void meet(trace *r, claim *c, const simplex *f) {
    int sign[PLACES], out[PLACES], in[PLACES];
    unsigned zero[PLACES] = {0, 0, 0};
    form_signs(sign, r, c, f->plane);
    for (int p = 0; p < PLACES; p++) {
        out[p] = sign[p] == 1 || sign[p] == -1;
        in[p] = sign[p] == 0;
    }
    for (int k = 0; k < r->s->d; k++) {
        form_signs(sign, r, c, side_form(r, f, k));
        for (int p = 0; p < PLACES; p++) {
            out[p] = out[p] || sign[p] == -1;
            in[p] = in[p] && (sign[p] == 0 || sign[p] == 1);
            zero[p] |= sign[p] == 0 ? 1u << k : 0;
        }
    }
    for (int p = 0; p < PLACES; p++) {
        if ((c->letter[p] == 'O' || c->letter[p] == 'I') && !out[p])
            fail_at(r, f, "is not cleared beside the root");
        if (r->with_cells && c->letter[p] == 'B' && !out[p] && !in[p])
            fail_at(r, f, "is neither met nor cleared");
        if (r->with_cells && c->letter[p] == 'B' && in[p])
            keep_cell(r, f, zero[p]);
        c->held[p] = c->held[p] || in[p];
    }
}

/* All simplices near the trajectory are cleared, those where it is on the boundary as far as they
 * must be. */
static void check_near(trace *r, claim *c) {
    for (size_t k = 0; k < r->near.count; k++) {
        const simplex *f = &r->s->simplex[r->near.item[k]];
        if (cleared(r, f))
            continue;
        if (!c->letter[MID])
            fail_at(r, f, "is not cleared");
        meet(r, c, f);
    }
}

/* Some simplex holds the trajectory within the interval, and so on all of it. */
static void check_slide(trace *r, claim *c) {
    memset(c->letter, 'B', PLACES);
    check_near(r, c);
    if (!c->held[MID])
        fail(r, "no facet holds the trajectory on the interval");
}

/* q has just one root in the open interval, a simple one, and none at its ends: one sign change
 * (proofs/claims.md C24). */
static void isolate(trace *r, claim *c) {
    size_t changes = 0, last = c->q->n - 1;
    int sign = 0;
    if (c->q->n < 2 || c->q->n > r->n + 1)
        fail(r, "the polynomial's degree is not that of a divisor");
    bernstein(r->root, c->q, last, c->a, c->b);
    for (size_t k = 0; k <= last; k++) {
        int s = mpz_sgn(r->root[k]);
        changes += s != 0 && sign != 0 && s != sign;
        sign = s != 0 ? s : sign;
    }
    c->q_sign[LEFT] = mpz_sgn(r->root[0]);
    c->q_sign[RIGHT] = mpz_sgn(r->root[last]);
    if (changes != 1 || c->q_sign[LEFT] == 0 || c->q_sign[RIGHT] == 0)
        fail(r, "the interval does not isolate one root of the polynomial");
}

/* q = t - e for an end e of the interval. */
static void root_at_end(poly *q, claim *c) {
    mpq_srcptr e = c->letter[LEFT] ? c->b : c->a;
    poly_extend(q, 2);
    mpz_neg(q->c[0], mpq_numref(e));
    mpz_set(q->c[1], mpq_denref(e));
    c->q = q;
    c->q_sign[LEFT] = -1;
    c->q_sign[RIGHT] = 1;
}

/* The state at a time of the interval at hand, off the boundary, by one ray (proofs/claims.md C6).
 */
static void check_state(trace *r, char state, mpq_srcptr t) {
    mpz_t *x = integers(4);
    long sum;
    poly_values(x, r->x, (size_t)r->m->d + 1, t);
    if (!solid_ray(&sum, r->s, x, 0, NULL) || sum != (state == 'I'))
        fail(r, "the state between two contacts is not what is claimed");
    integers_free(x, 4);
}

/* The letter found last; 0 before the first. */
static char last_letter(const trace *r) {
    return r->length ? r->word[r->length - 1] : '\0';
}

/* The letters of an interval go on with the word; the state of each stretch off the boundary is
 * found at the end that it has of the interval in which it begins. */
static void add_letters(trace *r, const claim *c, word kind) {
    for (size_t k = 0; k < kind.length; k++) {
        char letter = kind.at[k];
        if (last_letter(r) == letter)
            continue;
        if (r->word[r->length++] != letter)
            fail(r, "the intervals' word is not the row's");
        if (letter != 'B')
            check_state(r, letter, k == 0 ? c->a : c->b);
    }
}

/* O, I, B; one of O, I beside B; B between two of O, I, B. */
static int is_kind(word w) {
    for (size_t k = 0; k < w.length; k++)
        if (w.at[k] != 'O' && w.at[k] != 'I' && w.at[k] != 'B')
            return 0;
    return w.length == 1 || (w.length == 2 && (w.at[0] == 'B') != (w.at[1] == 'B')) ||
           (w.length == 3 && w.at[1] == 'B');
}

/* An interval with a root, which parts its sides. */
static void check_root(trace *r, claim *c, word kind) {
    poly end = {0};
    char *side = c->letter;
    side[MID] = 'B';
    side[LEFT] = kind.length == 3 || *kind.at != 'B' ? kind.at[0] : 0;
    side[RIGHT] = kind.length == 3 || *kind.at == 'B' ? kind.at[kind.length - 1] : 0;
    if (kind.length == 2)
        root_at_end(&end, c);
    else
        isolate(r, c);
    check_near(r, c);
    for (int p = LEFT; p <= RIGHT; p += 2)
        if (side[p] == 'B' && !c->held[p])
            fail(r, "no facet holds the trajectory beside the root");
    int implied = side[LEFT] == 'B' || side[RIGHT] == 'B' ||
                  (side[LEFT] && side[RIGHT] && side[LEFT] != side[RIGHT]);
    if (!implied && !c->held[MID])
        fail(r, "no facet holds the trajectory at the root");
    poly_clear(&end);
}

void trace_interval(trace *r, word kind, const mpq_t to, const poly *q) {
    claim c = {.a = r->at, .b = to, .q = q};
    if (!is_kind(kind) || (q != NULL) != (kind.length == 3))
        fail(r, "an interval is of a kind that does not exist, or its polynomial is missing or too "
                "much");
    if (mpq_cmp(c.a, c.b) >= 0)
        fail(r, "an interval does not end after its beginning");
    if (last_letter(r) && last_letter(r) != *kind.at)
        fail(r, "an interval begins with another state than the one before it ends with");
    enclose(r, &c);
    if (kind.length > 1)
        check_root(r, &c, kind);
    else if (*kind.at == 'B')
        check_slide(r, &c);
    else
        check_near(r, &c);
    add_letters(r, &c, kind);
    mpq_set(r->from, r->at);
    mpq_set(r->at, to);
}

void trace_end(trace *r) {
    if (mpq_cmp(r->at, r->m->piece[r->m->count - 1].hi) != 0)
        fail(r, "the row's intervals do not end at t1");
    if (r->word[r->length] != '\0')
        fail(r, "the intervals' word is only the beginning of the row's");
}
