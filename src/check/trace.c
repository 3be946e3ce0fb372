/* The tests of a row's intervals: proofs/certificate.md, section 4.
 * SPDX-License-Identifier: MIT
 */
#include "trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What is known of a polynomial on an interval: its sign before, at and after the root, as '-',
 * '0',
 * '+', or '?'. '0' before or after says that it is the zero polynomial. */
typedef struct profile {
    char left, mid, right;
} profile;

/* The interval at hand. */
typedef struct claim {
    char left, right; /* O, I or B; 0: the interval has no such side */
    const poly *q;
    int q_left, q_right; /* signs of q on the sides */
    mpq_t a, b;
    int left_certain, mid_certain, right_certain; /* some simplex holds the trajectory there */
} claim;

static _Noreturn void fail(const trace *r, const char *what) {
    refute("line %zu, row %zu: %s", r->line, r->row, what);
}

void trace_init(trace *r, const solid *s, const motion *m, int unsweep) {
    memset(r, 0, sizeof *r);
    r->s = s;
    r->m = m;
    r->unsweep = unsweep;
    mpq_inits(r->at, r->sample, NULL);
    for (int i = 0; i < 3; i++)
        mpq_init(r->point[i]);
    for (int i = 0; i < 4; i++) {
        poly_init(&r->x[i]);
        mpz_init(r->form[i]);
    }
}

static mpz_t *more(mpz_t *old, size_t have, size_t want) {
    mpz_t *out = grow(old, want, sizeof *out);
    for (size_t k = have; k < want; k++)
        mpz_init(out[k]);
    return out;
}

static void fit(trace *r, size_t n) {
    if (n + 1 <= r->beta_room)
        return;
    for (int i = 0; i < 4; i++)
        r->beta[i] = more(r->beta[i], r->beta_room, n + 1);
    r->value = more(r->value, r->beta_room, n + 1);
    r->root = more(r->root, r->beta_room, n + 1);
    r->beta_room = n + 1;
}

void trace_clear(trace *r) {
    mpz_t *all[] = {r->beta[0], r->beta[1], r->beta[2], r->beta[3], r->value, r->root};
    for (int i = 0; i < 6; i++) {
        for (size_t k = 0; k < r->beta_room; k++)
            mpz_clear(all[i][k]);
        free(all[i]);
    }
    mpq_clears(r->at, r->sample, NULL);
    for (int i = 0; i < 3; i++)
        mpq_clear(r->point[i]);
    for (int i = 0; i < 4; i++) {
        poly_clear(&r->x[i]);
        mpz_clear(r->form[i]);
    }
    free(r->word);
    free(r->near.item);
}

void trace_start(trace *r) {
    mpq_set(r->at, r->m->piece[0].lo);
    r->piece = 0;
    r->made = 0;
    r->length = 0;
    r->free = 0;
}

/* With P = p / q: X_i = scale (sum_j N_ij p_j + N_id q), W = weight q. */
static void make_trajectory(trace *r) {
    const piece *m = &r->m->piece[r->piece];
    const poly(*map)[4] = r->unsweep ? m->forward : m->inverse;
    const poly *weight = r->unsweep ? &m->forward_weight : &m->inverse_weight;
    int d = r->m->d;
    mpz_t q, p;
    mpz_inits(q, p, NULL);
    mpz_set_ui(q, 1);
    for (int j = 0; j < d; j++)
        mpz_lcm(q, q, mpq_denref(r->point[j]));
    for (int i = 0; i < d; i++) {
        r->x[i].n = 0;
        poly_add_scaled(&r->x[i], &map[i][d], q);
        for (int j = 0; j < d; j++) {
            mpz_divexact(p, q, mpq_denref(r->point[j]));
            mpz_mul(p, p, mpq_numref(r->point[j]));
            poly_add_scaled(&r->x[i], &map[i][j], p);
        }
        poly_scale(&r->x[i], r->s->scale);
    }
    r->x[d].n = 0;
    poly_add_scaled(&r->x[d], weight, q);
    r->n = 0;
    for (int i = 0; i <= d; i++)
        if (r->x[i].n > r->n + 1)
            r->n = r->x[i].n - 1;
    fit(r, r->n);
    mpz_clears(q, p, NULL);
    r->made = 1;
}

/* W > 0 on the whole piece or W < 0 on the whole piece (motion_check_signs); made positive here. */
static void make_weight_positive(trace *r) {
    int d = r->m->d, sign = mpz_sgn(r->beta[d][0]);
    mpz_t minus;
    if (sign >= 0)
        return;
    mpz_init_set_si(minus, -1);
    for (int i = 0; i <= d; i++) {
        poly_scale(&r->x[i], minus);
        for (size_t k = 0; k <= r->n; k++)
            mpz_neg(r->beta[i][k], r->beta[i][k]);
    }
    mpz_clear(minus);
}

/* The interval lies in one piece; its coefficients, and the simplices near it. */
static void enclose(trace *r, const claim *c) {
    int d = r->m->d;
    box b = {{0, 0, 0}, {0, 0, 0}};
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
    for (int i = 0; i < d; i++)
        for (size_t k = 0; k <= r->n; k++) {
            double low, high;
            ratio_bounds(&low, &high, r->beta[i][k], r->beta[d][k]);
            b.low[i] = k == 0 || low < b.low[i] ? low : b.low[i];
            b.high[i] = k == 0 || high > b.high[i] ? high : b.high[i];
        }
    solid_near(&r->near, r->s, &b);
}

/* Coefficient k of a form's pullback. */
static void pull_back(mpz_t out, const trace *r, const mpz_t *form, size_t k) {
    mpz_set_ui(out, 0);
    for (int i = 0; i <= r->m->d; i++)
        mpz_addmul(out, form[i], r->beta[i][k]);
}

/* The one strict sign of a form's pullback on the interval, or 0. */
static int form_strict(trace *r, const mpz_t *form) {
    int sign = 0;
    for (size_t k = 0; k <= r->n; k++) {
        pull_back(r->value[0], r, form, k);
        int s = mpz_sgn(r->value[0]);
        if (s == 0 || (k > 0 && s != sign))
            return 0;
        sign = s;
    }
    return sign;
}

/* 1 if no coefficient is negative (all are zero, for a plane). */
static int form_not_negative(trace *r, const mpz_t *form, int zero) {
    for (size_t k = 0; k <= r->n; k++) {
        pull_back(r->value[0], r, form, k);
        int s = mpz_sgn(r->value[0]);
        if (s < 0 || (zero && s != 0))
            return 0;
    }
    return 1;
}

/* Tests L2 and L3. */
static int cleared(trace *r, const simplex *f) {
    if (form_strict(r, (const mpz_t *)f->plane) != 0)
        return 1;
    for (int k = 0; k < r->s->d; k++) {
        solid_side(r->form, r->s, f, k);
        if (form_strict(r, (const mpz_t *)r->form) < 0)
            return 1;
    }
    return 0;
}

static char sign_letter(int sign) {
    return sign > 0 ? '+' : sign < 0 ? '-' : '?';
}

static profile form_profile(trace *r, const claim *c, const mpz_t *form) {
    int sign = form_strict(r, form);
    if (sign != 0)
        return (profile){sign_letter(sign), sign_letter(sign), sign_letter(sign)};
    poly f;
    poly_init(&f);
    for (int i = 0; i <= r->m->d; i++)
        poly_add_scaled(&f, &r->x[i], form[i]);
    profile out = {'0', '0', '0'};
    if (f.n > 0) {
        size_t power = 0;
        while (poly_divide(&f, &f, c->q))
            power++;
        bernstein(r->root, &f, f.n - 1, c->a, c->b);
        sign = strict_sign(r->root, f.n);
        int odd = power % 2 == 1;
        out = (profile){sign_letter(sign * (odd ? c->q_left : 1)), power > 0 ? '0' : '?',
                        sign_letter(sign * (odd ? c->q_right : 1))};
    }
    poly_clear(&f);
    return out;
}

/* A simplex near the root: is it left out on the sides that must be free of it, and where does it
 * hold the trajectory for certain? Tests L4, L5, H. */
static void meet(trace *r, claim *c, const simplex *f) {
    profile plane = form_profile(r, c, (const mpz_t *)f->plane);
    int left_out = plane.left == '-' || plane.left == '+';
    int right_out = plane.right == '-' || plane.right == '+';
    int left_in = plane.left == '0', mid_in = plane.mid == '0', right_in = plane.right == '0';
    for (int k = 0; k < r->s->d; k++) {
        solid_side(r->form, r->s, f, k);
        profile side = form_profile(r, c, (const mpz_t *)r->form);
        left_out = left_out || side.left == '-';
        right_out = right_out || side.right == '-';
        left_in = left_in && (side.left == '0' || side.left == '+');
        mid_in = mid_in && (side.mid == '0' || side.mid == '+');
        right_in = right_in && (side.right == '0' || side.right == '+');
    }
    if (((c->left == 'O' || c->left == 'I') && !left_out) ||
        ((c->right == 'O' || c->right == 'I') && !right_out))
        refute("line %zu, row %zu: facet %zu is not cleared beside the root", r->line, r->row,
               f->facet);
    c->left_certain |= left_in;
    c->mid_certain |= mid_in;
    c->right_certain |= right_in;
}

static void check_clear(trace *r) {
    for (size_t k = 0; k < r->near.count; k++) {
        const simplex *f = &r->s->simplex[r->near.item[k]];
        if (!cleared(r, f))
            refute("line %zu, row %zu: facet %zu is not cleared", r->line, r->row, f->facet);
    }
}

static void check_slide(trace *r) {
    int found = 0;
    for (size_t k = 0; k < r->near.count && !found; k++) {
        const simplex *f = &r->s->simplex[r->near.item[k]];
        found = form_not_negative(r, (const mpz_t *)f->plane, 1);
        for (int i = 0; i < r->s->d && found; i++) {
            solid_side(r->form, r->s, f, i);
            found = form_not_negative(r, (const mpz_t *)r->form, 0);
        }
    }
    if (!found)
        fail(r, "no facet holds the trajectory on the interval");
}

static void check_root(trace *r, claim *c) {
    for (size_t k = 0; k < r->near.count; k++) {
        const simplex *f = &r->s->simplex[r->near.item[k]];
        if (!cleared(r, f))
            meet(r, c, f);
    }
    if ((c->left == 'B' && !c->left_certain) || (c->right == 'B' && !c->right_certain))
        fail(r, "no facet holds the trajectory beside the root");
    int forced = c->left && c->right && (c->left == 'B' || c->left != c->right || c->right == 'B');
    if (!forced && !c->mid_certain)
        fail(r, "no facet holds the trajectory at the root");
}

/* q has just one root in the open interval, a simple one, and none at its ends: one sign change
 * (proofs/claims.md C24). */
static void isolate(trace *r, claim *c) {
    size_t changes = 0;
    int last = 0;
    if (c->q->n < 2 || c->q->n > r->n + 1)
        fail(r, "the polynomial's degree is not that of a divisor");
    bernstein(r->root, c->q, c->q->n - 1, c->a, c->b);
    for (size_t k = 0; k < c->q->n; k++) {
        int s = mpz_sgn(r->root[k]);
        changes += s != 0 && last != 0 && s != last;
        last = s != 0 ? s : last;
    }
    c->q_left = mpz_sgn(r->root[0]);
    c->q_right = mpz_sgn(r->root[c->q->n - 1]);
    if (changes != 1 || c->q_left == 0 || c->q_right == 0)
        fail(r, "the interval does not isolate one root of the polynomial");
}

/* q = t - e for an end e of the interval. */
static void root_at_end(poly *q, claim *c) {
    const mpq_t *e = c->left ? (const mpq_t *)&c->b : (const mpq_t *)&c->a;
    poly_zeros(q, 2);
    mpz_neg(q->c[0], mpq_numref(*e));
    mpz_set(q->c[1], mpq_denref(*e));
    c->q = q;
    c->q_left = -1;
    c->q_right = 1;
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

/* The state of the stretch, by one ray (proofs/claims.md C6). */
static void check_state(trace *r) {
    size_t keep = r->piece;
    int d = r->m->d;
    mpz_t at[4], power;
    long sum;
    if (!r->free)
        return;
    if (r->sample_piece != r->piece || !r->made) {
        r->piece = r->sample_piece;
        make_trajectory(r);
    }
    mpz_init(power);
    for (int i = 0; i <= d; i++) {
        mpz_init(at[i]);
        mpz_set_ui(power, 1);
        for (size_t k = r->n + 1; k-- > 0;) {
            mpz_mul(at[i], at[i], mpq_numref(r->sample));
            if (k < r->x[i].n)
                mpz_addmul(at[i], power, r->x[i].c[k]);
            mpz_mul(power, power, mpq_denref(r->sample));
        }
    }
    int negative = mpz_sgn(at[d]) < 0;
    for (int i = 0; i <= d && negative; i++)
        mpz_neg(at[i], at[i]);
    if (!solid_ray(&sum, r->s, at, 0, NULL) || sum != (r->free == 'I'))
        fail(r, "the state between two contacts is not what is claimed");
    for (int i = 0; i <= d; i++)
        mpz_clear(at[i]);
    mpz_clear(power);
    if (keep != r->piece)
        r->made = 0;
    r->piece = keep;
    r->free = 0;
}

/* A letter at one or more times of the interval, those from `a` on or up to `b` where given. */
static void add_letter(trace *r, char letter, const mpq_t *a, const mpq_t *b) {
    if (r->length == 0 || r->word[r->length - 1] != letter) {
        if (r->length >= MOST_WORD)
            give_up("line %zu: a word of more than %d letters", r->line, MOST_WORD);
        check_state(r);
        r->word = room_for(r->word, r->length + 1, &r->room, 1);
        r->word[r->length++] = letter;
        r->word[r->length] = '\0';
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

static int is_kind(word w) {
    static const char *const kinds[] = {"O",   "I",   "B",   "BO",  "BI",  "OB",  "IB",  "OBO",
                                        "OBI", "IBO", "IBI", "OBB", "IBB", "BBO", "BBI", "BBB"};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        if (word_is(w, kinds[k]))
            return 1;
    return 0;
}

static void check_kind(trace *r, claim *c, word kind, const poly *q) {
    poly end;
    poly_init(&end);
    enclose(r, c);
    if (kind.length == 1 && *kind.at == 'B') {
        check_slide(r);
    } else if (kind.length == 1) {
        check_clear(r);
    } else {
        c->left = kind.at[0] == 'B' && kind.length == 2 ? 0 : kind.at[0];
        c->right =
            kind.at[kind.length - 1] == 'B' && kind.length == 2 ? 0 : kind.at[kind.length - 1];
        c->q = q;
        if (kind.length == 2)
            root_at_end(&end, c);
        else
            isolate(r, c);
        check_root(r, c);
    }
    poly_clear(&end);
}

void trace_interval(trace *r, word kind, const mpq_t to, const poly *q) {
    claim c = {.q = NULL};
    if (!is_kind(kind) || (q != NULL) != (kind.length == 3))
        fail(r, "an interval is of a kind that does not exist, or its polynomial is missing or too "
                "much");
    if (mpq_cmp(r->at, to) >= 0)
        fail(r, "an interval does not end after its beginning");
    if (r->length > 0 && r->word[r->length - 1] != *kind.at)
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
    check_state(r);
}
