/* Derivatives of the trajectory through a body point at a rational time, from those of the motion.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_CONTACT_FLOW_H
#define GRAZE_CONTACT_FLOW_H

#include "input/motion/motion.h"

/**
 * For M = A x + b and a body point y, by the motion's parameter t: with V = A'y + b', `w` is
 * -A^-1 V, which is c' of the trajectory c of M(t) y, `bend` is c'', and `drift` is the derivative
 * of A^-1 V at fixed y. d rationals each. `orientation` is the sign of det A.
 */
typedef struct flow {
    int dimension, orientation;
    fmpq *w, *bend, *drift;
} flow;

/** At the parameter u of a piece (proofs/envelope.md C58). flow_clear in any case. */
void flow_make(flow *out, const motion_piece *piece, const fmpq_t u, const fmpq *y);
void flow_clear(flow *f);

/** The inner product of an integer normal and one of the vectors. */
void flow_along(fmpq_t out, const fmpz *normal, const fmpq *vector, int dimension);

#endif
