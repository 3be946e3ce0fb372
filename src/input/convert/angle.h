/* Angles and joints in exact numbers near given ones.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef GRAZE_INPUT_CONVERT_ANGLE_H
#define GRAZE_INPUT_CONVERT_ANGLE_H

#include <mpfr.h>
#include "input/convert/convert.h"

/* Half angles as exact pairs (w, c), and proved bounds on their distance from the angles wanted.
 *
 * A rotation about the axis v of length L by the angle a has the quaternion (w, c v) for every
 * pair with w + i c L a positive multiple of exp(i a/2). A wanted angle a is given by an exact
 * fraction f: a/2 = 2 pi f. MPFR's results err by at most half a unit in the
 * last of ANGLE_BITS bits; a chain of at most eight operations on numbers up to 8 in size is off
 * by less than ANGLE_SLACK = 2^-300, which is added to every bound; all further steps round up. */

enum { ANGLE_BITS = 320, ANGLE_SLACK = 300, ANGLE_FINEST = 256 };

/** The pair (w, c). Functions take with it `square`, the exact square of the axis's length L > 0.
 */
typedef struct half_angle {
    fmpq_t w, c;
} half_angle;

void half_angle_init(half_angle *h);
void half_angle_clear(half_angle *h);

/** The pair on the dyadic grid: w + i c L is within 2^-bits of exp(2 pi i f). bits <= ANGLE_FINEST.
 */
void half_angle_dyadic(half_angle *out, const fmpq_t f, const fmpq_t square, slong bits);

/**
 * Set w = 1 and c to the first convergent of the continued fraction of tan(2 pi f) / L for which
 * the bound of half_angle_error is at most `tolerance` (radians, at least 2^-ANGLE_FINEST). |f| <=
 * 1/8.
 */
void half_angle_convergent(half_angle *out, const fmpq_t f, const fmpq_t square,
                           const fmpq_t tolerance);

/** An upper bound of |2 arg(w + i c L) - 4 pi f| modulo whole turns of the half angle, radians;
 * 0 where both angles are 0. */
void half_angle_error(mpfr_t out, const half_angle *h, const fmpq_t f, const fmpq_t square);

/** An upper bound of the angle, less than 180 degrees, between the numbers w + i c L of two pairs;
 * the bound exceeds the angle by at most 2^(1 - ANGLE_SLACK). */
void half_angle_apart(mpfr_t out, const half_angle *from, const half_angle *to,
                      const fmpq_t square);

/**
 * An upper bound, radians, of how far the angle 2 arg((1 - s) z0 + s z1), s in [0, 1], strays from
 * the uniform 2 ((1 - s) arg z0 + s arg z1), where z = w + i c L. angle_sway: for z0 and z1 of
 * equal length and with the angle `apart` between them; half_angle_sway: for any two pairs. Proofs
 * stand in angle.c.
 */
void angle_sway(mpfr_t out, const mpfr_t apart);
void half_angle_sway(mpfr_t out, const half_angle *from, const half_angle *to, const fmpq_t square);

/** The multiple of 2^-bits nearest to a number, ties to even. */
void round_to_grid(fmpq_t out, const mpfr_t value, slong bits);

/** Round a rational number to an MPFR number. */
void rational_to_mpfr(mpfr_t out, const fmpq_t value, mpfr_rnd_t round);

/** Set `out` to the exact value of an MPFR number. */
void mpfr_to_rational(fmpq_t out, const mpfr_t value);

/** Is a bound greater than a rational number? */
int bound_exceeds(const mpfr_t bound, const fmpq_t most);

/** An upper bound of the square root of a number that is not negative. */
void root_above(mpfr_t out, const fmpq_t square);
/** Set `out` to the square root of a number that is not negative, if that is rational, and return
 * 1; else return 0. */
int rational_root(fmpq_t out, const fmpq_t square);

/* Helpers for joints, and for the lines of a report. */

/** Set out = value / divisor; the divisor is not 0. */
void divide_by(fmpq_t out, const fmpq_t value, ulong divisor);

/** Write a joint's center, if it has one. */
void put_center(json_writer *w, const joint *j, int dimension);
/** Write a bound, rounded up to three digits; returns `out`. */
enum { DIGITS_ROOM = 64 };
const char *bound_digits(char out[DIGITS_ROOM], const mpfr_t bound);
/** Write a name and a value of the report: one line. */
void put_fact(text *t, const char *name, const mpfr_t bound, const char *unit);
/** put_fact for a rational without a unit. */
void put_rational_fact(text *t, const char *name, const fmpq_t bound);

/**
 * Set the bits a pair needs for an angle whose error moves no point by more than 1/8 of a joint's
 * share of the tolerance, the tolerance / `count`.
 * @return GRAZE_EUSE the tolerance asks for more than ANGLE_FINEST bits
 */
graze_status joint_bits(joint *j, graze_context *context, const target *goal, size_t count);

/* Decides whether two polyhedra hold a tool between them. */

/**
 * Decide exactly whether the inner polyhedron is a convex part of the body, the body is a part of
 * the outer one, which is convex too, and no corner is further than `tolerance` from the corner of
 * the same number of the other polyhedron: then each polyhedron is within `tolerance` of the body
 * (proof in tool_check.c).
 * @param[out] square the largest squared distance of corners of one number
 */
int tool_pair_holds(fmpq_t square, const tool_pair *p, const tool *s, const fmpq_t tolerance);

#endif
