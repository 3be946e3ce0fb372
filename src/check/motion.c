/* The maps of a motion, their inverses, continuity, signs.
 * SPDX-License-Identifier: MIT
 */
#include "motion.h"

void motion_check_size(const poly *p) {
    if (p->n > MOST_DEGREE + 1)
        give_up("the motion has a polynomial of degree above %d", MOST_DEGREE);
    for (size_t k = 0; k < p->n; k++)
        if (mpz_sizeinbase(p->c[k], 2) > MOST_BITS)
            give_up("the motion has a coefficient of more than %d bits", MOST_BITS);
}

/* Divide a map's entries and weight by their common factor, and multiply them by -1 if the weight
 * is then negative at x. */
static void shorten(poly *map, const mpq_t x) {
    poly g = {0};
    mpz_t sign;
    for (int k = 0; k < MAP; k++) {
        motion_check_size(&map[k]);
        poly_common(&g, &g, &map[k]);
    }
    for (int k = 0; k < MAP; k++)
        must(poly_divide(&map[k], &g), "motion: a divisor does not divide");
    mpz_init_set_si(sign, poly_signs(&map[WEIGHT], x, x).first < 0 ? -1 : 1);
    for (int k = 0; k < MAP; k++)
        poly_scale(&map[k], sign);
    poly_clear(&g);
    mpz_clear(sign);
}

/* M = (A | b) / h has the inverse (adj(A) h | - adj(A) b) / det A. With cyclic indices the
 * cofactors have the right signs. In the plane the map keeps z. */
static void make_inverse(piece *p) {
    const poly *m = p->forward;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            int i = 4 * ((r + 1) % 3), k = 4 * ((r + 2) % 3), a = (c + 1) % 3, b = (c + 2) % 3;
            poly cofactor = {0};
            poly_add_product(&cofactor, &m[i + a], &m[k + b], 1);
            poly_add_product(&cofactor, &m[i + b], &m[k + a], -1);
            poly_add_product(&p->inverse[4 * c + r], &cofactor, &m[WEIGHT], 1);
            poly_add_product(&p->inverse[4 * c + 3], &cofactor, &m[4 * r + 3], -1);
            if (c == 0)
                poly_add_product(&p->det, &cofactor, &m[4 * r], 1);
            poly_clear(&cofactor);
        }
    if (p->det.n == 0)
        refute("motion: the determinant is zero");
    poly_set(&p->inverse[WEIGHT], &p->det);
    shorten(p->inverse, p->lo);
}

/* Are both maps the same at x? They are if each entry of one times the other's weight agrees. */
static int agree(const piece *p, const piece *q, const mpq_t x) {
    int same = 1;
    for (int k = 0; k < WEIGHT; k++) {
        poly difference = {0};
        poly_add_product(&difference, &p->forward[k], &q->forward[WEIGHT], 1);
        poly_add_product(&difference, &q->forward[k], &p->forward[WEIGHT], -1);
        same = same && (difference.n == 0 || poly_signs(&difference, x, x).first == 0);
        poly_clear(&difference);
    }
    return same;
}

void motion_add(motion *m, const piece *next) {
    size_t k = m->count++;
    m->piece = room_for(m->piece, k, &m->room, sizeof *m->piece);
    piece *p = &m->piece[k];
    *p = *next;
    if (mpq_cmp(p->lo, p->hi) >= 0)
        refute("motion: piece %zu does not have lo < hi", k);
    if (k > 0 && !mpq_equal(p[-1].hi, p->lo))
        refute("motion: piece %zu does not begin where the one before it ends", k);
    shorten(p->forward, p->lo);
    make_inverse(p);
    if (k > 0 && !agree(p - 1, p, p->lo))
        refute("motion: it jumps at the beginning of piece %zu", k);
}

void motion_check_signs(const motion *m, mpq_t *times, size_t count) {
    size_t piece = 0;
    if (count < 2 || !mpq_equal(times[0], m->piece[0].lo) ||
        !mpq_equal(times[count - 1], m->piece[m->count - 1].hi))
        refute("motion: the times of signs do not go from t0 to t1");
    for (size_t k = 1; k < count; k++)
        if (mpq_cmp(times[k - 1], times[k]) >= 0)
            refute("motion: the times of signs do not increase");
    /* The times increase, so each lo is before t1, and `piece` does not pass the last one. */
    for (size_t k = 0; k + 1 < count; k++) {
        mpq_srcptr lo = times[k], hi = times[k + 1];
        work_allow(STEP_WORK);
        piece += mpq_cmp(lo, m->piece[piece].hi) >= 0;
        if (mpq_cmp(hi, m->piece[piece].hi) > 0)
            refute("motion: the times of signs do not follow the pieces");
        if (!strict_sign(poly_signs(&m->piece[piece].forward[WEIGHT], lo, hi)))
            refute("motion: signs, interval %zu: the denominator has no strict sign", k);
        if (!strict_sign(poly_signs(&m->piece[piece].det, lo, hi)))
            refute("motion: signs, interval %zu: the determinant has no strict sign", k);
    }
}
