/* Rotations as three angles about coordinate axes, in the order of a machine.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_POSES_ANGLES_H
#define GRAZE_CONVERT_POSES_ANGLES_H

#include <flint/fmpq.h>
#include <mpfr.h>

/** The rotation is that about axis[2] first, then axis[1], then axis[0], all of them standing. */
typedef struct angle_order {
    const char *machine;
    const char *name[3]; /* of the columns, the first of axis[0] */
    int axis[3];         /* 0: x, 1: y, 2: z */
    int may_miss;        /* columns may be left out: their angles are 0 */
} angle_order;

/** The order of that name, or NULL; GRAZE_EINPUT is for the caller to say. */
const angle_order *angle_order_of(const char *machine);

/**
 * The quaternion of three angles in degrees, and how far its rotation is from theirs.
 * @param[out] quaternion w, x, y, z, of any length; may be `degrees` too
 * @param[out] error      an upper bound of the angle between both rotations, radians, of
 *                        ANGLE_BITS; about 2^-bits
 */
void angles_rotation(fmpq *quaternion, mpfr_t error, const angle_order *order, const fmpq *degrees,
                     slong bits);

#endif
