/* Velocity and acceleration of the trajectory c of a point P.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A c + b = P is constant: A'c + A c' + b' = 0 and A''c + 2 A'c' + A c'' + b'' = 0. The velocity w
 * is affine in y, so d + 1 values give it.
 */
#include "questions/contact/contact.h"

#include <flint/fmpq_vec.h>
#include <string.h>
#include "base/context/scope.h"
#include "base/number/vector.h"
#include "decide/trace/trace.h"
#include "input/motion/motion.h"
#include "questions/contact/nearby.h"

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

/* V = (M y)' and (M y)''. */
static void body_velocity(fmpq *first, fmpq *second, const motion_piece *piece, const fmpq_t u,
                          const fmpq *y) {
    int d = piece->forward.dimension;
    LOCAL_VEC(fmpq, x, 3);
    LOCAL_VEC(fmpq, w, 3);
    HELD(trajectory, path, d);
    trajectory_set(&path, &piece->forward, y);
    jet_of(w, &path.x[d], u);
    for (int i = 0; i < d; i++) {
        jet_of(x, &path.x[i], u);
        quotient_derivatives(first + i, second + i, x, w);
    }
}

/* out = A' v. */
static void turn_vector(fmpq *out, const motion_piece *piece, const fmpq_t u, const fmpq *v) {
    const point_map *map = &piece->forward;
    int d = map->dimension;
    LOCAL_VEC(fmpq, x, 3);
    LOCAL_VEC(fmpq, w, 3);
    LOCAL_VEC(fmpq, ignored, 2);
    jet_of(w, map->weight, u);
    for (int i = 0; i < d; i++) {
        fmpq_zero(out + i);
        for (int j = 0; j < d; j++) {
            jet_of(x, &map->entry[i * (d + 1) + j], u);
            quotient_derivatives(ignored, ignored + 1, x, w);
            fmpq_addmul(out + i, ignored, v + j);
        }
    }
}

/* out = L v, L the linear part of a map of d * (d + 1) entries. */
static void apply_linear(fmpq *out, const fmpq *map, const fmpq *v, int d) {
    for (int i = 0; i < d; i++) {
        fmpq_zero(out + i);
        for (int j = 0; j < d; j++)
            fmpq_addmul(out + i, map + i * (d + 1) + j, v + j);
    }
}

static void negate_vector(fmpq *a, int d) {
    for (int i = 0; i < d; i++)
        fmpq_neg(a + i, a + i);
}

/* Turn derivatives by u into derivatives by t: divide by dt/du once for each order. */
static void scale_to_time(flow *f, const motion_piece *piece) {
    LOCAL(fmpq, width);
    fmpq_sub(width, piece->hi, piece->lo);
    for (int i = 0; i < f->dimension; i++) {
        fmpq_div(f->w + i, f->w + i, width);
        for (int k = 0; k < 2; k++) {
            fmpq_div(f->bend + i, f->bend + i, width);
            fmpq_div(f->drift + i, f->drift + i, width);
        }
    }
}

void flow_init(flow *out, const motion_piece *piece, const fmpq_t u, const fmpq *y) {
    int d = piece->forward.dimension;
    LOCAL_VEC(fmpq, inverse, d * (d + 1));
    LOCAL_VEC(fmpq, velocity, d);
    LOCAL_VEC(fmpq, second, d);
    LOCAL_VEC(fmpq, turned, d);
    *out = (flow){.dimension = d,
                  .w = _fmpq_vec_init(d),
                  .bend = _fmpq_vec_init(d),
                  .drift = _fmpq_vec_init(d)};
    point_map_at(inverse, &piece->inverse, u);
    body_velocity(velocity, second, piece, u, y);
    apply_linear(out->w, inverse, velocity, d);
    negate_vector(out->w, d);
    /* drift = A^-1 (A'' y + b'' + A'w), bend = -A^-1 (A'' y + b'' + 2 A'w) */
    turn_vector(turned, piece, u, out->w);
    vector_add(second, second, turned, d);
    apply_linear(out->drift, inverse, second, d);
    vector_add(second, second, turned, d);
    apply_linear(out->bend, inverse, second, d);
    negate_vector(out->bend, d);
    out->orientation = affine_orientation(inverse, d);
    scale_to_time(out, piece);
}

void flow_clear(flow *f) {
    if (!f->w)
        return;
    _fmpq_vec_clear(f->w, f->dimension);
    _fmpq_vec_clear(f->bend, f->dimension);
    _fmpq_vec_clear(f->drift, f->dimension);
    *f = (flow){.w = NULL};
}

void flow_along(fmpq_t out, const fmpz *normal, const fmpq *vector, int dimension) {
    LOCAL(fmpq, term);
    fmpq_zero(out);
    for (int i = 0; i < dimension; i++) {
        fmpq_mul_fmpz(term, vector + i, normal + i);
        fmpq_add(out, out, term);
    }
}

static void field_make(velocity_field *out, const motion_piece *piece, const fmpq_t u) {
    int d = piece->forward.dimension;
    LOCAL_VEC(fmpq, y, d);
    *out = (velocity_field){d, _fmpq_vec_init(d), _fmpq_vec_init(d * d)};
    HELD(flow, at_zero, piece, u, y);
    for (int i = 0; i < d; i++)
        fmpq_set(out->at_zero + i, at_zero.w + i);
    for (int j = 0; j < d; j++) {
        fmpq_one(y + j);
        HELD(flow, f, piece, u, y);
        for (int i = 0; i < d; i++)
            fmpq_sub(out->slope + i * d + j, f.w + i, out->at_zero + i);
        fmpq_zero(y + j);
    }
}

void speed_init(speed *out, const graze_motion *motion, const site_side side[2]) {
    memset(out, 0, sizeof *out);
    out->dimension = motion->dimension;
    for (int k = 0; k < 2; k++) {
        out->present[k] = side[k].present;
        if (side[k].present)
            field_make(&out->field[k], &motion->piece[side[k].piece], side[k].u);
    }
}

void speed_clear(speed *s) {
    int d = s->dimension;
    for (int k = 0; k < 2; k++) {
        if (!s->field[k].at_zero)
            continue;
        _fmpq_vec_clear(s->field[k].at_zero, d);
        _fmpq_vec_clear(s->field[k].slope, d * d);
    }
}

void speed_along(fmpq_t out, const speed *s, int side, const fmpq *normal, const fmpq *y) {
    const velocity_field *f = &s->field[side];
    int d = s->dimension;
    LOCAL(fmpq, w);
    fmpq_zero(out);
    for (int i = 0; i < d; i++) {
        _fmpq_vec_dot(w, f->slope + i * d, y, d);
        fmpq_add(w, w, f->at_zero + i);
        fmpq_submul(out, w, normal + i);
    }
}
