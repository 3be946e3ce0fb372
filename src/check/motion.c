/* Motion files: pieces, key frames, relative motions, sequences; and their polynomials.
 * SPDX-License-Identifier: MIT
 */
#include "motion.h"

#include <stdlib.h>

static motion read_one(const json *where, int d, const char *path);

static piece *add_piece(motion *m, const mpq_t lo, const mpq_t hi) {
    if (m->count >= MOST_PIECES)
        give_up("the motion has more than %d pieces", MOST_PIECES);
    if (mpq_cmp(lo, hi) >= 0)
        refute("motion: piece %zu does not have lo < hi", m->count);
    if (m->count > 0 && !mpq_equal(m->piece[m->count - 1].hi, lo))
        refute("motion: piece %zu does not begin where the one before it ends", m->count);
    m->piece = grow(m->piece, m->count + 1, sizeof *m->piece);
    piece *out = &m->piece[m->count++];
    mpq_inits(out->lo, out->hi, NULL);
    mpq_set(out->lo, lo);
    mpq_set(out->hi, hi);
    affine_identity(&out->m, m->d);
    return out;
}

static const json *member(const json *where, const char *key, const char *path) {
    const json *out = json_member(where, key);
    if (!out)
        give_up("%s:%zu: key '%s' is expected", path, where->line, key);
    return out;
}

static void read_constant(mpq_t out, const json *where, const char *path) {
    fraction f;
    fraction_init(&f);
    entry_read(&f, where, NULL, path);
    (void)fraction_constant(out, &f);
    fraction_clear(&f);
}

static int compare_parts(const void *a, const void *b) {
    return mpq_cmp(*(const mpq_t *)a, *(const mpq_t *)b);
}

/* All k/n of the turns within a transform, ascending, from 0 to 1; some may be equal. */
static mpq_t *read_parts(size_t *count, const json *transform, const char *path) {
    size_t *n = NULL, turns = 0, at = 0;
    n = grow(n, 1, sizeof *n);
    n[turns++] = 1;
    transform_turns(transform, &n, &turns, path);
    *count = 0;
    for (size_t k = 0; k < turns; k++)
        *count += n[k] + 1;
    mpq_t *out = grow(NULL, *count, sizeof *out);
    for (size_t k = 0; k < turns; k++)
        for (size_t i = 0; i <= n[k]; i++, at++) {
            mpq_init(out[at]);
            mpq_set_ui(out[at], i, n[k]);
            mpq_canonicalize(out[at]);
        }
    free(n);
    qsort(out, *count, sizeof *out, compare_parts);
    return out;
}

static void read_piece(motion *m, const json *where, const char *path) {
    const json *t = member(where, "t", path), *transform = member(where, "transform", path);
    if (where->kind != JSON_OBJECT || where->count != 2 || t->kind != JSON_ARRAY || t->count != 2)
        give_up("%s:%zu: a piece is {\"t\": [lo, hi], \"transform\": ...}", path, where->line);
    mpq_t lo, hi, a, b, width;
    size_t parts;
    mpq_inits(lo, hi, a, b, width, NULL);
    read_constant(lo, &t->item[0], path);
    read_constant(hi, &t->item[1], path);
    if (mpq_cmp(lo, hi) >= 0)
        refute("motion: piece %zu does not have lo < hi", m->count);
    mpq_sub(width, hi, lo);
    mpq_t *part = read_parts(&parts, transform, path);
    for (size_t k = 0; k + 1 < parts; k++) {
        if (mpq_equal(part[k], part[k + 1]))
            continue;
        mpq_mul(a, part[k], width);
        mpq_add(a, a, lo);
        mpq_mul(b, part[k + 1], width);
        mpq_add(b, b, lo);
        piece *p = add_piece(m, a, b);
        transform_read(&p->m, transform, m->d, lo, hi, part[k], part[k + 1], path);
    }
    for (size_t k = 0; k < parts; k++)
        mpq_clear(part[k]);
    free(part);
    mpq_clears(lo, hi, a, b, width, NULL);
}

typedef struct frame {
    mpq_t t, position[3], rotation[4];
} frame;

static void read_numbers(mpq_t *out, int n, const json *where, const char *path) {
    if (where->kind != JSON_ARRAY || where->count != (size_t)n)
        give_up("%s:%zu: an array of %d numbers is expected", path, where->line, n);
    for (int k = 0; k < n; k++)
        read_constant(out[k], &where->item[k], path);
}

static void read_frame(frame *f, const json *where, int d, const char *path) {
    const json *position = json_member(where, "position");
    const json *rotation = json_member(where, d == 3 ? "quaternion" : "complex");
    if (where->kind != JSON_OBJECT ||
        where->count != 1 + (size_t)(position != NULL) + (size_t)(rotation != NULL))
        give_up("%s:%zu: a frame has t, position and %s", path, where->line,
                d == 3 ? "quaternion" : "complex");
    mpq_init(f->t);
    for (int k = 0; k < 3; k++)
        mpq_init(f->position[k]);
    for (int k = 0; k < 4; k++)
        mpq_init(f->rotation[k]);
    mpq_set_ui(f->rotation[0], 1, 1);
    read_constant(f->t, member(where, "t", path), path);
    if (position)
        read_numbers(f->position, d, position, path);
    if (rotation && d == 3)
        read_numbers(f->rotation, 4, rotation, path);
    if (rotation && d == 2) {
        read_numbers(f->rotation, 2, rotation, path);
        mpq_swap(f->rotation[1], f->rotation[3]);
    }
}

/* The linear function with values a at lo and b at hi. */
static void between(fraction *out, const mpq_t a, const mpq_t b, const frame *f, const frame *g) {
    mpq_t slope, width;
    fraction t;
    mpq_inits(slope, width, NULL);
    fraction_init(&t);
    mpq_sub(width, g->t, f->t);
    mpq_sub(slope, b, a);
    mpq_div(slope, slope, width);
    mpq_mul(width, slope, f->t);
    mpq_sub(width, a, width);
    poly_zeros(&t.num, 2);
    mpz_set_ui(t.num.c[1], 1);
    fraction_shift(out, &t, width, slope);
    fraction_clear(&t);
    mpq_clears(slope, width, NULL);
}

static void clear_frame(frame *f) {
    mpq_clear(f->t);
    for (int k = 0; k < 3; k++)
        mpq_clear(f->position[k]);
    for (int k = 0; k < 4; k++)
        mpq_clear(f->rotation[k]);
}

static void read_frames(motion *m, const json *where, const char *path) {
    frame f, g;
    fraction q[4];
    if (where->kind != JSON_ARRAY || where->count < 2)
        give_up("%s:%zu: at least two frames are expected", path, where->line);
    for (int k = 0; k < 4; k++)
        fraction_init(&q[k]);
    read_frame(&f, &where->item[0], m->d, path);
    for (size_t i = 1; i < where->count; i++) {
        if (where->item[i].count != where->item[0].count)
            give_up("%s:%zu: a frame lacks what another has", path, where->item[i].line);
        read_frame(&g, &where->item[i], m->d, path);
        piece *p = add_piece(m, f.t, g.t);
        for (int k = 0; k < 4; k++)
            between(&q[k], f.rotation[k], g.rotation[k], &f, &g);
        rotation_of_quaternion(&p->m, q);
        for (int k = 0; k < m->d; k++)
            between(&p->m.at[k][m->d], f.position[k], g.position[k], &f, &g);
        clear_frame(&f);
        f = g;
    }
    clear_frame(&f);
    for (int k = 0; k < 4; k++)
        fraction_clear(&q[k]);
}

static void read_relative(motion *m, const json *where, const char *path) {
    motion a = read_one(member(where, "moving", path), m->d, path);
    motion b = read_one(member(where, "frame", path), m->d, path);
    size_t i = 0, k = 0;
    mpq_t lo;
    affine inverse;
    if (where->count != 2 || !mpq_equal(a.piece[0].lo, b.piece[0].lo) ||
        !mpq_equal(a.piece[a.count - 1].hi, b.piece[b.count - 1].hi))
        refute("motion: moving and frame do not have one interval of time");
    mpq_init(lo);
    affine_identity(&inverse, m->d);
    mpq_set(lo, a.piece[0].lo);
    while (i < a.count && k < b.count) {
        int order = mpq_cmp(a.piece[i].hi, b.piece[k].hi);
        piece *p = add_piece(m, lo, order <= 0 ? a.piece[i].hi : b.piece[k].hi);
        affine_inverse(&inverse, &b.piece[k].m);
        affine_compose(&p->m, &inverse, &a.piece[i].m);
        mpq_set(lo, p->hi);
        i += order <= 0;
        k += order >= 0;
    }
    affine_clear(&inverse);
    mpq_clear(lo);
}

/* On [j-1, j] M_j(tau) after what the motions before it have ended in. */
static void read_sequence(motion *m, const json *where, const char *path) {
    affine end;
    mpq_t a, b, lo, hi;
    if (where->kind != JSON_ARRAY || where->count == 0)
        give_up("%s:%zu: an array of motions is expected", path, where->line);
    mpq_inits(a, b, lo, hi, NULL);
    affine_identity(&end, m->d);
    for (size_t j = 0; j < where->count; j++) {
        motion one = read_one(&where->item[j], m->d, path);
        const piece *first = &one.piece[0], *last = &one.piece[one.count - 1];
        mpq_sub(b, last->hi, first->lo); /* tau = a + b t */
        mpq_set_ui(a, (unsigned long)j, 1);
        mpq_mul(a, a, b);
        mpq_sub(a, first->lo, a);
        for (size_t k = 0; k < one.count; k++) {
            mpq_sub(lo, one.piece[k].lo, a);
            mpq_div(lo, lo, b);
            mpq_sub(hi, one.piece[k].hi, a);
            mpq_div(hi, hi, b);
            piece *p = add_piece(m, lo, hi);
            for (int i = 0; i < m->d; i++)
                for (int c = 0; c <= m->d; c++)
                    fraction_shift(&p->m.at[i][c], &one.piece[k].m.at[i][c], a, b);
            affine_compose(&p->m, &p->m, &end);
        }
        mpq_set_ui(hi, (unsigned long)j + 1, 1);
        if (!affine_value(&end, &m->piece[m->count - 1].m, hi))
            refute("motion: a pole at the end of motion %zu of a sequence", j);
    }
    affine_clear(&end);
    mpq_clears(a, b, lo, hi, NULL);
}

static motion read_one(const json *where, int d, const char *path) {
    motion m = {d, 0, NULL};
    size_t dimension;
    const json *own = member(where, "dimension", path);
    if (where->kind != JSON_OBJECT || where->count != 2)
        give_up("%s:%zu: a motion has a dimension and one thing more", path, where->line);
    if (own->kind != JSON_NUMBER || !count_read(&dimension, own->text) ||
        (dimension != 2 && dimension != 3) || (d != 0 && (int)dimension != d))
        give_up("%s:%zu: the dimension is not 2 or 3, or not that of the motion around", path,
                own->line);
    m.d = (int)dimension;
    const json *value;
    if ((value = json_member(where, "keyframes")) != NULL)
        read_frames(&m, value, path);
    else if ((value = json_member(where, "relative")) != NULL)
        read_relative(&m, value, path);
    else if ((value = json_member(where, "sequence")) != NULL)
        read_sequence(&m, value, path);
    else {
        value = member(where, "pieces", path);
        if (value->kind != JSON_ARRAY || value->count == 0)
            give_up("%s:%zu: an array of pieces is expected", path, value->line);
        for (size_t k = 0; k < value->count; k++)
            read_piece(&m, &value->item[k], path);
    }
    return m;
}

/* The same map over one denominator: entries, weight, without a common factor. */
static void clear_denominators(poly out[3][4], poly *weight, const affine *a) {
    poly g, quotient;
    poly_init(&g);
    poly_init(&quotient);
    poly_init(weight);
    poly_zeros(weight, 1);
    mpz_set_ui(weight->c[0], 1);
    for (int i = 0; i < a->d; i++)
        for (int k = 0; k <= a->d; k++) {
            const poly *den = &a->at[i][k].den;
            poly_common(&g, weight, den);
            (void)poly_divide(&quotient, den, &g);
            poly_mul(weight, weight, &quotient);
        }
    poly_set(&g, weight);
    for (int i = 0; i < a->d; i++)
        for (int k = 0; k <= a->d; k++) {
            poly_init(&out[i][k]);
            if (!poly_divide(&quotient, weight, &a->at[i][k].den))
                give_up("a common denominator is none");
            poly_mul(&out[i][k], &quotient, &a->at[i][k].num);
            poly_common(&g, &g, &out[i][k]);
        }
    for (int i = 0; i < a->d; i++)
        for (int k = 0; k <= a->d; k++)
            if (!poly_divide(&out[i][k], &out[i][k], &g))
                give_up("a common divisor does not divide");
    if (!poly_divide(weight, weight, &g))
        give_up("a common divisor does not divide");
    poly_clear(&g);
    poly_clear(&quotient);
}

static void find_det(poly *out, const piece *p, int d) {
    poly a, b;
    poly_init(out);
    poly_init(&a);
    poly_init(&b);
    const poly(*m)[4] = p->forward;
    for (int k = 0; k < d; k++) {
        int i = (k + 1) % d, j = (k + 2) % d;
        if (d == 2) { /* m00 m11 - m01 m10 */
            poly_mul(&a, &m[0][k], &m[1][1 - k]);
            (k == 0 ? poly_add : poly_sub)(out, out, &a);
            continue;
        }
        poly_mul(&a, &m[1][i], &m[2][j]);
        poly_mul(&b, &m[1][j], &m[2][i]);
        poly_sub(&a, &a, &b);
        poly_mul(&a, &a, &m[0][k]);
        poly_add(out, out, &a);
    }
    poly_clear(&a);
    poly_clear(&b);
}

static void check_continuity(const motion *m, size_t k) {
    affine left, right;
    mpq_t a, b;
    mpq_inits(a, b, NULL);
    affine_identity(&left, m->d);
    affine_identity(&right, m->d);
    int same = affine_value(&left, &m->piece[k - 1].m, m->piece[k].lo) &&
               affine_value(&right, &m->piece[k].m, m->piece[k].lo);
    for (int i = 0; i < m->d; i++)
        for (int c = 0; c <= m->d; c++)
            same = same && fraction_constant(a, &left.at[i][c]) &&
                   fraction_constant(b, &right.at[i][c]) && mpq_equal(a, b);
    if (!same)
        refute("motion: it jumps or has a pole at the beginning of piece %zu", k);
    affine_clear(&left);
    affine_clear(&right);
    mpq_clears(a, b, NULL);
}

motion motion_read(const char *path, const char *text, size_t length) {
    json tree = json_read(path, text, length);
    motion m = read_one(&tree, 0, path);
    affine inverse;
    affine_identity(&inverse, m.d);
    for (size_t k = 0; k < m.count; k++) {
        piece *p = &m.piece[k];
        if (k > 0)
            check_continuity(&m, k);
        affine_inverse(&inverse, &p->m);
        clear_denominators(p->forward, &p->forward_weight, &p->m);
        clear_denominators(p->inverse, &p->inverse_weight, &inverse);
        find_det(&p->det, p, m.d);
    }
    affine_clear(&inverse);
    return m;
}
