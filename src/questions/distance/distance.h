/* The distance of a point to the sweep or unsweep, enclosed (proofs/semantics.md 8).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef GRAZE_DISTANCE_DISTANCE_H
#define GRAZE_DISTANCE_DISTANCE_H

#include "decide/trace/trace.h"

/** low <= s <= high, with the sign of the point's exact answer (proofs/distance.md C66, C67). */
typedef struct distance {
    double low, high;
    int wide;     /* high - low is more than was asked for */
    size_t piece; /* a time at which the solid is as near as the bound says: the piece's */
    double from, length, v; /* parameter from + length v, exactly, or */
    const graze_time *at; /* a contact, borrowed from the trace: the first of an `on` point, or one
                             at the end of a visit in which no double is certain to lie */
} distance;

/**
 * @param point     d rationals
 * @param trace     of the point, with its contacts' times
 * @param tolerance positive and finite: the width that is wanted
 * @return GRAZE_ELIMIT, GRAZE_ECANCELED, GRAZE_ESYSTEM
 */
graze_status distance_find(distance *out, graze_context *context, const graze_scene *scene,
                           const fmpq *point, const graze_trace *trace, double tolerance);

/** 1 if every motion within the error has the same answer (proofs/distance.md C73). */
int distance_is_certain(const distance *found, double motion_error);

/** The time of a distance of an `in` or `out` point, in the motion's parameter. */
void distance_time(fmpq_t out, const distance *found, const graze_motion *motion);

/** A rational near a contact's time: the time itself if it is rational, else within 2^-60 of a
 * piece's length of it. */
graze_status distance_contact_time(fmpq_t out, graze_context *context, const graze_time *time);

/** The double nearest to the time of a distance, of an `on` point too, in the motion's parameter.
 */
graze_status distance_time_near(double *out, graze_context *context, const distance *found,
                                const graze_motion *motion);

#endif
