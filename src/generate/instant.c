/* Point maps and their derivatives at one rational time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "generate/instant.h"

#include <flint/fmpq_vec.h>

static void evaluate(fmpq_t out, const fmpz_poly_t p, const fmpq_t u, int derivative) {
    fmpz_poly_t q;
    fmpz_poly_init(q);
    fmpz_poly_set(q, p);
    for (int k = 0; k < derivative; k++)
        fmpz_poly_derivative(q, q);
    fmpz_poly_evaluate_fmpq(out, q, u);
    fmpz_poly_clear(q);
}

void instant_init(instant *i, const graze_scene *scene, size_t piece, const fmpq_t u) {
    const graze_motion *motion = scene->motion;
    int d = motion->dimension;
    const motion_piece *p = &motion->piece[piece];
    const point_map *tracing = motion_tracing(p, scene->options.operation);
    i->dimension = d;
    i->piece = piece;
    fmpq_init(i->u);
    fmpq_init(i->t);
    fmpq_set(i->u, u);
    fmpq_sub(i->t, p->hi, p->lo);
    fmpq_mul(i->t, i->t, u);
    fmpq_add(i->t, i->t, p->lo);
    i->map = _fmpq_vec_init(d * (d + 1));
    point_map_at(i->map, motion_placing(p, scene->options.operation), u);
    for (int k = 0; k < INSTANT_DERIVATIVES; k++) {
        i->inverse[k] = _fmpq_vec_init((d + 1) * (d + 1));
        for (int e = 0; e < d * (d + 1); e++)
            evaluate(i->inverse[k] + e, &tracing->entry[e], u, k);
        evaluate(i->inverse[k] + (d + 1) * (d + 1) - 1, tracing->weight, u, k);
    }
}

void instant_clear(instant *i) {
    int d = i->dimension;
    fmpq_clear(i->u);
    fmpq_clear(i->t);
    _fmpq_vec_clear(i->map, d * (d + 1));
    for (int k = 0; k < INSTANT_DERIVATIVES; k++)
        _fmpq_vec_clear(i->inverse[k], (d + 1) * (d + 1));
}

void instant_move(fmpq *out, const instant *i, const fmpq *y) {
    int d = i->dimension;
    for (int row = 0; row < d; row++) {
        fmpq_set(out + row, i->map + row * (d + 1) + d);
        for (int j = 0; j < d; j++)
            fmpq_addmul(out + row, i->map + row * (d + 1) + j, y + j);
    }
}

/* Coefficient j of the pullback as a form in P. */
static void pulled_coefficient(fmpq_t out, const instant *i, const fmpz *form, int j, int k) {
    int d = i->dimension;
    fmpq_t term;
    fmpq_init(term);
    fmpq_zero(out);
    for (int row = 0; row <= d; row++) {
        fmpq_mul_fmpz(term, i->inverse[k] + row * (d + 1) + j, form + row);
        fmpq_add(out, out, term);
    }
    fmpq_clear(term);
}

void instant_pullback(fmpq_t out, const instant *i, const fmpz *form, const fmpq *point, int k) {
    int d = i->dimension;
    fmpq_t c;
    fmpq_init(c);
    pulled_coefficient(out, i, form, d, k);
    for (int j = 0; j < d; j++) {
        pulled_coefficient(c, i, form, j, k);
        fmpq_addmul(out, c, point + j);
    }
    fmpq_clear(c);
}

void instant_normal(fmpq *out, const instant *i, const fmpz *form) {
    for (int j = 0; j < i->dimension; j++)
        pulled_coefficient(out + j, i, form, j, 0);
}
