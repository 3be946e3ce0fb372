/* Times of contact.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_TRACE_TIME_H
#define GRAZE_TRACE_TIME_H

#include "base/number/algebraic.h"
#include "input/motion/motion.h"

/**
 * A time of the motion: piece `piece`, local parameter u in [0, 1]. In the motion's parameter it is
 * lo + (hi - lo) u. `poly`, `low`, `high` are its canonical form there, made once when the time is
 * needed: minimal polynomial, and the widest isolating dyadic interval (both ends the value
 * itself when it is rational).
 */
struct graze_time {
    size_t piece;
    algebraic u;
    const graze_motion *motion;
    int canonical; /* 0 until poly, low, high are made */
    fmpz_poly_t poly;
    fmpq_t low, high;
};

/** Make a time of a piece, not yet canonical; NULL if memory runs out. */
graze_time *time_create(const graze_motion *motion, size_t piece, const algebraic *u);
/** NULL is harmless. */
void time_destroy(graze_time *time);

/** Is a time t0; the end of its piece; t1? NULL is none of these. */
int time_is_start(const graze_time *time);
int time_is_piece_end(const graze_time *time);
int time_is_end(const graze_time *time);

/** The first piece that has the time, counting its ends: the end of a piece and the start of the
 * next one are one time. */
size_t time_first_piece(const graze_time *time);

/** A rational time u of a piece strictly between two times, one after the other. */
graze_status time_between(size_t *piece, fmpq_t u, graze_context *context, graze_time *before,
                          graze_time *after);

/** Make the canonical form of a time; idempotent. The context may be NULL: then there is no limit.
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED */
graze_status time_canonicalise(graze_time *time, graze_context *context);

/** time_canonicalise for many times of one motion, which are reordered: roots of one polynomial
 * share its factorisation. */
graze_status times_canonicalise(graze_time **time, size_t count, graze_context *context);

#endif
