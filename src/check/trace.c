/* The tests of a row's intervals: proofs/certificate.md, section 4.
 * SPDX-License-Identifier: MIT
 */
#include "trace.h"

#include <string.h>

/* Places: before, at and after the root. */
enum { LEFT, MID, RIGHT, PLACES };
/* Stands for a sign that is not known. The sign 0 before or after the root says that the polynomial
 * is zero. */
enum { UNKNOWN = 2 };

/* The interval at hand. */
typedef struct claim {
    mpq_srcptr a, b;
    char letter[PLACES]; /* O, I or B at each place; 0 where the interval has no such side, or no
                            root */
    const poly *q;
    int q_sign[PLACES]; /* signs of q before and after the root */
    int held[PLACES];   /* 1 if some simplex certainly holds the trajectory at the place */
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
    r->coefs = integers(MOST_DEGREE + 1);
    r->form = integers(4);
    r->p = integers(4);
    r->is_met = grow(NULL, s->count, 1);
    memset(r->is_met, 0, s->count);
}

static void keep_cell(trace *r, const simplex *f, unsigned zero) {
    size_t simplex = (size_t)(f - r->s->simplex);
    if (r->is_met[simplex] >> zero & 1)
        return;
    r->is_met[simplex] |= (unsigned char)(1u << zero);
    list_add(&r->met, 8 * simplex + zero);
}

/* Make the trajectory in x: X_i = scale (N_i0 P_0 + ... + N_i3 P_d), W = weight P_d. */
static void make_trajectory(trace *r) {
    const piece *m = &r->m->piece[r->piece];
    const poly *map = r->unsweep ? m->forward : m->inverse;
    int d = r->m->d;
    r->n = 0;
    for (int i = 0; i <= d; i++) {
        r->x[i].n = 0;
        poly_add_scaled(&r->x[i], &map[i < d ? 4 * i + 3 : WEIGHT], r->p[d]);
        for (int j = 0; j < d && i < d; j++)
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
    integers_of(r->p, (mpq_srcptr[]){r->point[0], r->point[1], r->point[2]}, (size_t)r->m->d);
    r->length = 0;
    r->piece = 0;
    mpq_set(r->at, r->m->piece[0].lo);
    work_allow(STEP_WORK);
    make_trajectory(r);
}

/* Control point k of the trajectory: coefficient k of each of its d + 1 polynomials. */
static mpz_t *control_point(const trace *r, size_t k) {
    return r->beta + k * ((size_t)r->m->d + 1);
}

/* Refute an interval that does not lie in one piece; make its coefficients and list the simplices
 * near it: test L1. */
static void enclose(trace *r, const claim *c) {
    int d = r->m->d;
    box b = box_empty;
    while (r->piece + 1 < r->m->count && mpq_cmp(c->a, r->m->piece[r->piece].hi) >= 0) {
        r->piece++;
        make_trajectory(r);
    }
    if (mpq_cmp(c->b, r->m->piece[r->piece].hi) > 0)
        fail(r, "the interval does not lie in one piece of the motion");
    for (int i = 0; i <= d; i++) {
        bernstein(r->coefs, &r->x[i], r->n, c->a, c->b);
        if (i == d && strict_sign(signs_of(r->coefs, r->n + 1)) != 1)
            fail(r, "the weight's coefficients do not have one sign on the interval");
        for (size_t k = 0; k <= r->n; k++)
            mpz_swap(control_point(r, k)[i], r->coefs[k]);
    }
    for (size_t k = 0; k <= r->n; k++)
        box_take(&b, control_point(r, k), d);
    solid_near(&r->near, r->s, &b);
}

/* The signs of the coefficients of a form's pullback. */
static signs pullback_signs(trace *r, mpz_t *form) {
    for (size_t k = 0; k <= r->n; k++)
        form_value(r->coefs[k], form, control_point(r, k), r->m->d + 1);
    return signs_of(r->coefs, r->n + 1);
}

static mpz_t *side_form(trace *r, const simplex *f, int k) {
    solid_side(r->form, r->s, f, f->axis, k);
    return r->form;
}

/* Does test L2 or L3 clear the simplex? If not, `all` has the signs of the pullbacks of the side
 * forms and, last, of the plane form. */
static int cleared(trace *r, const simplex *f, signs *all) {
    int d = r->s->d, clear;
    all[d] = pullback_signs(r, f->plane);
    clear = strict_sign(all[d]) != 0;
    for (int k = 0; k < d && !clear; k++) {
        all[k] = pullback_signs(r, side_form(r, f, k));
        clear = all[k].most < 0;
    }
    return clear;
}

/* Find the signs of a form's pullback f; `all` are those of its coefficients. With a root, f = q^e
 * g with e as large as possible, and the signs of q and g give those of f before, at and after the
 * root. Without a root the places are the beginning, the inside and the end of the interval. */
static void form_signs(int *out, const trace *r, const claim *c, mpz_t *form, signs all) {
    out[LEFT] = all.first;
    out[MID] = all.least >= 0 ? all.most : all.most <= 0 ? all.least : UNKNOWN;
    out[RIGHT] = all.last;
    if (!c->q || all.least == all.most)
        return;
    size_t power = 0;
    poly f = {0};
    for (int i = 0; i <= r->m->d; i++)
        poly_add_scaled(&f, &r->x[i], form[i]);
    while (poly_divide(&f, c->q))
        power++;
    int sign = strict_sign(poly_signs(&f, c->a, c->b));
    for (int p = LEFT; p <= RIGHT; p += 2)
        out[p] = sign == 0 ? UNKNOWN : power % 2 == 1 ? sign * c->q_sign[p] : sign;
    out[MID] = power > 0 ? 0 : UNKNOWN;
    poly_clear(&f);
}

/* Test a simplex that is not cleared: L4 and L5 where the letter is O or I; also note the places
 * and cells in which the simplex holds the trajectory. */
static void meet(trace *r, claim *c, const simplex *f, const signs *all) {
    int sign[PLACES], off[PLACES], on[PLACES];
    unsigned zero[PLACES] = {0, 0, 0};
    form_signs(sign, r, c, f->plane, all[r->s->d]);
    for (int p = 0; p < PLACES; p++) {
        on[p] = sign[p] == 0;
        off[p] = !on[p] && sign[p] != UNKNOWN;
    }
    for (int k = 0; k < r->s->d; k++) {
        form_signs(sign, r, c, side_form(r, f, k), all[k]);
        for (int p = 0; p < PLACES; p++) {
            off[p] = off[p] || sign[p] == -1;
            on[p] = on[p] && (sign[p] == 0 || sign[p] == 1);
            zero[p] |= sign[p] == 0 ? 1u << k : 0;
        }
    }
    for (int p = 0; p < PLACES; p++) {
        int beside = c->letter[p] == 'O' || c->letter[p] == 'I';
        if (beside && !off[p])
            fail_at(r, f, "is not cleared beside the root");
        if (r->with_cells && c->letter[p] == 'B' && !off[p] && !on[p])
            fail_at(r, f, "is neither met nor cleared");
        if (r->with_cells && c->letter[p] == 'B' && on[p])
            keep_cell(r, f, zero[p]);
        c->held[p] = c->held[p] || on[p];
    }
}

/* Refute the claim unless all near simplices are cleared; at a contact, those that are not must
 * pass `meet`. */
static void check_near(trace *r, claim *c) {
    for (size_t k = 0; k < r->near.count; k++) {
        const simplex *f = &r->s->simplex[r->near.item[k]];
        signs all[4];
        work_allow(STEP_WORK);
        if (cleared(r, f, all))
            continue;
        if (!c->letter[MID])
            fail_at(r, f, "is not cleared");
        meet(r, c, f, all);
    }
}

/* Refute the claim unless a simplex holds the trajectory at each place with the letter B. At a root
 * this follows, and is not needed, if a side is B or if the letters of both sides differ (K12). */
static void check_held(const trace *r, const claim *c) {
    char left = c->letter[LEFT], right = c->letter[RIGHT];
    int implied = c->q && (left == 'B' || right == 'B' || (left && right && left != right));
    for (int p = 0; p < PLACES; p++)
        if (c->letter[p] == 'B' && !c->held[p] && !(p == MID && implied))
            fail(r, "no facet holds the trajectory where it is said to be on the boundary");
}

/* Refute the claim unless q has exactly one root in the open interval, a simple one, and none at
 * the ends, as one sign change proves (proofs/claims.md C24). */
static void isolate(const trace *r, claim *c) {
    if (c->q->n < 2 || c->q->n > r->n + 1)
        fail(r, "the polynomial's degree is not that of a divisor");
    signs all = poly_signs(c->q, c->a, c->b);
    c->q_sign[LEFT] = all.first;
    c->q_sign[RIGHT] = all.last;
    if (all.changes != 1 || all.first == 0 || all.last == 0)
        fail(r, "the interval does not isolate one root of the polynomial");
}

/* Set q to a multiple of t - e for the end e of the interval at which the root is. */
static void root_at_end(poly *q, claim *c) {
    mpq_srcptr e = c->letter[LEFT] ? c->b : c->a;
    poly_extend(q, 2);
    mpz_neg(q->c[0], mpq_numref(e));
    mpz_set(q->c[1], mpq_denref(e));
    c->q = q;
    c->q_sign[LEFT] = -1;
    c->q_sign[RIGHT] = 1;
}

/* Test the state I or O at an end of the interval by one ray (proofs/claims.md C6). The first and
 * the last control point are on the trajectory. */
static void check_state(const trace *r, char state, size_t control) {
    long sum;
    if (!solid_ray(&sum, r->s, control_point(r, control), 0, NULL) || sum != (state == 'I'))
        fail(r, "the state between two contacts is not what is claimed");
}

/* The last letter of the word that was spelled; 0 before the first. */
static char last_letter(const trace *r) {
    return r->length ? r->word[r->length - 1] : '\0';
}

/* Compare an interval's letters with the next ones of the word; a letter equal to the one before it
 * counts once. The state of a new letter I or O is tested where the interval begins if it is the
 * first letter, else where the interval ends. */
static void add_letters(trace *r, word kind) {
    for (size_t k = 0; k < kind.length; k++) {
        char letter = kind.at[k];
        if (last_letter(r) == letter)
            continue;
        if (r->word[r->length++] != letter)
            fail(r, "the intervals' word is not the row's");
        if (letter != 'B')
            check_state(r, letter, k == 0 ? 0 : r->n);
    }
}

/* Set the letters before, at and behind an interval's root. The kinds O and I set none, the kind B
 * sets B at all three places. */
static void set_letters(char *letter, word kind) {
    char first = kind.at[0], last = kind.at[kind.length - 1];
    if (kind.length == 1 && first != 'B')
        return;
    letter[LEFT] = first;
    letter[MID] = 'B';
    letter[RIGHT] = last;
    if (kind.length == 2)
        letter[first == 'B' ? LEFT : RIGHT] = 0;
}

void trace_interval(trace *r, word kind, const mpq_t to, const poly *q) {
    claim c = {.a = r->at, .b = to, .q = q};
    poly end = {0};
    if (mpq_cmp(c.a, c.b) >= 0)
        fail(r, "an interval does not end after its beginning");
    if (last_letter(r) && last_letter(r) != *kind.at)
        fail(r, "an interval begins with another state than the one before it ends with");
    set_letters(c.letter, kind);
    work_allow(STEP_WORK);
    enclose(r, &c);
    if (kind.length == 2)
        root_at_end(&end, &c);
    if (kind.length == 3)
        isolate(r, &c);
    check_near(r, &c);
    check_held(r, &c);
    add_letters(r, kind);
    mpq_set(r->from, r->at);
    mpq_set(r->at, to);
    poly_clear(&end);
}

void trace_end(trace *r) {
    if (mpq_cmp(r->at, r->m->piece[r->m->count - 1].hi) != 0)
        fail(r, "the row's intervals do not end at t1");
    if (r->word[r->length] != '\0')
        fail(r, "the intervals' word is only the beginning of the row's");
}
