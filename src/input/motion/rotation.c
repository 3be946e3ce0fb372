/* Rotations: by the tangent of the half angle, by quarter turns, by a quaternion.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Each rotation becomes a quaternion of any length. Half the angle n 2 atan(p/q) is the argument of
 * the complex number (q + ip)^n = a + ib, so the quaternion of the rotation by this angle about the
 * axis v is (a |v|, b v).
 */
#include "input/motion/affine.h"

#include "base/context/scope.h"

static void norm_of(calculation *c, fmpz_poly_q_t out, fmpz_poly_q_t *v, int count) {
    LOCAL(fmpz_poly_q, square);
    fmpz_poly_q_zero(out);
    for (int k = 0; k < count; k++) {
        quotient_mul(c, square, v[k], v[k]);
        quotient_add(c, out, out, square);
    }
}

/* Multiply the four functions by the least common multiple of their denominators. */
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
    LOCAL_VEC(fmpz_poly, cleared, 4);
    HELD(common_map, turned);
    turned.dimension = out->dimension;
    fmpz_poly_one(turned.v);
    clear_denominators(&c, cleared, q);
    if (c.status == GRAZE_OK)
        c.status = quaternion_rotation(&turned, context, where, cleared, lo, hi);
    common_map_to_affine(&c, out, &turned);
    return c.status;
}

/* (a + ib)^n in place; for n < 0 the conjugate of (a + ib)^|n|, which is (a + ib)^n times a
 * positive factor. The bits of n are taken from the highest down, as in quotient_power. */
static void complex_power(calculation *c, fmpz_poly_q_t a, fmpz_poly_q_t b, const fmpz_t n) {
    LOCAL(fmpz_poly_q, base);
    LOCAL(fmpz_poly_q, turn);
    LOCAL(fmpz_poly_q, real);
    LOCAL(fmpz_poly_q, other);
    LOCAL(fmpz, size);
    fmpz_abs(size, n);
    fmpz_poly_q_set(base, a);
    fmpz_poly_q_set(turn, b);
    fmpz_poly_q_one(a);
    fmpz_poly_q_zero(b);
    for (ulong step = 2 * fmpz_bits(size); step-- > 0 && c->status == GRAZE_OK;) {
        int square = step % 2 == 1;
        if (!square && !fmpz_tstbit(size, step / 2))
            continue;
        const fmpz_poly_q_struct *p = square ? a : base, *q = square ? b : turn;
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
}

/* Read the axis v and its length, which must be a rational function, positive on the stretch. */
static graze_status read_axis(fmpz_poly_q_t axis[3], fmpz_poly_q_t length, graze_context *context,
                              const json *value, const stretch *part) {
    TRY(entry_vector(axis, context, value, 3, part));
    calculation c = {context, GRAZE_OK};
    LOCAL(fmpz_poly_q, norm);
    norm_of(&c, norm, axis, 3);
    TRY(c.status);
    if (!quotient_square_root(length, norm))
        return json_fail(context, GRAZE_EILLEGAL, value,
                         "the length of the axis is not a rational function of t; choose another "
                         "axis, or use quaternion");
    TRY(entry_no_root(context, value, fmpz_poly_q_numref(length), part->lo, part->hi,
                      "the axis has length zero (use quaternion if it is to turn there)"));
    TRY(entry_no_root(context, value, fmpz_poly_q_denref(length), part->lo, part->hi,
                      "the axis has a pole"));
    LOCAL(fmpq, start);
    quotient_at(start, length, start);
    if (fmpq_sgn(start) < 0)
        fmpz_poly_q_neg(length, length);
    return GRAZE_OK;
}

graze_status about_center(affine *out, graze_context *context, const json *center,
                          const stretch *part) {
    HELD(quotients, about);
    calculation c = {context, GRAZE_OK};
    TRY(entry_vector(about.at, context, center, (size_t)part->dimension, part));
    affine_about(&c, out, about.at);
    return c.status;
}

/* Rotate by twice the argument of half[0] + i half[1], about `axis`, which must be given in E^3,
 * and about `center` if it is given, else about the origin. */
static graze_status rotate_about(affine *out, graze_context *context, const json *value,
                                 fmpz_poly_q_t half[2], const json *axis, const json *center,
                                 const stretch *part) {
    int d = part->dimension;
    if (axis != NULL && d == 2)
        return json_fail(context, GRAZE_EINPUT, axis, "a rotation in dimension 2 has no axis");
    if (axis == NULL && d == 3)
        return json_fail(context, GRAZE_EINPUT, value,
                         "a rotation in dimension 3 needs the key axis");
    HELD(quotients, q);
    LOCAL(fmpz_poly_q, length);
    fmpz_poly_q_one(length);
    fmpz_poly_q_one(q.at[3]);
    calculation c = {context, GRAZE_OK};
    if (axis != NULL)
        TRY(read_axis(q.at + 1, length, context, axis, part));
    quotient_mul(&c, q.at[0], half[0], length);
    for (int k = 1; k < 4; k++)
        quotient_mul(&c, q.at[k], q.at[k], half[1]);
    TRY(c.status);
    TRY(rotation_of(out, context, value, q.at, part->lo, part->hi));
    return center != NULL ? about_center(out, context, center, part) : GRAZE_OK;
}

graze_status rotation_by_tangent(affine *out, graze_context *context, const json *value,
                                 const stretch *part) {
    static const char *const names[] = {"tan_half", "times", "center", "axis"};
    const json *member[4];
    TRY(json_members(member, context, value, names, 4));
    if (member[0] == NULL)
        return json_fail(context, GRAZE_EINPUT, value, "the key tan_half is missing");
    calculation c = {context, GRAZE_OK};
    HELD(quotients, half);
    LOCAL(fmpz_poly_q, tangent);
    LOCAL(fmpz, times);
    fmpz_set_ui(times, 1);
    TRY(entry_function(tangent, context, member[0], part));
    if (member[1] != NULL)
        TRY(entry_integer(times, context, member[1]));
    fmpz_poly_q_one(half.at[0]);
    fmpz_poly_q_one(half.at[1]);
    fmpz_poly_set(fmpz_poly_q_numref(half.at[0]), fmpz_poly_q_denref(tangent));
    fmpz_poly_set(fmpz_poly_q_numref(half.at[1]), fmpz_poly_q_numref(tangent));
    complex_power(&c, half.at[0], half.at[1], times);
    TRY(json_at(context, c.status, value));
    return rotate_about(out, context, value, half.at, member[3], member[2], part);
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
    TRY(turn_members(member, context, value));
    return entry_integer(out, context, member[0]);
}

/* With v = |n| s, in the part j <= v <= j + 1, the half angle is that of (1 + i)^j (1 + i (v - j)),
 * negated if n < 0. Four quarters add pi to the half angle, which leaves the rotation as it is. */
graze_status rotation_by_quarters(affine *out, graze_context *context, const json *value,
                                  const stretch *part) {
    const json *member[3];
    TRY(turn_members(member, context, value));
    HELD(quotients, half);
    LOCAL(fmpz_poly_q, difference);
    LOCAL_VEC(fmpq, low, 2);
    fmpq *high = low + 1;
    LOCAL_VEC(fmpz, quarters, 2);
    fmpz *done = quarters + 1;
    TRY(entry_integer(quarters, context, member[0]));
    int negative = fmpz_sgn(quarters) < 0;
    fmpz_abs(quarters, quarters);
    fmpq_mul_fmpz(low, part->from, quarters);
    fmpq_mul_fmpz(high, part->to, quarters);
    fmpz_fdiv_q(done, fmpq_numref(low), fmpq_denref(low));
    fmpq_sub_fmpz(low, low, done);
    fmpq_sub_fmpz(high, high, done);
    fmpz_poly_q_one(half.at[0]);
    quotient_set_line(half.at[1], low, high);
    calculation c = {context, GRAZE_OK};
    for (ulong j = fmpz_fdiv_ui(done, 4); j > 0; j--) {
        quotient_sub(&c, difference, half.at[0], half.at[1]);
        quotient_add(&c, half.at[1], half.at[0], half.at[1]);
        fmpz_poly_q_set(half.at[0], difference);
    }
    if (negative)
        fmpz_poly_q_neg(half.at[1], half.at[1]);
    TRY(c.status);
    return rotate_about(out, context, value, half.at, member[2], member[1], part);
}

graze_status rotation_by_quaternion(affine *out, graze_context *context, const json *value,
                                    const stretch *part) {
    if (part->dimension != 3)
        return json_fail(context, GRAZE_EINPUT, value,
                         "quaternion is for dimension 3; use rotate or turn");
    TRY(json_array(context, value, 4));
    HELD(quotients, q);
    const json *item = value->first;
    for (int k = 0; k < 4; k++, item = item->next)
        TRY(entry_function(q.at[k], context, item, part));
    return rotation_of(out, context, value, q.at, part->lo, part->hi);
}
