/* A curved solid in doubles: whether a place is in it, and which way its boundary looks.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * For the eye alone: what is made with it decides nothing.
 */
#ifndef GRAZE_DRAW_EYE_FIELD_H
#define GRAZE_DRAW_EYE_FIELD_H

#include "input/csg/csg.h"

/** The expression, prepared to be asked at places; one thread at a time. The solid is borrowed. */
typedef struct eye_field {
    const csg *solid;
    double *coefficient; /* of all surfaces, one after another */
    signed char *sign, *other;
    uint64_t *truth;
} eye_field;

/** Prepare a field. Cleared by eye_field_clear, also on failure. */
graze_status eye_field_make(eye_field *out, graze_context *context, const csg *solid);
void eye_field_clear(eye_field *field);

/** Does the expression hold at a place? `at` has a coordinate for each dimension of the solid. */
int eye_field_holds(eye_field *field, const double *at);

/** The unit normal of the boundary between two near places, one of them in the solid: that of the
 * first surface between them, 0 if there is none. It points from `from` to `to`.
 * @param step a length that is small beside the picture's details */
void eye_field_normal(double out[3], eye_field *field, const double *from, const double *to,
                      double step);

#endif
