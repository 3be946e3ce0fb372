/* Pieces beside a time, and velocity and acceleration of the trajectory c of a point P there.
 *
 * A c + b = P is constant: A'c + A c' + b' = 0 and A''c + 2 A'c' + A c'' + b'' = 0. Two pieces of
 * one rational function, as where a motion was cut, make no break.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/nearby.h"

#include "base/context/scope.h"
#include "base/number/rational.h"
#include "base/number/vector.h"

static void set_side(site_side *side, const graze_motion *motion, size_t piece, const fmpq_t t) {
    side->present = 1;
    side->piece = piece;
    motion_parameter_at(side->u, &motion->piece[piece], t);
}

/* first(u) second_weight(shift(u)) = second(shift(u)) first_weight(u) */
static int is_same_quotient(const fmpz_poly_struct *first, const fmpz_poly_struct *first_weight,
                            const fmpz_poly_struct *second, const fmpz_poly_struct *second_weight,
                            const fmpq_poly_t shift) {
    LOCAL(fmpq_poly, a);
    LOCAL(fmpq_poly, b);
    LOCAL(fmpq_poly, c);
    fmpq_poly_set_fmpz_poly(a, second_weight);
    fmpq_poly_compose(a, a, shift);
    fmpq_poly_set_fmpz_poly(c, first);
    fmpq_poly_mul(a, a, c);
    fmpq_poly_set_fmpz_poly(b, second);
    fmpq_poly_compose(b, b, shift);
    fmpq_poly_set_fmpz_poly(c, first_weight);
    fmpq_poly_mul(b, b, c);
    return fmpq_poly_equal(a, b);
}

/* Do a piece and the next one continue each other as one rational function? */
static int is_one_function(const motion_piece *first, const motion_piece *second) {
    int d = first->forward.dimension, same = 1;
    LOCAL_VEC(fmpq, at_zero, 2);
    fmpq *at_one = at_zero + 1;
    LOCAL(fmpq_poly, shift);
    motion_parameter_at(at_zero, second, first->lo);
    motion_parameter_at(at_one, second, first->hi);
    fmpq_poly_set_coeff_fmpq(shift, 0, at_zero);
    fmpq_sub(at_one, at_one, at_zero);
    fmpq_poly_set_coeff_fmpq(shift, 1, at_one);
    for (int k = 0; k < d * (d + 1) && same; k++)
        same = is_same_quotient(&first->forward.entry[k], first->forward.weight,
                                &second->forward.entry[k], second->forward.weight, shift);
    return same;
}

static graze_status refuse_time(graze_context *context, const graze_motion *motion) {
    char *low = rational_text(motion->piece[0].lo);
    char *high = rational_text(motion->piece[motion->piece_count - 1].hi);
    graze_status status =
        low && high
            ? context_fail(context, GRAZE_EINPUT,
                           "the motion has no such time; expected one from %s to %s", low, high)
            : context_fail(context, GRAZE_ESYSTEM, "out of memory for a message");
    free(low);
    free(high);
    return status;
}

graze_status sides_find(site_side side[2], graze_context *context, const graze_motion *motion,
                        const fmpq_t t) {
    side[0].present = side[1].present = 0;
    for (size_t k = 0; k < motion->piece_count; k++) {
        const motion_piece *piece = &motion->piece[k];
        int from = fmpq_cmp(t, piece->lo), to = fmpq_cmp(t, piece->hi);
        if (from > 0 && to <= 0)
            set_side(&side[0], motion, k, t);
        if (from >= 0 && to < 0)
            set_side(&side[1], motion, k, t);
    }
    return side[0].present || side[1].present ? GRAZE_OK : refuse_time(context, motion);
}

int sides_break(const site_side side[2], const graze_motion *motion) {
    return side[0].present && side[1].present && side[0].piece != side[1].piece &&
           !is_one_function(&motion->piece[side[0].piece], &motion->piece[side[1].piece]);
}

/* Value and first two derivatives of a polynomial at u. */
static void jet_of(fmpq *out, const fmpz_poly_struct *p, const fmpq_t u) {
    LOCAL(fmpz_poly, q);
    fmpz_poly_set(q, p);
    for (int k = 0; k < 3; k++) {
        fmpz_poly_evaluate_fmpq(out + k, q, u);
        fmpz_poly_derivative(q, q);
    }
}

/* First and second derivative of x / w from the values and derivatives of both. */
static void quotient_derivatives(fmpq_t first, fmpq_t second, const fmpq *x, const fmpq *w) {
    LOCAL(fmpq, value);
    fmpq_div(value, x, w);
    fmpq_set(first, x + 1);
    fmpq_submul(first, value, w + 1);
    fmpq_div(first, first, w);
    fmpq_set(second, x + 2);
    fmpq_submul(second, first, w + 1);
    fmpq_submul(second, first, w + 1);
    fmpq_submul(second, value, w + 2);
    fmpq_div(second, second, w);
}

/* Derivatives of a map's entries by t at the parameter u of a piece. */
static void entry_derivatives(fmpq *first, fmpq *second, const motion_piece *piece,
                              const fmpq_t u) {
    const point_map *map = &piece->forward;
    LOCAL_VEC(fmpq, x, 7);
    fmpq *w = x + 3, *width = x + 6;
    fmpq_sub(width, piece->hi, piece->lo);
    jet_of(w, map->weight, u);
    for (int k = 0; k < map->dimension * (map->dimension + 1); k++) {
        jet_of(x, &map->entry[k], u);
        quotient_derivatives(first + k, second + k, x, w);
        fmpq_div(first + k, first + k, width);
        fmpq_div(second + k, second + k, width);
        fmpq_div(second + k, second + k, width);
    }
}

/* out = `sign` times L b, L the linear part of a; all are matrices of d rows and d + 1 columns. */
static void multiply_linear(fmpq *out, int sign, const fmpq *a, const fmpq *b, int d) {
    for (int i = 0; i < d; i++)
        for (int c = 0; c <= d; c++) {
            fmpq *entry = out + i * (d + 1) + c;
            fmpq_zero(entry);
            for (int j = 0; j < d; j++)
                (sign < 0 ? fmpq_submul : fmpq_addmul)(entry, a + i * (d + 1) + j,
                                                       b + j * (d + 1) + c);
        }
}

void flow_init(flow *out, const motion_piece *piece, const fmpq_t u) {
    int d = piece->forward.dimension, n = d * (d + 1);
    LOCAL_VEC(fmpq, inverse, 7 * n);
    fmpq *first = inverse + n, *second = first + n, *turned = second + n;
    fmpq *w = turned + n, *bend = w + n, *drift = bend + n;
    fmpz *map = _fmpz_vec_init(3 * (n + 1));
    *out = (flow){.dimension = d, .w = map, .bend = map + n + 1, .drift = map + 2 * (n + 1)};
    point_map_at(inverse, &piece->inverse, u);
    entry_derivatives(first, second, piece, u);
    multiply_linear(w, -1, inverse, first, d);
    /* drift = A^-1 (A'' y + b'' + A'w), bend = -A^-1 (A'' y + b'' + 2 A'w) */
    multiply_linear(turned, 1, first, w, d);
    vector_add(second, second, turned, n);
    multiply_linear(drift, 1, inverse, second, d);
    vector_add(second, second, turned, n);
    multiply_linear(bend, -1, inverse, second, d);
    for (int k = 0; k < 3; k++)
        _fmpq_vec_get_fmpz_vec_fmpz(map + k * (n + 1), map + k * (n + 1) + n, w + k * n, n);
    out->orientation = affine_orientation(inverse, d);
}

void flow_clear(flow *f) {
    if (f->w)
        _fmpz_vec_clear(f->w, 3 * (f->dimension * (f->dimension + 1) + 1));
    f->w = NULL;
}

void flow_along(fmpq_t out, const fmpz *normal, const fmpz *map, const fmpq *y, int dimension) {
    LOCAL_VEC(fmpz, form, dimension + 1);
    for (int i = 0; i < dimension; i++)
        _fmpz_vec_scalar_addmul_fmpz(form, map + i * (dimension + 1), dimension + 1, normal + i);
    vector_dot_integers(out, form, y, dimension);
    fmpq_add_fmpz(out, out, form + dimension);
    fmpq_div_fmpz(out, out, map + dimension * (dimension + 1));
}

int sides_within_piece(const site_side side[2]) {
    return side[0].present && side[1].present && side[0].piece == side[1].piece;
}

void sides_add_flows(site_side side[2], const graze_motion *motion) {
    for (int k = sides_within_piece(side); k < 2; k++)
        if (side[k].present)
            flow_init(&side[k].flow, &motion->piece[side[k].piece], side[k].u);
}

const flow *sides_flow(const site_side side[2], int k) {
    return &side[k || sides_within_piece(side)].flow;
}

void sides_speed(fmpq_t out, const site_side side[2], int k, const fmpz *normal, const fmpq *y) {
    const flow *f = sides_flow(side, k);
    flow_along(out, normal, f->w, y, f->dimension);
    fmpq_neg(out, out);
}
