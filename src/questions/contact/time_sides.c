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

void map_rows(fmpz *out, const point_map *map, const fmpq_t u, int order) {
    int d = map->dimension, entries = d * (d + 1);
    slong degree = fmpz_poly_degree(map->weight);
    for (int e = 0; e < entries; e++)
        degree = FLINT_MAX(degree, fmpz_poly_degree(&map->entry[e]));
    LOCAL_VEC(fmpz, power, degree + 2); /* those of the numerator times those of the denominator */
    LOCAL(fmpz_poly, p);
    for (slong n = 0; n <= degree; n++) {
        fmpz_pow_ui(power + n, fmpq_numref(u), (ulong)n);
        fmpz_pow_ui(power + degree + 1, fmpq_denref(u), (ulong)(degree - n));
        fmpz_mul(power + n, power + n, power + degree + 1);
    }
    _fmpz_vec_zero(out + entries, d);
    for (int e = 0; e <= entries; e++) {
        fmpz_poly_set(p, e < entries ? &map->entry[e] : map->weight);
        for (int k = 0; k < order; k++)
            fmpz_poly_derivative(p, p);
        _fmpz_vec_dot(out + (e < entries ? e : entries + d), p->coeffs, power, fmpz_poly_length(p));
    }
}

void rows_multiply(fmpz *out, const fmpz *a, const fmpz *b, int rows, int inner, int size) {
    for (int e = 0; e < rows * size; e++) {
        fmpz_zero(out + e);
        for (int k = 0; k < inner; k++)
            fmpz_addmul(out + e, a + e / size * size + k, b + k * size + e % size);
    }
}

/* Set a flow's map to numerators over a denominator, by u, times `width` of a piece to the power
 * -order. */
static void set_rows(fmpz *out, const fmpz *rows, const fmpz_t common, const fmpq_t width,
                     int order, int n) {
    LOCAL(fmpz, factor);
    fmpz_pow_ui(factor, fmpq_denref(width), (ulong)order);
    _fmpz_vec_scalar_mul_fmpz(out, rows, n, factor);
    fmpz_pow_ui(factor, fmpq_numref(width), (ulong)order);
    fmpz_mul(out + n, common, factor);
    _fmpz_vec_content(factor, out, n + 1);
    _fmpz_vec_scalar_divexact_fmpz(out, out, n + 1, factor);
}

/* With (N, W) the inverse map and (B, V) the map at u, c = N P / W and P = B y / V, so by u
 * c' = (N'B - W'V y) / (W V) and c'' = (W N''B - 2 W' (N'B - W'V y) - W W''V y) / (W^2 V); the
 * derivative of -c' at fixed y is c' with its linear part before it, minus c''. */
void flow_init(flow *out, const motion_piece *piece, const fmpq_t u) {
    int d = piece->forward.dimension, n = d * (d + 1), all = n + d + 1;
    LOCAL_VEC(fmpz, place, 7 * all + 3);
    fmpz *rows = place + all, *first = rows + 3 * all, *second = first + all,
         *turned = second + all;
    fmpz *factor = turned + all, *common = factor + 1;
    const fmpz *v = place + all - 1, *w = rows + all - 1, *w1 = w + all, *w2 = w1 + all;
    fmpz *map = _fmpz_vec_init(3 * (n + 1));
    *out = (flow){.dimension = d, .w = map, .bend = map + n + 1, .drift = map + 2 * (n + 1)};
    LOCAL(fmpq, width);
    fmpq_sub(width, piece->hi, piece->lo);
    map_rows(place, &piece->forward, u, 0);
    for (int k = 0; k < 3; k++)
        map_rows(rows + k * all, &piece->inverse, u, k);
    rows_multiply(first, rows + all, place, d, d + 1, d + 1);
    rows_multiply(second, rows + 2 * all, place, d, d + 1, d + 1);
    _fmpz_vec_scalar_mul_fmpz(second, second, n, w);
    for (int i = 0; i < d; i++) {
        fmpz_submul(first + i * (d + 2), w1, v);
        fmpz_mul(factor, w2, v);
        fmpz_submul(second + i * (d + 2), factor, w);
    }
    fmpz_mul_ui(factor, w1, 2);
    _fmpz_vec_scalar_submul_fmpz(second, first, n, factor);
    fmpz_mul(common, w, v);
    set_rows(out->w, first, common, width, 1, n);
    fmpz_mul(factor, common, w);
    set_rows(out->bend, second, factor, width, 2, n);
    rows_multiply(turned, first, first, d, d, d + 1);
    _fmpz_vec_scalar_submul_fmpz(turned, second, n, v);
    fmpz_mul(common, common, common);
    set_rows(out->drift, turned, common, width, 2, n);
    LOCAL(fmpz_mat, linear, d, d);
    for (int k = 0; k < d * d; k++)
        fmpz_set(fmpz_mat_entry(linear, k / d, k % d), place + k / d * (d + 1) + k % d);
    fmpz_mat_det(factor, linear);
    out->orientation = fmpz_sgn(factor);
}

void flow_clear(flow *f) {
    if (f->w)
        _fmpz_vec_clear(f->w, 3 * (f->dimension * (f->dimension + 1) + 1));
    f->w = NULL;
}

void flow_along(fmpq_t out, const fmpz *normal, const fmpz *map, const fmpq *y, int dimension) {
    LOCAL_VEC(fmpz, form, 2 * dimension + 3);
    fmpz *at = form + dimension + 1, *value = at + dimension + 1;
    for (int i = 0; i < dimension; i++)
        _fmpz_vec_scalar_addmul_fmpz(form, map + i * (dimension + 1), dimension + 1, normal + i);
    _fmpq_vec_get_fmpz_vec_fmpz(at, at + dimension, y, dimension);
    _fmpz_vec_dot(value, form, at, dimension + 1);
    fmpz_mul(at + dimension, at + dimension, map + dimension * (dimension + 1));
    fmpq_set_fmpz_frac(out, value, at + dimension);
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
