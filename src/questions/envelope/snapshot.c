/* Evaluates velocity fields at a rational time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <flint/fmpq_vec.h>
#include "base/context/scope.h"
#include "questions/envelope/patch_ends.h"

static void evaluate_entries(fmpq *out, const fmpz_poly_struct *entry, int count, const fmpq_t u) {
    for (int k = 0; k < count; k++)
        fmpz_poly_evaluate_fmpq(out + k, entry + k, u);
}

/* Set the parameter u of a piece at time t. Returns 0 if t is not in the piece, or if it is an end
 * or a break of the motion. */
static int parameter_within(fmpq_t u, const graze_envelope *e, size_t piece, const fmpq_t t) {
    const motion_piece *p = &e->scene->motion->piece[piece];
    if (fmpq_cmp(t, p->lo) < 0 || fmpq_cmp(t, p->hi) >= 0 ||
        (fmpq_equal(t, p->lo) && (piece == 0 || e->is_break[piece])))
        return 0;
    motion_parameter_at(u, p, t);
    return 1;
}

graze_status snapshot_make(snapshot *out, graze_context *context, const graze_envelope *e,
                           const fmpq_t t) {
    int d = e->cells.dimension, found = 0;
    *out = (snapshot){.e = e, .dimension = d};
    fmpq_init(out->t);
    fmpq_set(out->t, t);
    out->velocity = _fmpq_vec_init(d * (d + 1));
    out->bend = _fmpq_vec_init(d * (d + 1));
    LOCAL(fmpq, u);
    for (size_t piece = 0; piece < e->piece_count && !found; piece++) {
        found = parameter_within(u, e, piece, t);
        if (found) {
            evaluate_entries(out->velocity, e->field[piece].entry[0], d * (d + 1), u);
            evaluate_entries(out->bend, e->field[piece].entry[1], d * (d + 1), u);
        }
    }
    return found ? GRAZE_OK
                 : context_fail(context, GRAZE_EINPUT,
                                "the time of a curve is an end or a break of the motion, or not in "
                                "it; expected one at which the motion is smooth");
}

void snapshot_clear(snapshot *s) {
    fmpq_clear(s->t);
    _fmpq_vec_clear(s->velocity, s->dimension * (s->dimension + 1));
    _fmpq_vec_clear(s->bend, s->dimension * (s->dimension + 1));
}

/* n . (matrix (y, 1)) for the outward normal n of a facet. */
static void speed_along_normal(fmpq_t out, const snapshot *s, const fmpq *matrix, size_t facet,
                               const fmpq *y) {
    int d = s->dimension;
    LOCAL_VEC(fmpq, image, d);
    for (int i = 0; i < d; i++) {
        fmpq_set(image + i, matrix + i * (d + 1) + d);
        for (int j = 0; j < d; j++)
            fmpq_addmul(image + i, matrix + i * (d + 1) + j, y + j);
    }
    flow_along(out, s->e->cells.facet[facet].normal, image, d);
}

void snapshot_g(fmpq_t out, const snapshot *s, size_t facet, const fmpq *y) {
    speed_along_normal(out, s, s->velocity, facet, y);
    fmpq_neg(out, out);
}

static int speed_sign(const snapshot *s, const fmpq *matrix, size_t facet, const fmpq *y) {
    LOCAL(fmpq, value);
    speed_along_normal(value, s, matrix, facet, y);
    return fmpq_sgn(value);
}

int snapshot_g_sign(const snapshot *s, size_t facet, const fmpq *y) {
    return -speed_sign(s, s->velocity, facet, y);
}

int snapshot_theta_sign(const snapshot *s, size_t facet, const fmpq *y) {
    return speed_sign(s, s->bend, facet, y);
}

void snapshot_zero(fmpq *out, const fmpq_t a, const fmpq_t b, const fmpq *p, const fmpq *q, int d) {
    LOCAL_VEC(fmpq, lambda, 2);
    fmpq *step = lambda + 1;
    fmpq_sub(lambda, a, b);
    fmpq_div(lambda, a, lambda);
    for (int i = 0; i < d; i++) {
        fmpq_sub(step, q + i, p + i);
        fmpq_mul(step, step, lambda);
        fmpq_add(out + i, p + i, step);
    }
}
