/* Rotations of a tool's axis, and of angles.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The least rotation from e = (0, 0, 1) to the direction of a = (i, j, k), |a| = L, turns about
 * e x a = (-j, i, 0) and has the quaternion (L + k, -j, i, 0). With a number near L in its place
 * the rotation turns e to a unit vector u near a / L, both in the plane of e and a, so the two
 * rotations differ by the angle d between u and a. sin d = |u x a| / L, and for d < 90 degrees
 * d <= (pi / 2) sin d, thus d^2 <= (5/2) |u x a|^2 / L^2, a rational number.
 */
#include "input/convert/angle.h"

#include <math.h>
#include "base/context/scope.h"
#include "base/number/rounding.h"
#include "base/number/vector.h"
#include "input/convert/poses_list.h"

enum { BITS_LEAST = 32 }; /* of angles */

static const angle_order orders[] = {{"kuka", {"A", "B", "C"}, {2, 1, 0}, 0, 0},
                                     {"fanuc", {"R", "P", "W"}, {2, 1, 0}, 0, 0},
                                     {"staubli", {"RX", "RY", "RZ"}, {0, 1, 2}, 0, 0},
                                     {"kawasaki", {"O", "A", "T"}, {2, 1, 2}, 0, 0},
                                     {"cnc", {"C", "B", "A"}, {2, 1, 0}, 1, 0},
                                     {"rpy", {"yaw", "pitch", "roll"}, {2, 1, 0}, 0, 0},
                                     {"theta", {"theta", "theta", "theta"}, {2, 1, 0}, 1, 1}};
enum { ORDERS = sizeof orders / sizeof *orders };

const angle_order *angle_order_of(const char *machine) {
    for (int k = 0; k < ORDERS; k++)
        if (strcmp(machine, orders[k].machine) == 0)
            return orders + k;
    return NULL;
}

/* out = out (w + c e), e the unit vector of an axis. */
static void turn_on(fmpq *out, const half_angle *h, int axis) {
    LOCAL_VEC(fmpq, made, 4);
    int a = 1 + axis, b = 1 + (axis + 1) % 3, c = 1 + (axis + 2) % 3;
    /* 1 e = e, e e = -1, e_b e_a = -e_c, e_c e_a = e_b */
    fmpq_mul(made + a, out, h->c);
    fmpq_mul(made, out + a, h->c);
    fmpq_neg(made, made);
    fmpq_mul(made + c, out + b, h->c);
    fmpq_neg(made + c, made + c);
    fmpq_mul(made + b, out + c, h->c);
    for (int k = 0; k < 4; k++) {
        fmpq_addmul(made + k, out + k, h->w);
        fmpq_swap(out + k, made + k);
    }
}

/* Divide a quarter of an angle by pi. Three roundings change the angle by less than itself times
 * 2^(2 - ANGLE_BITS), which is added to `error`. */
static void divide_by_pi(fmpq_t f, mpfr_t error) {
    LOCAL_MPFR(value, ANGLE_BITS);
    LOCAL_MPFR(pi, ANGLE_BITS);
    rational_to_mpfr(value, f, MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_div(value, value, pi, MPFR_RNDN);
    mpfr_to_rational(f, value);
    mpfr_abs(value, value, MPFR_RNDU);
    mpfr_mul_2si(value, value, 6 - ANGLE_BITS, MPFR_RNDU);
    mpfr_add(error, error, value, MPFR_RNDU);
}

/* Replace three angles by their quaternion, a product of three turns whose half angles are dyadic
 * pairs near the given ones, and find an upper bound of the angle between both rotations, radians,
 * about 2^-bits: the sum of the errors of the turns. */
static void angles_rotation(fmpq *angles, mpfr_t error, const angle_order *order, slong bits) {
    LOCAL_VEC(fmpq, product, 4);
    LOCAL_VEC(fmpq, f, 2);
    fmpq *one = f + 1;
    HELD(half_angle, h);
    LOCAL_MPFR(part, ANGLE_BITS);
    mpfr_set_zero(error, 1);
    fmpq_one(one);
    fmpq_one(product);
    for (int k = 0; k < 3; k++) {
        divide_by(f, angles + k, order->radians ? 4 : 720);
        if (order->radians)
            divide_by_pi(f, error);
        half_angle_dyadic(&h, f, one, bits);
        half_angle_error(part, &h, f, one);
        mpfr_add(error, error, part, MPFR_RNDU);
        turn_on(product, &h, order->axis[k]);
    }
    vector_set(angles, product, 4);
}

int pose_along(const pose *p) {
    LOCAL(fmpq, along);
    _fmpq_vec_dot(along, p[-1].quaternion, p->quaternion, 4);
    return fmpq_sgn(along);
}

void pose_negate(pose *p) {
    for (int k = 0; k < 4; k++)
        fmpq_neg(p->quaternion + k, p->quaternion + k);
}

/* An upper bound of the angle between the rotation of q = (w, -j, i, 0), which turns e to u = (2 w
 * i, 2 w j, w^2 - i^2 - j^2) / |q|^2, and the least rotation to the axis. */
static void axis_error(mpfr_t out, const fmpq_t w, const fmpq *a, const fmpq_t square) {
    LOCAL_VEC(fmpq, u, 3);
    LOCAL_VEC(fmpq, product, 3);
    LOCAL_VEC(fmpq, norm, 3);
    fmpq *cross = norm + 1, *sum = norm + 2;
    _fmpq_vec_dot(norm, a, a, 2);
    fmpq_mul(u + 2, w, w);
    fmpq_sub(cross, u + 2, norm);
    fmpq_add(norm, u + 2, norm);
    fmpq_set(u + 2, cross);
    for (int k = 0; k < 2; k++) {
        fmpq_mul(u + k, w, a + k);
        fmpq_add(u + k, u + k, u + k);
    }
    vector_cross(product, u, a);
    _fmpq_vec_dot(sum, product, product, 3);
    fmpq_div(sum, sum, norm);
    fmpq_div(sum, sum, norm);
    fmpq_div(sum, sum, square);
    fmpq_set_si(cross, 5, 2);
    fmpq_mul(sum, sum, cross);
    root_above(out, sum);
    _fmpq_vec_dot(cross, u, a, 3);
    if (fmpq_sgn(cross) <= 0) /* d is 90 degrees or more; 4 is above every angle */
        mpfr_set_ui(out, 4, MPFR_RNDU);
}

/* Find the quaternion (L + k, -j, i, 0). For k < 0, L + k is computed as (i^2 + j^2) / (L - k),
 * which loses no digits. */
static graze_status axis_rotation(mpfr_t error, graze_context *context, const pose_list *list,
                                  pose *p) {
    LOCAL_VEC(fmpq, a, 3);
    LOCAL_VEC(fmpq, square, 3);
    fmpq *across = square + 1, *w = square + 2;
    for (int k = 0; k < 3; k++)
        fmpq_swap(a + k, p->quaternion + k);
    _fmpq_vec_dot(square, a, a, 3);
    _fmpq_vec_dot(across, a, a, 2);
    if (fmpq_is_zero(across) && fmpq_sgn(a + 2) <= 0)
        return context_fail_in(
            context, GRAZE_EINPUT, list->source, p->line, "the tool's axis is %s",
            fmpq_is_zero(square) ? "zero; expected a direction"
                                 : "opposite to (0, 0, 1), to which no rotation is the least; "
                                   "expected another direction");
    if (!rational_root(w, square))
        TRY(rational_from_double(w, context, sqrt(fmpq_get_d(square))));
    if (fmpq_sgn(a + 2) >= 0) {
        fmpq_add(w, w, a + 2);
    } else {
        fmpq_sub(w, w, a + 2);
        fmpq_div(w, across, w);
    }
    axis_error(error, w, a, square);
    fmpq_set(p->quaternion, w);
    fmpq_neg(p->quaternion + 1, a + 1);
    fmpq_set(p->quaternion + 2, a);
    fmpq_zero(p->quaternion + 3);
    return GRAZE_OK;
}

slong bits_within(const fmpq_t tolerance) {
    double size = fmpq_get_d(tolerance);
    int exponent = 0;
    frexp(size, &exponent);
    slong bits = size > 0 ? 4 - (slong)exponent : ANGLE_FINEST;
    return bits < BITS_LEAST ? BITS_LEAST : bits < ANGLE_FINEST ? bits : ANGLE_FINEST;
}

static void report_turned(text *t, const pose_list *list, const angle_order *order,
                          const mpfr_t worst) {
    if (list->form == POSES_OF_AXES)
        text_put(t, "axes: each rotation is the least one from (0, 0, 1) to the tool's axis");
    else if (order->radians)
        text_put(t, "angles: in radians, about z");
    else
        text_format(t,
                    "angles: in degrees, in the order of %s: about fixed axes, first %s about %c, "
                    "then %s about %c, then %s about %c",
                    order->machine, order->name[2], "xyz"[order->axis[2]], order -> name[1],
                    "xyz"[order->axis[1]], order -> name[0], "xyz"[order->axis[0]]);
    put_fact(t, ", off by", worst, "radians");
}

graze_status poses_turn(text *report, graze_context *context, pose_list *list,
                        const angle_order *order, const fmpq_t tolerance) {
    char digits[DIGITS_ROOM];
    slong bits = bits_within(tolerance);
    LOCAL_MPFR(error, ANGLE_BITS);
    LOCAL_MPFR(worst, ANGLE_BITS);
    mpfr_set_zero(worst, 1);
    for (size_t i = 0; i < list->count; i++) {
        pose *p = list->item + i;
        if (list->form == POSES_OF_AXES)
            TRY(axis_rotation(error, context, list, p));
        else
            angles_rotation(p->quaternion, error, order, bits);
        if (bound_exceeds(error, tolerance))
            return context_fail_in(context, GRAZE_EINPUT, list->source, p->line,
                                   "the rotation is up to %s radians off the one asked for; "
                                   "expected a larger tolerance",
                                   bound_digits(digits, error));
        if (i && pose_along(p) < 0)
            pose_negate(p);
        mpfr_max(worst, worst, error, MPFR_RNDU);
        if (i % 256 == 0)
            TRY(context_poll(context));
    }
    report_turned(report, list, order, worst);
    return GRAZE_OK;
}
