/* Transforms of a motion file: JSON to affine maps.
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include "expression.h"
#include "motion.h"

typedef struct stretch {
    int d;
    fraction s;     /* (t - lo) / (hi - lo) */
    mpq_t from, to; /* the part of [0, 1] that is read */
    const char *path;
} stretch;

static _Noreturn void fail(const stretch *x, const json *where, const char *what) {
    give_up("%s:%zu: %s", x->path, where->line, what);
}

void entry_read(fraction *out, const json *where, const fraction *s, const char *path) {
    if (where->kind != JSON_STRING && where->kind != JSON_NUMBER)
        give_up("%s:%zu: an expression is expected", path, where->line);
    expression_read(out, where->text, s, path, where->line);
}

/* An array of just n entries. */
static void read_entries(fraction *out, int n, const json *where, const stretch *x) {
    if (where->kind != JSON_ARRAY || where->count != (size_t)n)
        give_up("%s:%zu: an array of %d entries is expected", x->path, where->line, n);
    for (int k = 0; k < n; k++)
        entry_read(&out[k], &where->item[k], &x->s, x->path);
}

static void apply(fraction *out, char op, const fraction *a, const fraction *b) {
    fraction_apply(out, op, a, b);
}

static void set_integer(fraction *f, long value) {
    mpq_t q;
    mpq_init(q);
    mpq_set_si(q, value, 1);
    fraction_set_q(f, q);
    mpq_clear(q);
}

/* out += factor a b */
static void add_product(fraction *out, long factor, const fraction *a, const fraction *b) {
    fraction p, f;
    fraction_init(&p);
    fraction_init(&f);
    set_integer(&f, factor);
    apply(&p, '*', a, b);
    apply(&p, '*', &p, &f);
    apply(out, '+', out, &p);
    fraction_clear(&p);
    fraction_clear(&f);
}

/* (w, x, y, z): entry (i, i) is 1 - 2 (q_j^2 + q_k^2) / |q|^2, entry (i, j) 2 (q_i q_j - w q_k) /
 * |q|^2, entry (i, k) 2 (q_i q_k + w q_j) / |q|^2 for (i, j, k) cyclic. */
void rotation_of_quaternion(affine *out, const fraction q[4]) {
    fraction norm, one, zero;
    fraction_init(&norm);
    fraction_init(&one);
    fraction_init(&zero);
    set_integer(&one, 1);
    for (int k = 0; k < 4; k++)
        add_product(&norm, 1, &q[k], &q[k]);
    for (int i = 0; i < out->d; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        for (int c = 0; c < out->d; c++) {
            fraction *at = &out->at[i][c];
            fraction_set(at, &zero);
            add_product(at, c == i ? -2 : 2, &q[1 + (c == i ? j : i)], &q[1 + (c == i ? j : c)]);
            if (c == i)
                add_product(at, -2, &q[1 + k], &q[1 + k]);
            else
                add_product(at, c == j ? -2 : 2, &q[0], &q[1 + (c == j ? k : j)]);
            apply(at, '/', at, &norm);
            if (c == i)
                apply(at, '+', at, &one);
        }
    }
    fraction_clear(&norm);
    fraction_clear(&one);
    fraction_clear(&zero);
}

/* out = translation by c, after out, after translation by -c. */
static void about(affine *out, const json *center, const stretch *x) {
    affine move;
    fraction c[3], zero;
    if (!center)
        return;
    affine_identity(&move, x->d);
    fraction_init(&zero);
    for (int k = 0; k < 3; k++)
        fraction_init(&c[k]);
    read_entries(c, x->d, center, x);
    for (int k = 0; k < x->d; k++)
        apply(&move.at[k][x->d], '-', &zero, &c[k]);
    affine_compose(out, out, &move);
    for (int k = 0; k < x->d; k++)
        fraction_set(&move.at[k][x->d], &c[k]);
    affine_compose(out, &move, out);
    affine_clear(&move);
    fraction_clear(&zero);
    for (int k = 0; k < 3; k++)
        fraction_clear(&c[k]);
}

/* A quaternion (w, v / |v|) of the axis v, whose length must be rational and constant here. */
static void read_axis(fraction v[3], const json *where, const stretch *x) {
    mpq_t c, length;
    fraction f;
    const json *axis = json_member(where, "axis");
    if ((axis != NULL) != (x->d == 3))
        fail(x, where, "an axis is for three dimensions, and wanted there");
    if (!axis) {
        set_integer(&v[2], 1);
        return;
    }
    mpq_inits(c, length, NULL);
    fraction_init(&f);
    read_entries(v, 3, axis, x);
    for (int k = 0; k < 3; k++) {
        if (!fraction_constant(c, &v[k]))
            fail(x, axis, "an axis that is not constant is not read here");
        mpq_mul(c, c, c);
        mpq_add(length, length, c);
    }
    if (mpq_sgn(length) == 0 || !mpz_perfect_square_p(mpq_numref(length)) ||
        !mpz_perfect_square_p(mpq_denref(length)))
        fail(x, axis, "the length of the axis is zero or not rational");
    mpz_sqrt(mpq_numref(length), mpq_numref(length));
    mpz_sqrt(mpq_denref(length), mpq_denref(length));
    fraction_set_q(&f, length);
    for (int k = 0; k < 3; k++)
        apply(&v[k], '/', &v[k], &f);
    fraction_clear(&f);
    mpq_clears(c, length, NULL);
}

/* Rotate by n 2 atan(tan): the half angle is that of (1 + i tan)^n. */
static void rotate(affine *out, const fraction v[3], const fraction *tan, long n) {
    fraction a, b, c, e, q[4];
    fraction *all[] = {&a, &b, &c, &e, &q[0], &q[1], &q[2], &q[3]};
    if (labs(n) > MOST_DEGREE)
        give_up("the motion rotates more than %d times", MOST_DEGREE);
    for (int k = 0; k < 8; k++)
        fraction_init(all[k]);
    set_integer(&a, 1);
    for (long k = 0; k < labs(n); k++) {
        fraction_set(&c, &a);
        fraction_set(&e, &b);
        add_product(&c, n > 0 ? -1 : 1, &b, tan);
        add_product(&e, n > 0 ? 1 : -1, &a, tan);
        fraction_set(&a, &c);
        fraction_set(&b, &e);
    }
    fraction_set(&q[0], &a);
    for (int k = 0; k < 3; k++)
        apply(&q[1 + k], '*', &b, &v[k]);
    rotation_of_quaternion(out, q);
    for (int k = 0; k < 8; k++)
        fraction_clear(all[k]);
}

static long read_whole(const json *where, const char *path) {
    mpq_t value;
    fraction f;
    mpq_init(value);
    fraction_init(&f);
    entry_read(&f, where, NULL, path);
    if (!fraction_constant(value, &f) || mpz_cmp_ui(mpq_denref(value), 1) != 0 ||
        mpz_cmpabs_ui(mpq_numref(value), MOST_PIECES) > 0)
        give_up("%s:%zu: a whole number of at most %d is expected", path, where->line, MOST_PIECES);
    long out = mpz_get_si(mpq_numref(value));
    mpq_clear(value);
    fraction_clear(&f);
    return out;
}

static void check_keys(const json *where, const char *const *keys, const char *path) {
    for (size_t k = 0; k < where->count; k++) {
        int known = 0;
        for (int i = 0; keys[i]; i++)
            known = known || word_is(where->item[k].key, keys[i]);
        if (!known)
            give_up("%s:%zu: key '%.*s' is not expected here", path, where->item[k].line,
                    WORD(where->item[k].key));
    }
}

static const json *wanted(const json *where, const char *key, const char *path) {
    const json *out = json_member(where, key);
    if (!out)
        give_up("%s:%zu: key '%s' is expected", path, where->line, key);
    return out;
}

static void read_rotate(affine *out, const json *where, const stretch *x) {
    static const char *const keys[] = {"tan_half", "times", "center", "axis", NULL};
    fraction v[3], tan;
    check_keys(where, keys, x->path);
    for (int k = 0; k < 3; k++)
        fraction_init(&v[k]);
    fraction_init(&tan);
    read_axis(v, where, x);
    entry_read(&tan, wanted(where, "tan_half", x->path), &x->s, x->path);
    const json *times = json_member(where, "times");
    rotate(out, v, &tan, times ? read_whole(times, x->path) : 1);
    about(out, json_member(where, "center"), x);
    for (int k = 0; k < 3; k++)
        fraction_clear(&v[k]);
    fraction_clear(&tan);
}

/* On the part [j/n, (j+1)/n] of n quarters: j quarters (tan 1), then tan = n s - j; turned the
 * other way for a negative number. */
static void read_turn(affine *out, const json *where, const stretch *x) {
    static const char *const keys[] = {"quarters", "center", "axis", NULL};
    fraction v[3], tan, c;
    affine more;
    mpq_t n, j;
    check_keys(where, keys, x->path);
    long quarters = read_whole(wanted(where, "quarters", x->path), x->path);
    mpq_inits(n, j, NULL);
    for (int k = 0; k < 3; k++)
        fraction_init(&v[k]);
    fraction_init(&tan);
    fraction_init(&c);
    affine_identity(&more, x->d);
    read_axis(v, where, x);
    mpq_set_si(n, labs(quarters), 1);
    mpq_mul(j, x->from, n);
    mpz_fdiv_q(mpq_numref(j), mpq_numref(j), mpq_denref(j));
    mpz_set_ui(mpq_denref(j), 1);
    set_integer(&tan, 1);
    rotate(out, v, &tan, mpz_fdiv_ui(mpq_numref(j), 4) * (quarters < 0 ? -1 : 1));
    if (quarters != 0) {
        fraction_set_q(&c, n);
        apply(&tan, '*', &c, &x->s);
        fraction_set_q(&c, j);
        apply(&tan, '-', &tan, &c);
        rotate(&more, v, &tan, quarters < 0 ? -1 : 1);
        affine_compose(out, &more, out);
    }
    about(out, json_member(where, "center"), x);
    affine_clear(&more);
    mpq_clears(n, j, NULL);
    for (int k = 0; k < 3; k++)
        fraction_clear(&v[k]);
    fraction_clear(&tan);
    fraction_clear(&c);
}

static void read_matrix(affine *out, const json *where, const stretch *x) {
    int d = x->d;
    fraction last[4];
    mpq_t value;
    if (where->kind != JSON_ARRAY || (where->count != (size_t)d && where->count != (size_t)d + 1))
        fail(x, where, "a matrix has d or d + 1 rows");
    for (int i = 0; i < d; i++)
        read_entries(out->at[i], d + 1, &where->item[i], x);
    if (where->count == (size_t)d)
        return;
    mpq_init(value);
    for (int k = 0; k < 4; k++)
        fraction_init(&last[k]);
    read_entries(last, d + 1, &where->item[d], x);
    for (int k = 0; k <= d; k++)
        if (!fraction_constant(value, &last[k]) || mpq_cmp_ui(value, k == d, 1) != 0)
            fail(x, where, "the last row of a matrix is 0 ... 0 1");
    for (int k = 0; k < 4; k++)
        fraction_clear(&last[k]);
    mpq_clear(value);
}

static void read_quaternion(affine *out, const json *where, const stretch *x) {
    fraction q[4];
    if (x->d != 3)
        fail(x, where, "a quaternion is for three dimensions");
    for (int k = 0; k < 4; k++)
        fraction_init(&q[k]);
    read_entries(q, 4, where, x);
    rotation_of_quaternion(out, q);
    for (int k = 0; k < 4; k++)
        fraction_clear(&q[k]);
}

static void read_scale(affine *out, const json *where, const stretch *x) {
    fraction f[3];
    for (int k = 0; k < 3; k++)
        fraction_init(&f[k]);
    if (where->kind == JSON_ARRAY)
        read_entries(f, x->d, where, x);
    for (int k = 0; k < x->d; k++) {
        if (where->kind != JSON_ARRAY)
            entry_read(&f[k], where, &x->s, x->path);
        fraction_set(&out->at[k][k], &f[k]);
    }
    for (int k = 0; k < 3; k++)
        fraction_clear(&f[k]);
}

static void read_transform(affine *out, const json *where, const stretch *x) {
    static const char *const keys[] = {"matrix", "translate", "rotate", "turn", "quaternion",
                                       "scale",  "compose",   "center", NULL};
    const json *center = json_member(where, "center"), *value;
    fraction move[3];
    if (where->kind != JSON_OBJECT || where->count != (center ? 2 : 1))
        fail(x, where, "a transform is expected: an object of one kind");
    check_keys(where, keys, x->path);
    if ((value = json_member(where, "matrix")) != NULL)
        read_matrix(out, value, x);
    else if ((value = json_member(where, "rotate")) != NULL)
        read_rotate(out, value, x);
    else if ((value = json_member(where, "turn")) != NULL)
        read_turn(out, value, x);
    else if ((value = json_member(where, "translate")) != NULL) {
        for (int k = 0; k < 3; k++)
            fraction_init(&move[k]);
        read_entries(move, x->d, value, x);
        for (int k = 0; k < 3; k++) {
            if (k < x->d)
                fraction_set(&out->at[k][x->d], &move[k]);
            fraction_clear(&move[k]);
        }
    } else if ((value = json_member(where, "compose")) != NULL) {
        for (size_t k = 0; value->kind == JSON_ARRAY && k < value->count; k++) {
            affine step;
            affine_identity(&step, x->d);
            read_transform(&step, &value->item[k], x);
            affine_compose(out, &step, out);
            affine_clear(&step);
        }
        if (value->kind != JSON_ARRAY)
            fail(x, value, "compose takes an array");
    } else if ((value = json_member(where, "quaternion")) != NULL)
        read_quaternion(out, value, x);
    else if ((value = json_member(where, "scale")) != NULL)
        read_scale(out, value, x);
    if (center && !json_member(where, "quaternion") && !json_member(where, "scale"))
        fail(x, center, "center stands beside quaternion or scale");
    about(out, center, x);
}

void transform_read(affine *out, const json *where, int d, const mpq_t lo, const mpq_t hi,
                    const mpq_t from, const mpq_t to, const char *path) {
    stretch x = {.d = d, .path = path};
    mpq_t zero, one, width;
    mpq_inits(zero, one, width, x.from, x.to, NULL);
    mpq_set(x.from, from);
    mpq_set(x.to, to);
    fraction_init(&x.s);
    poly_zeros(&x.s.num, 2);
    mpq_sub(width, hi, lo);
    mpz_mul(x.s.num.c[0], mpq_numref(lo), mpq_denref(width));
    mpz_neg(x.s.num.c[0], x.s.num.c[0]);
    mpz_mul(x.s.num.c[1], mpq_denref(lo), mpq_denref(width));
    mpz_mul(x.s.den.c[0], mpq_denref(lo), mpq_numref(width));
    read_transform(out, where, &x);
    mpq_clears(zero, one, width, x.from, x.to, NULL);
    fraction_clear(&x.s);
}

void transform_turns(const json *where, size_t **n, size_t *count, const char *path) {
    const json *turn = json_member(where, "turn"), *compose = json_member(where, "compose");
    if (turn && json_member(turn, "quarters")) {
        long quarters = labs(read_whole(json_member(turn, "quarters"), path));
        *n = grow(*n, *count + 1, sizeof **n);
        (*n)[(*count)++] = (size_t)(quarters > 0 ? quarters : 1);
    }
    for (size_t k = 0; compose && compose->kind == JSON_ARRAY && k < compose->count; k++)
        transform_turns(&compose->item[k], n, count, path);
}
