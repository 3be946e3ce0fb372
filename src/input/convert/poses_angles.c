/* Rotations by three angles: the product of three turns whose half angles are dyadic pairs near the
 * given ones. The errors of the three turns add up.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/convert/convert.h"

#include <flint/fmpq_vec.h>
#include <string.h>
#include "base/context/scope.h"
#include "input/convert/angle.h"
#include "input/convert/poses_list.h"

static const angle_order orders[] = {
    {"kuka", {"A", "B", "C"}, {2, 1, 0}, 0},       {"fanuc", {"R", "P", "W"}, {2, 1, 0}, 0},
    {"staubli", {"RX", "RY", "RZ"}, {0, 1, 2}, 0}, {"kawasaki", {"O", "A", "T"}, {2, 1, 2}, 0},
    {"cnc", {"C", "B", "A"}, {2, 1, 0}, 1},        {"rpy", {"yaw", "pitch", "roll"}, {2, 1, 0}, 0}};
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

void angles_rotation(fmpq *quaternion, mpfr_t error, const angle_order *order, const fmpq *degrees,
                     slong bits) {
    LOCAL_VEC(fmpq, product, 4);
    LOCAL_VEC(fmpq, f, 2);
    fmpq *one = f + 1;
    HELD(half_angle, h);
    LOCAL_MPFR(part, ANGLE_BITS);
    mpfr_set_zero(error, 1);
    fmpq_one(one);
    fmpq_one(product);
    for (int k = 0; k < 3; k++) {
        fmpz_set_ui(fmpq_denref(f), 720);
        fmpz_one(fmpq_numref(f));
        fmpq_canonicalise(f);
        fmpq_mul(f, f, degrees + k);
        half_angle_dyadic(&h, f, one, bits);
        half_angle_error(part, &h, f, one);
        mpfr_add(error, error, part, MPFR_RNDU);
        turn_on(product, &h, order->axis[k]);
    }
    for (int k = 0; k < 4; k++)
        fmpq_swap(quaternion + k, product + k);
}
