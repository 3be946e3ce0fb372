/* Velocities of all points of the body at one time.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_ENVELOPE_SNAPSHOT_H
#define GRAZE_ENVELOPE_SNAPSHOT_H

#include "questions/envelope/envelope_record.h"

/** c' and c'' of the trajectory through y are matrices of d rows and d + 1 columns applied to (y,
 * 1), times positive numbers. */
typedef struct snapshot {
    const graze_envelope *e;
    int dimension;
    fmpq_t t;
    fmpq *velocity, *bend;
} snapshot;

/** @param[out] out uninitialised; snapshot_clear in any case
 * @return GRAZE_EINPUT the time is not within the motion, or is a break of it */
graze_status snapshot_make(snapshot *out, graze_context *context, const graze_envelope *e,
                           const fmpq_t t);
void snapshot_clear(snapshot *s);

/** g of a facet at a point of the body times a positive number, the same for all points. */
void snapshot_g(fmpq_t out, const snapshot *s, size_t facet, const fmpq *y);
int snapshot_g_sign(const snapshot *s, size_t facet, const fmpq *y);
/** The sign of theta. */
int snapshot_theta_sign(const snapshot *s, size_t facet, const fmpq *y);

/** Where a function that is `a` at p and `b` at q, of different signs, vanishes between them. */
void snapshot_zero(fmpq *out, const fmpq_t a, const fmpq_t b, const fmpq *p, const fmpq *q, int d);

#endif
