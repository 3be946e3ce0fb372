/* Affine maps with entries in Q(t).
 * SPDX-License-Identifier: MIT
 */
#include "motion.h"

static void set_integer(fraction *f, long value) {
    mpq_t q;
    mpq_init(q);
    mpq_set_si(q, value, 1);
    fraction_set_q(f, q);
    mpq_clear(q);
}

void affine_identity(affine *a, int d) {
    a->d = d;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++) {
            fraction_init(&a->at[i][k]);
            set_integer(&a->at[i][k], i == k);
        }
    for (int i = 0; d < 3 && i < 2; i++)
        set_integer(&a->at[i][2], 0); /* in E^2 column 2 is the translation */
}

void affine_clear(affine *a) {
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            fraction_clear(&a->at[i][k]);
}

void affine_set(affine *out, const affine *a) {
    out->d = a->d;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            fraction_set(&out->at[i][k], &a->at[i][k]);
}

void affine_compose(affine *out, const affine *a, const affine *b) {
    affine r;
    fraction term;
    affine_identity(&r, a->d);
    fraction_init(&term);
    for (int i = 0; i < a->d; i++)
        for (int k = 0; k <= a->d; k++) {
            set_integer(&r.at[i][k], 0);
            if (k == a->d)
                fraction_set(&r.at[i][k], &a->at[i][k]);
            for (int j = 0; j < a->d; j++) {
                fraction_apply(&term, '*', &a->at[i][j], &b->at[j][k]);
                fraction_apply(&r.at[i][k], '+', &r.at[i][k], &term);
            }
        }
    affine_set(out, &r);
    affine_clear(&r);
    fraction_clear(&term);
}

int affine_value(affine *out, const affine *a, const mpq_t x) {
    mpq_t value;
    int defined = 1;
    mpq_init(value);
    for (int i = 0; i < a->d && defined; i++)
        for (int k = 0; k <= a->d && defined; k++) {
            defined = fraction_value(value, &a->at[i][k], x);
            fraction_set_q(&out->at[i][k], value);
        }
    mpq_clear(value);
    return defined;
}

/* out = at(r0, c0) at(r1, c1) - at(r0, c1) at(r1, c0) */
static void minor(fraction *out, const affine *a, int r0, int r1, int c0, int c1) {
    fraction other;
    fraction_init(&other);
    fraction_apply(out, '*', &a->at[r0][c0], &a->at[r1][c1]);
    fraction_apply(&other, '*', &a->at[r0][c1], &a->at[r1][c0]);
    fraction_apply(out, '-', out, &other);
    fraction_clear(&other);
}

/* Entry (i, k) of the adjugate: the cofactor (k, i), cyclic indices bring the sign. */
static void adjugate(fraction *out, const affine *a, int i, int k) {
    if (a->d == 3) {
        minor(out, a, (k + 1) % 3, (k + 2) % 3, (i + 1) % 3, (i + 2) % 3);
        return;
    }
    fraction zero;
    fraction_init(&zero);
    fraction_apply(out, i == k ? '+' : '-', &zero, &a->at[1 - k][1 - i]);
    fraction_clear(&zero);
}

void affine_inverse(affine *out, const affine *a) {
    affine r;
    fraction det, term;
    affine_identity(&r, a->d);
    fraction_init(&det);
    fraction_init(&term);
    for (int i = 0; i < a->d; i++)
        for (int k = 0; k < a->d; k++)
            adjugate(&r.at[i][k], a, i, k);
    for (int k = 0; k < a->d; k++) {
        fraction_apply(&term, '*', &r.at[0][k], &a->at[k][0]);
        fraction_apply(&det, '+', &det, &term);
    }
    if (det.num.n == 0)
        give_up("the determinant of the motion is zero");
    for (int i = 0; i < a->d; i++) {
        set_integer(&r.at[i][a->d], 0);
        for (int k = 0; k < a->d; k++) {
            fraction_apply(&r.at[i][k], '/', &r.at[i][k], &det);
            fraction_apply(&term, '*', &r.at[i][k], &a->at[k][a->d]);
            fraction_apply(&r.at[i][a->d], '-', &r.at[i][a->d], &term);
        }
    }
    affine_set(out, &r);
    affine_clear(&r);
    fraction_clear(&det);
    fraction_clear(&term);
}
