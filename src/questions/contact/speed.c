/* Velocities of trajectories: w is affine in y, so d + 1 values give it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "questions/contact/contact.h"

#include <flint/fmpq_vec.h>
#include <string.h>
#include "base/context/scope.h"
#include "input/motion/motion.h"
#include "questions/contact/nearby.h"

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
