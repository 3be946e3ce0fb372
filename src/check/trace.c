/* The tests of a row's intervals: proofs/certificate.md, section 4.
 * SPDX-License-Identifier: MIT
 */
#include "trace.h"

#include <stdlib.h>
#include <string.h>

/* Before, at and after the root. */
enum { LEFT, MID, RIGHT, PLACES };
enum { UNKNOWN = 2 };

/* Signs of a polynomial there, or UNKNOWN. 0 before or after says that it is the zero polynomial.
 */
typedef struct profile {
    int at[PLACES];
} profile;

/* The interval at hand. */
typedef struct claim {
    mpq_t a, b;
    char letter[PLACES]; /* O, I or B; 0: the interval has no such side */
    const poly *q;
    int q_sign[PLACES]; /* of q on the sides */
    int held[PLACES];   /* some simplex holds the trajectory there, for certain */
} claim;

static _Noreturn void fail(const trace *r, const char *what) {
    refute("line %zu, row %zu: %s", r->line, r->row, what);
}

void trace_init(trace *r, const solid *s, const motion *m, int unsweep) {
    *r = (trace){.s = s, .m = m, .unsweep = unsweep};
    mpq_inits(r->at, r->sample, r->point[0], r->point[1], r->point[2], NULL);
    for (int i = 0; i < 4; i++)
        r->beta[i] = integers(MOST_DEGREE + 1);
    r->root = integers(MOST_DEGREE + 1);
    r->form = integers(5);
}

void trace_start(trace *r, word claimed) {
    r->word = claimed;
    mpq_set(r->at, r->m->piece[0].lo);
    r->piece = 0;
    r->made = 0;
    r->length = 0;
    r->free = 0;
}

/* ---------------------------------------------------------------------------------- trajectory */

/* With P = p / q: X_i = scale (sum_j N_ij p_j + N_id q), W = weight q. */
static void make_trajectory(trace *r) {
    const piece *m = &r->m->piece[r->piece];
    const poly *map = r->unsweep ? m->forward : m->inverse;
    int d = r->m->d;
    mpz_t q, p;
    mpz_inits(q, p, NULL);
    mpz_set_ui(q, 1);
    for (int j = 0; j < d; j++)
        mpz_lcm(q, q, mpq_denref(r->point[j]));
    for (int i = 0; i <= d; i++) {
        r->x[i].n = 0;
        poly_add_scaled(&r->x[i], i < d ? &map[4 * i + d] : &map[WEIGHT], q);
        for (int j = 0; i < d && j < d; j++) {
            mpz_divexact(p, q, mpq_denref(r->point[j]));
            mpz_mul(p, p, mpq_numref(r->point[j]));
            poly_add_scaled(&r->x[i], &map[4 * i + j], p);
        }
        if (i < d)
            poly_scale(&r->x[i], r->s->scale);
    }
    r->n = 0;
    for (int i = 0; i <= d; i++)
        r->n = r->x[i].n > r->n + 1 ? r->x[i].n - 1 : r->n;
    mpz_clears(q, p, NULL);
    r->made = 1;
}

/* Change all signs where W < 0, which it is on the whole piece or nowhere (K6). */
static void make_weight_positive(trace *r) {
    int d = r->m->d;
    mpz_t minus;
    if (mpz_sgn(r->beta[d][0]) >= 0)
        return;
    mpz_init_set_si(minus, -1);
    for (int i = 0; i <= d; i++) {
        poly_scale(&r->x[i], minus);
        for (size_t k = 0; k <= r->n; k++)
            mpz_neg(r->beta[i][k], r->beta[i][k]);
    }
    mpz_clear(minus);
}

/* The interval lies in one piece; its coefficients, and the simplices near it: test L1. */
static void enclose(trace *r, const claim *c) {
    int d = r->m->d;
    box b;
    while (r->piece < r->m->count && mpq_cmp(c->a, r->m->piece[r->piece].hi) >= 0) {
        r->piece++;
        r->made = 0;
    }
    if (r->piece == r->m->count || mpq_cmp(c->b, r->m->piece[r->piece].hi) > 0)
        fail(r, "the interval does not lie in one piece of the motion");
    if (!r->made)
        make_trajectory(r);
    for (int i = 0; i <= d; i++)
        bernstein(r->beta[i], &r->x[i], r->n, c->a, c->b);
    make_weight_positive(r);
    if (strict_sign(r->beta[d], r->n + 1) != 1)
        fail(r, "the weight's coefficients do not have one sign on the interval");
    for (size_t k = 0; k <= r->n; k++)
        box_take(&b, r->beta, k, d, k == 0);
    solid_near(&r->near, r->s, &b);
}

/* ---------------------------------------------------------------------------------------- forms */

/* The sign of coefficient k of a form's pullback. */
static int pulled_sign(trace *r, const mpz_t *form, size_t k) {
    mpz_t *value = &r->form[4];
    mpz_set_ui(*value, 0);
    for (int i = 0; i <= r->m->d; i++)
        mpz_addmul(*value, form[i], r->beta[i][k]);
    return mpz_sgn(*value);
}

/* The one strict sign of a form's pullback on the interval, or 0. */
static int form_strict(trace *r, const mpz_t *form) {
    int sign = pulled_sign(r, form, 0);
    for (size_t k = 1; k <= r->n && sign != 0; k++)
        if (pulled_sign(r, form, k) != sign)
            sign = 0;
    return sign;
}

/* 1 if all coefficients of a form's pullback are 0, or if `most` is 1, none is negative. */
static int form_holds(trace *r, const mpz_t *form, int most) {
    for (size_t k = 0; k <= r->n; k++) {
        int sign = pulled_sign(r, form, k);
        if (sign < 0 || sign > most)
            return 0;
    }
    return 1;
}

static const mpz_t *side_form(trace *r, const simplex *f, int k) {
    solid_side(r->form, r->s, f, f->axis, k);
    return (const mpz_t *)r->form;
}

/* Tests L2 and L3. */
static int cleared(trace *r, const simplex *f) {
    int clear = form_strict(r, (const mpz_t *)f->plane) != 0;
    for (int k = 0; k < r->s->d && !clear; k++)
        clear = form_strict(r, side_form(r, f, k)) < 0;
    return clear;
}

/* f = q^e g, e as large as can be: the signs of g and of q give those of f. */
static profile form_profile(trace *r, const claim *c, const mpz_t *form) {
    int sign = form_strict(r, form);
    profile out = {{sign, sign, sign}};
    poly f = {0};
    for (int i = 0; i <= r->m->d && sign == 0; i++)
        poly_add_scaled(&f, &r->x[i], form[i]);
    if (f.n > 0) {
        size_t power = 0;
        while (poly_divide(&f, c->q))
            power++;
        bernstein(r->root, &f, f.n - 1, c->a, c->b);
        sign = strict_sign(r->root, f.n);
        for (int p = 0; p < PLACES; p++)
            out.at[p] = sign == 0 ? UNKNOWN : power % 2 == 1 ? sign * c->q_sign[p] : sign;
        out.at[MID] = power > 0 ? 0 : UNKNOWN;
    }
    poly_clear(&f);
    return out;
}

/* ---------------------------------------------------------------------------------------- claims
 */

/* A simplex near the root: tests L4 and L5 on the sides that must be free of it; and where does it
 * hold the trajectory? */
static void meet(trace *r, claim *c, const simplex *f) {
    profile plane = form_profile(r, c, (const mpz_t *)f->plane);
    int out[PLACES], in[PLACES];
    for (int p = 0; p < PLACES; p++) {
        out[p] = plane.at[p] == 1 || plane.at[p] == -1;
        in[p] = plane.at[p] == 0;
    }
    for (int k = 0; k < r->s->d; k++) {
        profile side = form_profile(r, c, side_form(r, f, k));
        for (int p = 0; p < PLACES; p++) {
            out[p] = out[p] || side.at[p] == -1;
            in[p] = in[p] && (side.at[p] == 0 || side.at[p] == 1);
        }
    }
    for (int p = 0; p < PLACES; p++) {
        if ((c->letter[p] == 'O' || c->letter[p] == 'I') && !out[p])
            refute("line %zu, row %zu: facet %zu is not cleared beside the root", r->line, r->row,
                   f->facet);
        c->held[p] = c->held[p] || in[p];
    }
}

static const simplex *near_simplex(const trace *r, size_t k) {
    return &r->s->simplex[r->near.item[k]];
}

static void check_root(trace *r, claim *c) {
    const char *side = c->letter;
    for (size_t k = 0; k < r->near.count; k++)
        if (!cleared(r, near_simplex(r, k)))
            meet(r, c, near_simplex(r, k));
    for (int p = LEFT; p <= RIGHT; p += 2)
        if (side[p] == 'B' && !c->held[p])
            fail(r, "no facet holds the trajectory beside the root");
    int implied = side[LEFT] == 'B' || side[RIGHT] == 'B' ||
                  (side[LEFT] && side[RIGHT] && side[LEFT] != side[RIGHT]);
    if (!implied && !c->held[MID])
        fail(r, "no facet holds the trajectory at the root");
}

static void check_clear(trace *r) {
    for (size_t k = 0; k < r->near.count; k++)
        if (!cleared(r, near_simplex(r, k)))
            refute("line %zu, row %zu: facet %zu is not cleared", r->line, r->row,
                   near_simplex(r, k)->facet);
}

static void check_slide(trace *r) {
    int found = 0;
    for (size_t k = 0; k < r->near.count && !found; k++) {
        const simplex *f = near_simplex(r, k);
        found = form_holds(r, (const mpz_t *)f->plane, 0);
        for (int i = 0; i < r->s->d && found; i++)
            found = form_holds(r, side_form(r, f, i), 1);
    }
    if (!found)
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
    const mpq_t *e = c->letter[LEFT] ? (const mpq_t *)&c->b : (const mpq_t *)&c->a;
    poly_extend(q, 2);
    mpz_neg(q->c[0], mpq_numref(*e));
    mpz_set(q->c[1], mpq_denref(*e));
    c->q = q;
    c->q_sign[LEFT] = -1;
    c->q_sign[RIGHT] = 1;
}

static void check_kind(trace *r, claim *c, word kind, const poly *q) {
    poly end = {0};
    enclose(r, c);
    if (kind.length == 1) {
        (*kind.at == 'B' ? check_slide : check_clear)(r);
        return;
    }
    c->letter[LEFT] = kind.length == 3 || *kind.at != 'B' ? kind.at[0] : 0;
    c->letter[RIGHT] = kind.length == 3 || *kind.at == 'B' ? kind.at[kind.length - 1] : 0;
    c->q = q;
    if (kind.length == 2)
        root_at_end(&end, c);
    else
        isolate(r, c);
    check_root(r, c);
    poly_clear(&end);
}

/* ---------------------------------------------------------------------------------------- states
 */

/* c at the sample as d + 1 homogeneous integers, the last positive. */
static void sample_position(mpz_t *out, const trace *r) {
    int d = r->m->d;
    mpz_t power;
    mpz_init(power);
    for (int i = 0; i <= d; i++) {
        mpz_set_ui(power, 1);
        for (size_t k = r->n + 1; k-- > 0;) {
            mpz_mul(out[i], out[i], mpq_numref(r->sample));
            if (k < r->x[i].n)
                mpz_addmul(out[i], power, r->x[i].c[k]);
            mpz_mul(power, power, mpq_denref(r->sample));
        }
    }
    int negative = mpz_sgn(out[d]) < 0;
    for (int i = 0; i <= d && negative; i++)
        mpz_neg(out[i], out[i]);
    mpz_clear(power);
}

/* The state of the stretch that ends, by one ray (proofs/claims.md C6). */
static void check_state(trace *r) {
    size_t keep = r->piece;
    long sum;
    if (!r->free)
        return;
    if (r->sample_piece != r->piece || !r->made) {
        r->piece = r->sample_piece;
        make_trajectory(r);
    }
    mpz_t *x = integers(4);
    sample_position(x, r);
    if (!solid_ray(&sum, r->s, (const mpz_t *)x, 0, NULL) || sum != (r->free == 'I'))
        fail(r, "the state between two contacts is not what is claimed");
    integers_free(x, 4);
    r->made = r->made && keep == r->piece;
    r->piece = keep;
    r->free = 0;
}

/* The trajectory is off X at a time of the stretch r->free; keep the shortest. */
static void offer_sample(trace *r, const mpq_t t, int first) {
    size_t now = mpz_sizeinbase(mpq_numref(t), 2) + mpz_sizeinbase(mpq_denref(t), 2);
    size_t old =
        mpz_sizeinbase(mpq_numref(r->sample), 2) + mpz_sizeinbase(mpq_denref(r->sample), 2);
    if (!first && now >= old)
        return;
    mpq_set(r->sample, t);
    r->sample_piece = r->piece;
}

/* A letter at one or more times of the interval, those from `a` on or up to `b` where given. */
static void add_letter(trace *r, char letter, const mpq_t *a, const mpq_t *b) {
    if (r->length == 0 || r->word.at[r->length - 1] != letter) {
        check_state(r);
        if (r->length == r->word.length || r->word.at[r->length++] != letter)
            fail(r, "the intervals' word is not the row's");
    }
    if (letter == 'B')
        return;
    int first = !r->free;
    r->free = letter;
    if (a)
        offer_sample(r, *a, first);
    if (b)
        offer_sample(r, *b, first && !a);
}

/* O, I, B; one of O, I beside B; B between two of O, I, B. */
static int is_kind(word w) {
    size_t contacts = 0;
    for (size_t k = 0; k < w.length; k++) {
        if (w.at[k] != 'O' && w.at[k] != 'I' && w.at[k] != 'B')
            return 0;
        contacts += w.at[k] == 'B';
    }
    return w.length == 1 || (w.length == 2 && contacts == 1) || (w.length == 3 && w.at[1] == 'B');
}

void trace_interval(trace *r, word kind, const mpq_t to, const poly *q) {
    claim c = {.q = NULL};
    if (!is_kind(kind) || (q != NULL) != (kind.length == 3))
        fail(r, "an interval is of a kind that does not exist, or its polynomial is missing or too "
                "much");
    if (mpq_cmp(r->at, to) >= 0)
        fail(r, "an interval does not end after its beginning");
    if (r->length > 0 && r->word.at[r->length - 1] != *kind.at)
        fail(r, "an interval begins with another state than the one before it ends with");
    mpq_inits(c.a, c.b, NULL);
    mpq_set(c.a, r->at);
    mpq_set(c.b, to);
    check_kind(r, &c, kind, q);
    for (size_t k = 0; k < kind.length; k++)
        add_letter(r, kind.at[k], k == 0 ? &c.a : NULL, k + 1 == kind.length ? &c.b : NULL);
    mpq_set(r->at, to);
    mpq_clears(c.a, c.b, NULL);
}

void trace_end(trace *r) {
    if (mpq_cmp(r->at, r->m->piece[r->m->count - 1].hi) != 0)
        fail(r, "the row's intervals do not end at t1");
    if (r->length != r->word.length)
        fail(r, "the intervals' word is only the beginning of the row's");
    check_state(r);
}
