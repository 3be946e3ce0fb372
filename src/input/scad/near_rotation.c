/* Takes a rotation, times a scale, instead of a matrix of few digits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "input/convert/convert.h"
#include "input/csg/csg.h"
#include "input/scad/writer.h"

/* Binary places of a quaternion, at most. */
enum { QUATERNION_BITS = 52 };

void scad_norm(fmpq_t out, const fmpq *matrix) {
    LOCAL_VEC(fmpq, square, 2);
    fmpq *three = square + 1;
    fmpq_set_si(three, 3, 1);
    if (!csg_similar(square, matrix, 3, 3))
        fmpq_mul(square, square, three);
    csg_upper_root(out, square);
}

/* Set `out` to the simplest rational number that differs from the root of `square` by at most the
 * tolerance times the root. */
static void set_scale(fmpq_t out, const fmpq_t square, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, v, 3);
    fmpq *low = v + 1, *high = v + 2;
    csg_upper_root(v, square);
    fmpq_mul(high, v, tolerance);
    fmpq_sub(low, v, high);
    fmpq_add(high, v, high);
    fmpq_simplest_between(out, low, high);
}

/* The rotation of a quaternion rounded to some binary places, its negative if `other`. */
static void set_rotation(fmpq *out, const double *quaternion, int places, int other) {
    LOCAL_VEC(fmpq, v, 4);
    for (int k = 0; k < 4; k++) {
        fmpz_set_d(fmpq_numref(v + k), nearbyint(ldexp(quaternion[k], places)));
        fmpq_div_2exp(v + k, v + k, (ulong)places);
    }
    pose_rotation(out, v);
    for (int k = 0; k < 9 && other; k++)
        fmpq_neg(out + k, out + k);
}

/* The rotation, or reflection, of fewest binary places within the tolerance of a matrix. */
static int find_rotation(fmpq *out, graze_context *context, const fmpq *matrix,
                         const fmpq_t tolerance) {
    static const double before[4] = {1, 0, 0, 0};
    double m[9], quaternion[4];
    for (int k = 0; k < 9; k++)
        if (rational_nearest(&m[k], context, matrix + k))
            return 0;
    double volume = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                    m[2] * (m[3] * m[7] - m[4] * m[6]);
    int other = volume < 0, found = 0;
    for (int k = 0; k < 9 && other; k++)
        m[k] = -m[k];
    pose_nearest(quaternion, m, before);
    LOCAL(fmpq, distance);
    for (int places = 2; places <= QUATERNION_BITS && !found; places++) {
        set_rotation(out, quaternion, places, other);
        rotation_distance(distance, out, matrix, 3);
        found = fmpq_cmp(distance, tolerance) <= 0;
    }
    return found;
}

int scad_turn(fmpq *matrix, fmpq_t error, graze_context *context, const fmpq_t tolerance) {
    LOCAL_VEC(fmpq, v, 20);
    fmpq *scaled = v, *turn = v + 9, *scale = v + 18, *square = v + 19;
    fmpq_zero(error);
    int found = !csg_similar(square, matrix, 3, 3) && !fmpq_is_zero(square);
    if (found) {
        set_scale(scale, square, tolerance);
        for (int k = 0; k < 9; k++)
            fmpq_div(scaled + k, matrix + k, scale);
        found = find_rotation(turn, context, scaled, tolerance);
    }
    fmpq_zero(square);
    for (int k = 0; k < 9 && found; k++) {
        fmpq_mul(turn + k, turn + k, scale);
        fmpq_sub(scaled + k, turn + k, matrix + k);
        fmpq_addmul(square, scaled + k, scaled + k);
        fmpq_set(matrix + k, turn + k);
    }
    csg_upper_root(error, square);
    return found;
}
