/* Rotations: by the tangent of the half angle, by quarter turns, by a quaternion.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each becomes a quaternion, whose length may be any. The angle n 2 atan(p/q) about the axis v has
 * the half angle of the complex number (q + ip)^n = a + ib, so its quaternion is (a |v|, b v).
 */
#include "input/motion/motion.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include "base/context/scope.h"
#include "input/motion/affine.h"

static void init4(fmpz_poly_q_t q[4]) {
    for (int k = 0; k < 4; k++)
        fmpz_poly_q_init(q[k]);
}

static void clear4(fmpz_poly_q_t q[4]) {
    for (int k = 0; k < 4; k++)
        fmpz_poly_q_clear(q[k]);
}

static void norm_of(calculation *c, fmpz_poly_q_t out, fmpz_poly_q_t *v, int count) {
    LOCAL(fmpz_poly_q, square);
    fmpz_poly_q_zero(out);
    for (int k = 0; k < count; k++) {
        quotient_mul(c, square, v[k], v[k]);
        quotient_add(c, out, out, square);
    }
}

/* The four times the least common multiple of their denominators. */
static void clear_denominators(calculation *c, fmpz_poly_struct out[4], fmpz_poly_q_t q[4]) {
    LOCAL(fmpz_poly, common);
    fmpz_poly_one(common);
    for (int k = 0; k < 4 && c->status == GRAZE_OK; k++) {
        polynomial_widen(common, fmpz_poly_q_denref(q[k]));
        polynomial_check(c, common);
    }
    for (int k = 0; k < 4 && c->status == GRAZE_OK; k++) {
        quotient_over(&out[k], q[k], common);
        polynomial_check(c, &out[k]);
    }
}

graze_status rotation_of(affine *out, graze_context *context, const json *where, fmpz_poly_q_t q[4],
                         const fmpq_t lo, const fmpq_t hi) {
    calculation c = {context, GRAZE_OK};
    fmpz_poly_struct cleared[4];
    HELD(common_map, turned);
    turned.dimension = out->dimension;
    fmpz_poly_one(turned.v);
    for (int k = 0; k < 4; k++)
        fmpz_poly_init(&cleared[k]);
    clear_denominators(&c, cleared, q);
    if (c.status == GRAZE_OK)
        c.status = quaternion_rotation(&turned, context, where, cleared, lo, hi);
    common_map_to_affine(&c, out, &turned);
    for (int k = 0; k < 4; k++)
        fmpz_poly_clear(&cleared[k]);
    return c.status;
}

/* (a + ib)^n in place; n < 0 takes the conjugate, which differs by a positive factor alone. From
 * the highest bit down, as in quotient_power. */
static void complex_power(calculation *c, fmpz_poly_q_t a, fmpz_poly_q_t b, const fmpz_t n) {
    fmpz_poly_q_t base[2];
    fmpz_poly_q_init(base[0]);
    fmpz_poly_q_init(base[1]);
    LOCAL(fmpz_poly_q, real);
    LOCAL(fmpz_poly_q, other);
    LOCAL(fmpz, size);
    fmpz_abs(size, n);
    fmpz_poly_q_set(base[0], a);
    fmpz_poly_q_set(base[1], b);
    fmpz_poly_q_one(a);
    fmpz_poly_q_zero(b);
    for (ulong step = 2 * fmpz_bits(size); step-- > 0 && c->status == GRAZE_OK;) {
        int square = step % 2 == 1;
        if (!square && !fmpz_tstbit(size, step / 2))
            continue;
        const fmpz_poly_q_struct *p = square ? a : base[0], *q = square ? b : base[1];
        quotient_mul(c, real, a, p);
        quotient_mul(c, other, b, q);
        quotient_sub(c, real, real, other);
        quotient_mul(c, other, a, q);
        quotient_mul(c, b, b, p);
        quotient_add(c, b, b, other);
        fmpz_poly_q_set(a, real);
    }
    if (fmpz_sgn(n) < 0)
        fmpz_poly_q_neg(b, b);
    fmpz_poly_q_clear(base[1]);
    fmpz_poly_q_clear(base[0]);
}

/* The axis v and its length, which must be a positive rational function on the stretch. */
static graze_status read_axis(fmpz_poly_q_t axis[3], fmpz_poly_q_t length, graze_context *context,
                              const json *value, const stretch *part) {
    graze_status status = entry_vector(axis, context, value, 3, part);
    if (status != GRAZE_OK)
        return status;
    calculation c = {context, GRAZE_OK};
    LOCAL(fmpz_poly_q, norm);
    norm_of(&c, norm, axis, 3);
    status = c.status;
    if (status == GRAZE_OK && !quotient_square_root(length, norm))
        status = json_fail(context, GRAZE_EILLEGAL, value,
                           "the length of the axis is not a rational function of t; choose another "
                           "axis, or use quaternion");
    if (status == GRAZE_OK)
        status = entry_no_root(context, value, fmpz_poly_q_numref(length), part->lo, part->hi,
                               "the axis has length zero (use quaternion if it is to turn there)");
    if (status == GRAZE_OK)
        status = entry_no_root(context, value, fmpz_poly_q_denref(length), part->lo, part->hi,
                               "the axis has a pole");
    if (status == GRAZE_OK) {
        LOCAL(fmpq, start);
        quotient_at(start, length, start);
        if (fmpq_sgn(start) < 0)
            fmpz_poly_q_neg(length, length);
    }
    return status;
}

/* Rotate by twice the angle of a + ib: about `axis` in E^3, where it must be given, and about
 * `center` where it is given. */
static graze_status rotate_about(affine *out, graze_context *context, const json *value,
                                 fmpz_poly_q_t half[2], const json *axis, const json *center,
                                 const stretch *part) {
    int d = part->dimension;
    if (axis != NULL && d == 2)
        return json_fail(context, GRAZE_EINPUT, axis, "a rotation in dimension 2 has no axis");
    if (axis == NULL && d == 3)
        return json_fail(context, GRAZE_EINPUT, value,
                         "a rotation in dimension 3 needs the key axis");
    fmpz_poly_q_t q[4], about[3];
    init4(q);
    LOCAL(fmpz_poly_q, length);
    for (int k = 0; k < 3; k++)
        fmpz_poly_q_init(about[k]);
    fmpz_poly_q_one(length);
    fmpz_poly_q_one(q[3]);
    calculation c = {context, GRAZE_OK};
    if (axis != NULL)
        c.status = read_axis(q + 1, length, context, axis, part);
    quotient_mul(&c, q[0], half[0], length);
    for (int k = 1; k < 4; k++)
        quotient_mul(&c, q[k], q[k], half[1]);
    if (c.status == GRAZE_OK)
        c.status = rotation_of(out, context, value, q, part->lo, part->hi);
    if (c.status == GRAZE_OK && center != NULL) {
        c.status = entry_vector(about, context, center, (size_t)d, part);
        affine_about(&c, out, about);
    }
    for (int k = 0; k < 3; k++)
        fmpz_poly_q_clear(about[k]);
    clear4(q);
    return c.status;
}

graze_status rotation_by_tangent(affine *out, graze_context *context, const json *value,
                                 const stretch *part) {
    static const char *const names[] = {"tan_half", "times", "center", "axis"};
    const json *member[4];
    graze_status status = json_members(member, context, value, names, 4);
    if (status == GRAZE_OK && member[0] == NULL)
        status = json_fail(context, GRAZE_EINPUT, value, "the key tan_half is missing");
    if (status != GRAZE_OK)
        return status;
    calculation c = {context, GRAZE_OK};
    fmpz_poly_q_t half[2];
    LOCAL(fmpz_poly_q, tangent);
    fmpz_poly_q_init(half[0]);
    fmpz_poly_q_init(half[1]);
    LOCAL(fmpz, times);
    fmpz_set_ui(times, 1);
    c.status = entry_function(tangent, context, member[0], part);
    if (c.status == GRAZE_OK && member[1] != NULL)
        c.status = entry_integer(times, context, member[1]);
    if (c.status == GRAZE_OK) {
        fmpz_poly_q_one(half[0]);
        fmpz_poly_q_one(half[1]);
        fmpz_poly_set(fmpz_poly_q_numref(half[0]), fmpz_poly_q_denref(tangent));
        fmpz_poly_set(fmpz_poly_q_numref(half[1]), fmpz_poly_q_numref(tangent));
        complex_power(&c, half[0], half[1], times);
        if (c.status != GRAZE_OK)
            json_at(context, c.status, value);
    }
    if (c.status == GRAZE_OK)
        c.status = rotate_about(out, context, value, half, member[3], member[2], part);
    fmpz_poly_q_clear(half[1]);
    fmpz_poly_q_clear(half[0]);
    return c.status;
}

static graze_status turn_members(const json *member[3], graze_context *context, const json *value) {
    static const char *const names[] = {"quarters", "center", "axis"};
    TRY(json_members(member, context, value, names, 3));
    if (member[0] == NULL)
        return json_fail(context, GRAZE_EINPUT, value, "the key quarters is missing");
    return GRAZE_OK;
}

graze_status rotation_quarters(fmpz_t out, graze_context *context, const json *value) {
    const json *member[3];
    graze_status status = turn_members(member, context, value);
    return status == GRAZE_OK ? entry_integer(out, context, member[0]) : status;
}

/* With v = |n| s, in the part j <= v <= j + 1, the half angle is that of (1 + i)^j (1 + i (v - j)),
 * mirrored where n < 0; four quarters turn it by pi, which is no rotation. */
graze_status rotation_by_quarters(affine *out, graze_context *context, const json *value,
                                  const stretch *part) {
    const json *member[3];
    graze_status status = turn_members(member, context, value);
    fmpz_poly_q_t half[2], other[2];
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    LOCAL_VEC(fmpz, quarters, 2);
    fmpz *done = quarters + 1;
    for (int k = 0; k < 2; k++) {
        fmpz_poly_q_init(half[k]);
        fmpz_poly_q_init(other[k]);
    }
    if (status == GRAZE_OK)
        status = entry_integer(quarters, context, member[0]);
    if (status == GRAZE_OK) {
        int negative = fmpz_sgn(quarters) < 0;
        fmpz_abs(quarters, quarters);
        fmpq_mul_fmpz(low, part->from, quarters);
        fmpq_mul_fmpz(high, part->to, quarters);
        fmpz_fdiv_q(done, fmpq_numref(low), fmpq_denref(low));
        fmpq_sub_fmpz(low, low, done);
        fmpq_sub_fmpz(high, high, done);
        fmpz_poly_q_one(half[0]);
        quotient_set_line(half[1], low, high);
        calculation c = {context, GRAZE_OK};
        for (ulong j = fmpz_fdiv_ui(done, 4); j > 0; j--) {
            quotient_sub(&c, other[0], half[0], half[1]);
            quotient_add(&c, other[1], half[0], half[1]);
            fmpz_poly_q_set(half[0], other[0]);
            fmpz_poly_q_set(half[1], other[1]);
        }
        if (negative)
            fmpz_poly_q_neg(half[1], half[1]);
        status = c.status;
    }
    if (status == GRAZE_OK)
        status = rotate_about(out, context, value, half, member[2], member[1], part);
    for (int k = 0; k < 2; k++) {
        fmpz_poly_q_clear(half[k]);
        fmpz_poly_q_clear(other[k]);
    }
    return status;
}

graze_status rotation_by_quaternion(affine *out, graze_context *context, const json *value,
                                    const stretch *part) {
    if (part->dimension != 3)
        return json_fail(context, GRAZE_EINPUT, value,
                         "quaternion is for dimension 3; use rotate or turn");
    graze_status status = json_array(context, value, 4);
    fmpz_poly_q_t q[4];
    init4(q);
    const json *item = value->first;
    for (int k = 0; k < 4 && status == GRAZE_OK; k++, item = item->next)
        status = entry_function(q[k], context, item, part);
    if (status == GRAZE_OK)
        status = rotation_of(out, context, value, q, part->lo, part->hi);
    clear4(q);
    return status;
}
