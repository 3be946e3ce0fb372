/* Joints as the caller gives them, made ready: exact numbers, the axis's length, how far points
 * are.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONVERT_JOINT_H
#define GRAZE_CONVERT_JOINT_H

#include "base/number/text.h"
#include "input/convert/angle.h"

/** One joint of a chain. */
typedef struct joint {
    int is_slide;
    fmpq_t degrees; /* of the whole motion; 0 for a slide */
    fmpq_t advance; /* along the axis, in the unit of the coordinates, of the whole motion */
    fmpq axis[3];   /* not zero; (0, 0, 1) in the plane; a slide: the whole way */
    fmpq center[3];
    int centered;  /* center is not the origin */
    fmpq_t square; /* of the axis's length */
    fmpq_t length; /* the length, where it is rational, else 0 */
    mpfr_t reach;  /* no point is further from the axis, upwards */
} joint;

/** Tolerance of an approximation, and the points that it holds for. */
typedef struct target {
    int dimension;
    fmpq_t tolerance; /* positive; in the unit of the coordinates */
    fmpq_t radius;    /* not negative; points at most that far from the origin before the motion */
} target;

void joint_init(joint *j);
void joint_clear(joint *j);

/**
 * Complete joints whose degrees, axis and center are set and whose `advance` is the pitch, for 360
 * degrees; the first is applied first. The motion of every joint keeps distances, so a point within
 * r of the origin stays within r + 2 e of it under a turn about an axis at distance e, is never
 * further than r + e from that axis, and stays within r plus the way under a slide.
 * @return GRAZE_EUSE an axis of length zero
 */
graze_status joints_measure(joint *joints, graze_context *context, const target *goal,
                            size_t count);

/** out = value / divisor, not 0. */
void divide_by(fmpq_t out, const fmpq_t value, ulong divisor);

/** Write a vector as JSON strings in brackets: `d` rationals. */
void put_vector(text *t, const fmpq *v, int d);
/** Write `, "center": [...]` if there is one. */
void put_center(text *t, const joint *j, int dimension);
/** Write a bound, rounded up to three digits. */
void put_bound(text *t, const mpfr_t bound);
/** Write a name and a value of the report: one line. */
void put_fact(text *t, const char *name, const mpfr_t bound, const char *unit);
/** put_fact for a rational without a unit. */
void put_rational_fact(text *t, const char *name, const fmpq_t bound);

/**
 * The bits a pair needs for an angle whose error moves no point by more than 1/8 of the tolerance,
 * shared by `count` joints.
 * @return GRAZE_EUSE the tolerance asks for more than ANGLE_FINEST bits
 */
graze_status joint_bits(slong *bits, graze_context *context, const joint *j, const target *goal,
                        size_t count);

#endif
